#include "fill/library.h"

#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

struct Family {
    int sides, singularities;
};

// Every (N, k) for which anything is kept.
std::vector<Family> families() {
    std::vector<Family> all;
    for (int n = 1; n <= 6; ++n)
        for (int k = std::abs(n - 4); k <= 6; k += 2)
            if (!types(n, k).empty())
                all.push_back({n, k});
    return all;
}

TEST(Library, KeepsTheFamiliesThatPolygonsNeed) {
    for (int n = 3; n <= 6; ++n)
        for (int k = n - 4 < 0 ? 4 - n : n - 4; k <= std::abs(n - 4) + 4; k += 2)
            if (n != 3 || k <= 3) { // a triangle never needs five
                EXPECT_FALSE(types(n, k).empty()) << n << " " << k;
            }
    EXPECT_FALSE(types(1, 3).empty());
    EXPECT_FALSE(types(2, 2).empty());
    EXPECT_TRUE(types(4, 1).empty());
    EXPECT_TRUE(types(7, 3).empty());
}

// Families with up to three singularities are complete: nothing that the exact filler finds on larger
// polygons is new.
void expect_complete(int sides, int singularities, int longest, int perimeter) {
    std::set<std::vector<int>> known;
    for (const Layout &type : types(sides, singularities))
        known.insert(signature(type));
    const int v3 = (singularities + 4 - sides) / 2, v5 = singularities - v3;
    for (const std::vector<int> &lengths : oracle::polygons(sides, sides == 1 ? 6 : 2, longest)) {
        const Word word = oracle::polygon(lengths);
        if (static_cast<int>(word.size()) > perimeter)
            continue;
        std::vector<int> corners{0};
        for (std::size_t i = 0; i + 1 < lengths.size(); ++i)
            corners.push_back(corners.back() + lengths[i]);
        ExactFiller filler(1000000);
        const FaceSet faces = filler.faces(word, v3, v5, 60);
        for (int f = 1; f <= 60; ++f)
            for (std::uint64_t seed = 0; seed < 2 && faces[static_cast<std::size_t>(f)]; ++seed)
                EXPECT_TRUE(known.count(signature(extract(*filler.fill(word, v3, v5, f, seed), corners))))
                    << testing::PrintToString(lengths) << " with " << f << " faces";
    }
}

TEST(Library, HasAllTypesWithFewSingularities) {
    expect_complete(1, 3, 16, 16);
    expect_complete(2, 2, 8, 16);
    expect_complete(3, 1, 6, 18);
    expect_complete(3, 3, 9, 20);
    expect_complete(4, 0, 6, 24);
    expect_complete(4, 2, 6, 20);
    expect_complete(5, 1, 5, 20);
    expect_complete(5, 3, 6, 22);
    expect_complete(6, 2, 5, 22);
    EXPECT_EQ(types(3, 1).size(), 1u);
    EXPECT_EQ(types(4, 0).size(), 1u);
    EXPECT_EQ(types(5, 1).size(), 1u);
    EXPECT_EQ(types(2, 2).size(), 2u);
    EXPECT_EQ(types(4, 2).size(), 2u);
    EXPECT_EQ(types(6, 2).size(), 2u);
}

TEST(Library, GenericTypesHaveTwoChordsMorePerSingularity) {
    for (const Family &family :
         {Family{3, 1}, Family{5, 1}, Family{2, 2}, Family{4, 2}, Family{6, 2}, Family{3, 3}, Family{5, 3}}) {
        int most = 0;
        for (const Layout &type : types(family.sides, family.singularities))
            most = std::max(most, type.chords);
        EXPECT_EQ(most, 2 * (family.singularities - 1) + family.sides);
    }
}

TEST(Library, ExpansionsAreWhatTheNumbersSay) {
    std::mt19937 random(10);
    for (const Family &family : families())
        for (const Layout &type : types(family.sides, family.singularities)) {
            ASSERT_EQ(type.sides, family.sides);
            ASSERT_EQ(type.v3 + type.v5, family.singularities);
            ASSERT_EQ(type.v3 - type.v5, 4 - family.sides);
            for (int round = 0; round < 5; ++round) {
                Multiplicities x;
                for (int j = 0; j < type.chords; ++j)
                    x.push_back(round == 0 ? 1 : 1 + static_cast<int>(random() % 4));
                const auto lengths = side_lengths(type, x);
                std::int64_t form = 0; // x' C x
                for (std::size_t i = 0; i < x.size(); ++i)
                    for (std::size_t j = 0; j < x.size(); ++j) {
                        ASSERT_EQ(type.product[i][j], type.product[j][i]);
                        form += static_cast<std::int64_t>(type.product[i][j]) * x[i] * x[j];
                    }
                const oracle::Disk disk = oracle::inspect(expand(type, x));
                ASSERT_EQ(disk.fault, "") << family.sides << " " << family.singularities;
                ASSERT_EQ(disk.word, oracle::polygon(lengths));
                ASSERT_EQ(disk.v3, type.v3);
                ASSERT_EQ(disk.v5, type.v5);
                ASSERT_EQ(disk.other, 0);
                ASSERT_EQ(2 * disk.faces, form);
                ASSERT_EQ(disk.faces, face_count(type, x));
            }
        }
}

TEST(Library, TypesAreDifferentAndSortedByChords) {
    for (const Family &family : families()) {
        std::set<std::vector<int>> seen;
        int last = 1 << 20;
        for (const Layout &type : types(family.sides, family.singularities)) {
            EXPECT_TRUE(seen.insert(signature(type)).second) << family.sides << " " << family.singularities;
            EXPECT_LE(type.chords, last);
            last = type.chords;
        }
    }
}

TEST(Library, MovesKeepTheSidesAndPredictTheFaces) {
    std::mt19937 random(11);
    for (const Family &family : families())
        for (const Layout &type : types(family.sides, family.singularities)) {
            Multiplicities x;
            for (int j = 0; j < type.chords; ++j)
                x.push_back(10 + static_cast<int>(random() % 5));
            const auto lengths = side_lengths(type, x);
            const auto faces = face_count(type, x);
            for (const Move &move : type.moves)
                for (const int t : {-3, -1, 1, 2}) {
                    Multiplicities y = x;
                    std::int64_t slope = 0;
                    for (std::size_t j = 0; j < y.size(); ++j) {
                        y[j] += t * move.z[j];
                        slope += static_cast<std::int64_t>(move.slope[j]) * x[j];
                    }
                    ASSERT_EQ(side_lengths(type, y), lengths);
                    ASSERT_EQ(face_count(type, y), faces + t * slope + t * t * move.curvature);
                }
        }
}

TEST(Library, IsOneForAllThreads) {
    std::vector<const std::vector<Layout> *> seen(4);
    std::vector<std::thread> threads;
    for (auto &mine : seen)
        threads.emplace_back([&mine] { mine = &types(5, 3); });
    for (std::thread &thread : threads)
        thread.join();
    for (const auto *mine : seen)
        EXPECT_EQ(mine, &types(5, 3));
}

} // namespace
