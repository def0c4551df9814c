#include "fill/alpha.h"

#include <gtest/gtest.h>

#include <random>

#include "oracle.h"

namespace {

using namespace alphamst::fill;

AlphaQuery query(int perimeter, std::int64_t faces, std::int64_t slack) {
    AlphaQuery result;
    result.perimeter = perimeter;
    result.faces = faces;
    result.fewest_faces = faces - slack;
    result.most_faces = faces + slack;
    return result;
}

void expect_delivers(const AlphaTemplate &chosen, int perimeter, int offset) {
    EXPECT_EQ(std::accumulate(chosen.outer.begin(), chosen.outer.end(), 0), perimeter);
    const oracle::Disk disk = oracle::inspect(build(chosen, offset));
    ASSERT_EQ(disk.fault, "") << perimeter << " " << chosen.faces;
    EXPECT_EQ(disk.word, Word(static_cast<std::size_t>(perimeter), 2));
    EXPECT_EQ(disk.v3 + disk.v5, chosen.singularities) << perimeter << " " << chosen.faces;
    EXPECT_EQ(disk.v3 - disk.v5, 4);
    EXPECT_EQ(disk.other, 0);
    EXPECT_EQ(disk.faces, chosen.faces);
}

TEST(Alpha, BuildsWhatItPredicts) {
    std::mt19937 random(13);
    int built = 0;
    for (int p = 8; p <= 80; p += 4)
        for (int step = 1; step <= 6; ++step) {
            const std::int64_t faces =
                p / 2 + static_cast<std::int64_t>(p) * p * step / 24 + static_cast<int>(random() % 7);
            for (const AlphaTemplate &chosen : solve(query(p, faces, 3), 3)) {
                EXPECT_LE(std::abs(chosen.faces - faces), 3);
                EXPECT_GE(chosen.singularities, 4);
                EXPECT_LE(chosen.singularities, 8);
                expect_delivers(chosen, p, static_cast<int>(random() % static_cast<unsigned>(p)));
                ++built;
            }
        }
    EXPECT_GT(built, 150);
}

TEST(Alpha, NearestCountsWithFewestSingularitiesComeFirst) {
    for (const int p : {16, 24, 40, 60})
        for (std::int64_t faces = p * p / 16; faces < p * p / 4; faces += p / 2 + 1) {
            const auto found = solve(query(p, faces, 4), 6);
            for (std::size_t i = 1; i < found.size(); ++i) {
                const auto miss = std::abs(found[i].faces - faces),
                           before = std::abs(found[i - 1].faces - faces);
                EXPECT_LE(before, miss);
                if (before == miss) {
                    EXPECT_LE(found[i - 1].singularities, found[i].singularities);
                }
            }
        }
}

// Four inner valence-3 vertices reach every count within a few faces.
TEST(Alpha, FourSingularitiesComeNear) {
    for (std::int64_t faces = 100; faces <= 400; faces += 7) {
        AlphaQuery four = query(40, faces, 4);
        four.most_singularities = 4;
        EXPECT_FALSE(solve(four, 1).empty()) << faces;
    }
}

std::size_t cores_of_all(std::size_t corners, int least, int most) {
    std::size_t seen = 0;
    for (int p = 24; p <= 60; p += 6)
        for (std::int64_t faces = p * p / 16; faces < p * p / 6; faces += 5) {
            AlphaQuery wanted = query(p, faces, 2);
            wanted.least_singularities = least;
            wanted.most_singularities = most;
            for (const AlphaTemplate &chosen : solve(wanted, 24))
                if (chosen.core.size() == corners && seen++ % 16 == 0)
                    expect_delivers(chosen, p, 0);
        }
    return seen;
}

TEST(Alpha, TriangleCoresOccur) { EXPECT_GT(cores_of_all(3, 4, 4), 0u); }
TEST(Alpha, QuadrangleCoresOccur) { EXPECT_GT(cores_of_all(4, 4, 4), 0u); }
TEST(Alpha, PentagonCoresOccur) { EXPECT_GT(cores_of_all(5, 6, 6), 0u); }
TEST(Alpha, HexagonCoresOccur) { EXPECT_GT(cores_of_all(6, 8, 8), 0u); }

TEST(Alpha, ChangedSidesDeliver) {
    int changed = 0;
    for (const int p : {24, 32, 40, 48})
        for (const int k : {6, 8, 12})
            for (std::int64_t faces = p * p / 8; faces < p * p / 3; faces += p) {
                AlphaQuery wanted = query(p, faces, 2);
                wanted.least_singularities = wanted.most_singularities = k;
                for (const AlphaTemplate &chosen : solve(wanted, 8))
                    if (chosen.outer != chosen.core) {
                        EXPECT_EQ(chosen.singularities, k);
                        expect_delivers(chosen, p, 3);
                        ++changed;
                    }
            }
    EXPECT_GT(changed, 20);
}

TEST(Alpha, RefusesOddAndTinyPerimeters) {
    EXPECT_TRUE(solve(query(15, 30, 5), 4).empty());
    EXPECT_TRUE(solve(query(4, 30, 5), 4).empty());
    EXPECT_TRUE(solve(query(40, 5, 0), 4).empty());
}

TEST(Alpha, IsDeterministic) {
    const auto a = solve(query(40, 211, 2), 6), b = solve(query(40, 211, 2), 6);
    ASSERT_EQ(a.size(), b.size());
    ASSERT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(build(a[i], 5).quads, build(b[i], 5).quads);
}

} // namespace
