#include "fill/polygon.h"

#include <gtest/gtest.h>

#include <random>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

PolygonQuery any(const Sides &sides, int singularities) {
    const int perimeter = std::accumulate(sides.begin(), sides.end(), 0);
    PolygonQuery query;
    query.sides = sides;
    query.singularities = singularities;
    query.fewest_faces = 1;
    query.most_faces = perimeter * perimeter;
    query.faces = std::max(1, perimeter * perimeter / 16);
    query.effort = 4;
    query.enough = 2;
    return query;
}

// Builds the template and compares it with its promises.
void expect_delivers(const Template &chosen, const Sides &sides, int singularities) {
    EXPECT_EQ(chosen.singularities, singularities);
    const oracle::Disk disk = oracle::inspect(build(chosen, sides));
    EXPECT_EQ(disk.fault, "") << testing::PrintToString(sides);
    EXPECT_EQ(disk.word, oracle::polygon(sides)); // side lengths, too
    EXPECT_EQ(disk.v3 + disk.v5, singularities) << testing::PrintToString(sides);
    EXPECT_EQ(disk.other, 0);
    EXPECT_EQ(disk.faces, chosen.faces);
}

// The least number of singularities, and a filling that has it.
void expect_least(const Sides &sides) {
    const int least = oracle::table(sides), n = static_cast<int>(sides.size());
    ASSERT_EQ(least_singularities(sides), least) << testing::PrintToString(sides);
    const auto found = solve(any(sides, least), 2);
    ASSERT_FALSE(found.empty()) << testing::PrintToString(sides);
    for (const Template &chosen : found)
        expect_delivers(chosen, sides, least);
    for (int k = std::abs(n - 4); k < least; k += 2)
        ASSERT_TRUE(solve(any(sides, k), 1).empty()) << testing::PrintToString(sides);
}

// All classes when the campaign is on, else a fixed sample of them.
void campaign(int corners, std::size_t sample) {
    std::vector<Sides> all = oracle::polygons(corners, 3, 10);
#ifndef ALPHAMST_FULL_CAMPAIGN
    std::mt19937 random(6);
    for (std::size_t i = 0; i < sample && i < all.size(); ++i)
        std::swap(all[i], all[i + random() % (all.size() - i)]);
    if (all.size() > sample)
        all.resize(sample);
#else
    static_cast<void>(sample);
#endif
    std::mt19937 turns(7);
    for (Sides sides : all) {
        const auto turn = static_cast<std::ptrdiff_t>(turns() % sides.size());
        std::rotate(sides.begin(), sides.begin() + turn, sides.end());
        if (turns() % 2 == 0)
            std::reverse(sides.begin(), sides.end());
        expect_least(sides);
        if (testing::Test::HasFatalFailure())
            return;
    }
}

// As far as the brute force gets. It looks at fillings up to a share of the squared perimeter, well
// above the largest ones known (one singularity in a triangle: 1/12).
TEST(Polygon, TableIsTheBruteForce) {
    struct Range {
        int corners, longest, perimeter;
        double faces;
        std::set<int> least; // all the answers there are
    };
#ifdef ALPHAMST_FULL_CAMPAIGN
    const std::vector<Range> ranges{{3, 12, 30, 0.15, {1, 3}},
                                    {4, 9, 24, 0.12, {0, 2, 4}},
                                    {5, 8, 22, 0.12, {1, 3, 5}},
                                    {6, 9, 24, 0.1, {2, 4, 6}}};
#else
    const std::vector<Range> ranges{{3, 9, 18, 0.15, {1, 3}},
                                    {4, 9, 16, 0.12, {0, 2, 4}},
                                    {5, 6, 18, 0.12, {1, 3}},
                                    {6, 5, 20, 0.1, {2}}};
    for (const Sides &sides : {Sides{3, 3, 3, 3, 8}, Sides{3, 3, 3, 4, 7}, Sides{3, 3, 3, 3, 3, 7}}) {
        const auto perimeter = static_cast<int>(oracle::polygon(sides).size());
        EXPECT_EQ(oracle::table(sides), oracle::least(oracle::polygon(sides), 6, perimeter * perimeter / 9));
    }
#endif
    for (const Range &range : ranges) {
        std::set<int> seen;
        for (const Sides &sides : oracle::polygons(range.corners, 3, range.longest)) {
            const int perimeter = std::accumulate(sides.begin(), sides.end(), 0);
            if (perimeter > range.perimeter)
                continue;
            const int most = static_cast<int>(range.faces * perimeter * perimeter);
            const int least = oracle::least(oracle::polygon(sides), 6, most);
            EXPECT_EQ(oracle::table(sides), least) << testing::PrintToString(sides);
            seen.insert(least);
        }
        EXPECT_EQ(seen, range.least) << range.corners;
    }
}

TEST(Polygon, LeastSingularitiesIsTheTableForAllSides) {
    for (int corners = 3; corners <= 6; ++corners)
        for (const Sides &sides : oracle::polygons(corners, 3, 10))
            ASSERT_EQ(least_singularities(sides), oracle::table(sides)) << testing::PrintToString(sides);
    EXPECT_EQ(least_singularities({3, 4, 4}), -1);
}

TEST(Polygon, TrianglesHaveTheLeastSingularities) { campaign(3, 1u << 20); }
TEST(Polygon, QuadranglesHaveTheLeastSingularities) { campaign(4, 1u << 20); }
TEST(Polygon, PentagonsHaveTheLeastSingularities) { campaign(5, 1u << 20); }
TEST(Polygon, HexagonsHaveTheLeastSingularities) { campaign(6, 1500); }

TEST(Polygon, OneAndTwoSides) {
    for (int n = 6; n <= 20; n += 2) {
        const auto found = solve(any({n}, 3), 3);
        ASSERT_FALSE(found.empty()) << n;
        for (const Template &chosen : found)
            expect_delivers(chosen, {n}, 3);
    }
    for (int n0 = 3; n0 <= 10; ++n0)
        for (int n1 = 3 + (n0 + 1) % 2; n1 <= 10; n1 += 2) {
            const auto found = solve(any({n0, n1}, 2), 3);
            ASSERT_FALSE(found.empty()) << n0 << " " << n1;
            for (const Template &chosen : found)
                expect_delivers(chosen, {n0, n1}, 2);
        }
    EXPECT_TRUE(solve(any({2, 4}, 2), 1).empty());
}

TEST(Polygon, ThinSides) {
    for (const Sides &sides : oracle::polygons(4, 1, 6)) {
        const int total = std::accumulate(sides.begin(), sides.end(), 0);
        const int longest = *std::max_element(sides.begin(), sides.end());
        const bool rectangle = sides[0] == sides[2] && sides[1] == sides[3];
        const bool two = *std::min_element(sides.begin(), sides.end()) >= 2 && 2 * longest <= total - 4;
        if (!rectangle && !two)
            continue;
        const auto found = solve(any(sides, rectangle ? 0 : 2), 2);
        ASSERT_FALSE(found.empty()) << testing::PrintToString(sides);
        for (const Template &chosen : found)
            expect_delivers(chosen, sides, rectangle ? 0 : 2);
    }
    for (const int n : {3, 5})
        for (const Sides &sides : oracle::polygons(n, 2, 5)) {
            const auto found = solve(any(sides, 1), 2);
            EXPECT_EQ(!found.empty(), spokes(sides).has_value()) << testing::PrintToString(sides);
            for (const Template &chosen : found) {
                expect_delivers(chosen, sides, 1);
                EXPECT_EQ(chosen.faces, spoke_faces(*spokes(sides)));
            }
        }
}

TEST(Polygon, MoreSingularitiesThanTheLeast) {
    std::mt19937 random(8);
    int built = 0;
    for (int round = 0; round < 150; ++round) {
        const int n = 3 + static_cast<int>(random() % 4);
        Sides sides;
        for (int i = 0; i < n; ++i)
            sides.push_back(3 + static_cast<int>(random() % 8));
        if (std::accumulate(sides.begin(), sides.end(), 0) % 2 != 0)
            ++sides[0];
        for (int k = oracle::table(sides) + 2; k <= 6; k += 2)
            for (const Template &chosen : solve(any(sides, k), 3)) {
                expect_delivers(chosen, sides, k);
                ++built;
            }
    }
    EXPECT_GT(built, 100);
}

TEST(Polygon, EveryPromisedCountIsOneTheExactFillerFinds) {
    for (const Sides &sides : {Sides{4, 6, 8}, Sides{3, 3, 8}, Sides{4, 5, 6, 3}, Sides{4, 4, 4, 4},
                               Sides{3, 6, 4, 5, 4}, Sides{3, 4, 3, 4, 5, 3}}) {
        const int n = static_cast<int>(sides.size());
        ExactFiller filler(3000000);
        for (int k = oracle::table(sides); k <= 4; k += 2) {
            const FaceSet exact = filler.faces(oracle::polygon(sides), (k + 4 - n) / 2, (k - 4 + n) / 2, 60);
            for (int f = 1; f <= 60; ++f) {
                PolygonQuery query = any(sides, k);
                query.fewest_faces = query.most_faces = query.faces = f;
                for (const Template &chosen : solve(query, 1)) {
                    EXPECT_EQ(chosen.faces, f);
                    EXPECT_TRUE(exact[static_cast<std::size_t>(f)]) << testing::PrintToString(sides) << f;
                }
            }
        }
    }
}

TEST(Polygon, AnswersAreInRangeBestFirstAndDifferent) {
    std::mt19937 random(9);
    for (int round = 0; round < 100; ++round) {
        const int n = 3 + static_cast<int>(random() % 4);
        Sides sides;
        for (int i = 0; i < n; ++i)
            sides.push_back(4 + static_cast<int>(random() % 7));
        if (std::accumulate(sides.begin(), sides.end(), 0) % 2 != 0)
            ++sides[0];
        PolygonQuery query =
            any(sides, oracle::table(sides) <= 2 ? oracle::table(sides) + 2 : oracle::table(sides));
        query.fewest_faces = query.faces - 10;
        query.most_faces = query.faces + 5;
        query.seed = random();
        const auto found = solve(query, 10);
        EXPECT_LE(found.size(), 10u);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_GE(found[i].faces, query.fewest_faces);
            EXPECT_LE(found[i].faces, query.most_faces);
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_LE(std::abs(found[j].faces - query.faces), std::abs(found[i].faces - query.faces));
                EXPECT_FALSE(found[i].type == found[j].type && found[i].x == found[j].x &&
                             found[i].first_side == found[j].first_side &&
                             found[i].mirrored == found[j].mirrored);
            }
        }
    }
}

TEST(Polygon, IsDeterministic) {
    PolygonQuery query = any({5, 7, 6, 9, 5}, 3);
    query.seed = 5;
    const auto a = solve(query, 8), b = solve(query, 8);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].type, b[i].type);
        EXPECT_EQ(a[i].x, b[i].x);
        EXPECT_EQ(build(a[i], query.sides).quads, build(b[i], query.sides).quads);
    }
}

} // namespace
