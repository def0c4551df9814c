#include "fill/closed_form.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

constexpr int most = 80;

std::set<std::int64_t> exact(const Word &word, int v3, int v5) {
    ExactFiller filler(2000000);
    const FaceSet faces = filler.faces(word, v3, v5, most);
    std::set<std::int64_t> counts;
    for (int f = 1; f <= most; ++f)
        if (faces[static_cast<std::size_t>(f)])
            counts.insert(f);
    return counts;
}

// The closed form and the exact filler agree on whether and with how many faces.
void expect_spokes(const Sides &sides) {
    std::set<std::int64_t> expected;
    if (const auto h = spokes(sides)) {
        expected.insert(spoke_faces(*h));
        for (std::size_t i = 0; i < sides.size(); ++i) {
            EXPECT_GE((*h)[i], 1);
            EXPECT_EQ(sides[i], (*h)[(i + sides.size() - 1) % sides.size()] + (*h)[(i + 1) % sides.size()]);
        }
    }
    const bool three = sides.size() == 3;
    EXPECT_EQ(exact(oracle::polygon(sides), three, !three), expected) << testing::PrintToString(sides);
}

TEST(ClosedForm, SpokesOfTriangles) {
    for (const Sides &sides : oracle::polygons(3, 1, 9))
        expect_spokes(sides);
}

TEST(ClosedForm, SpokesOfPentagons) {
    for (const Sides &sides : oracle::polygons(5, 1, 5))
        expect_spokes(sides);
}

TEST(ClosedForm, NoSpokesElsewhere) {
    EXPECT_FALSE(spokes({3, 3, 3}));
    EXPECT_FALSE(spokes({4, 4, 4, 4}));
    EXPECT_FALSE(spokes({4, 4, 4, 4, 4, 4}));
}

TEST(ClosedForm, PairsOfQuadrangles) {
    int pairs = 0;
    for (const Sides &smallest : oracle::polygons(4, 1, 7))
        for (int turn = 0; turn < 8; ++turn) {
            Sides sides = smallest;
            if (turn >= 4)
                std::reverse(sides.begin(), sides.end());
            std::rotate(sides.begin(), sides.begin() + turn % 4, sides.end());
            const auto form = pair(sides);
            std::set<std::int64_t> counts;
            if (form) {
                ++pairs;
                for (int u = 1; u <= form->most_u; ++u)
                    for (int v = 1; v <= form->most_v; ++v)
                        counts.insert(form->faces(u, v));
            }
            EXPECT_EQ(exact(oracle::polygon(sides), 1, 1), counts) << testing::PrintToString(sides);
        }
    EXPECT_GT(pairs, 500);
}

TEST(ClosedForm, RingsAroundACore) {
    for (int p = 8; p <= 14; p += 2) {
        const Word flat(static_cast<std::size_t>(p), 2);
        const auto counts = exact(flat, 4, 0);
        for (int c = 1; 2 * c <= p / 2; ++c)
            for (int b = 1; c * (p / 2 - c) + ring_faces(b, p) <= most; ++b)
                EXPECT_TRUE(counts.count(c * (p / 2 - c) + ring_faces(b, p))) << p << " " << c << " " << b;
        for (const std::int64_t f : counts) // a ring can always be added
            if (f + ring_faces(1, p) <= most) {
                EXPECT_TRUE(counts.count(f + ring_faces(1, p)));
            }
    }
}

TEST(ClosedForm, LeastSingularitiesOfSmallSidesIsTheBruteForce) {
    // One singularity: triangles and pentagons with every spoke at least 1, sides of 2 included.
    for (const int n : {3, 5})
        for (const Sides &sides : oracle::polygons(n, 2, n == 3 ? 7 : 4))
            if (spokes(sides)) {
                EXPECT_EQ(least_singularities(sides), 1);
                EXPECT_EQ(oracle::least(oracle::polygon(sides), 1, 60), 1) << testing::PrintToString(sides);
            }
    for (const Sides &sides : oracle::polygons(4, 1, 6)) {
        const int total = sides[0] + sides[1] + sides[2] + sides[3];
        const int longest = *std::max_element(sides.begin(), sides.end());
        const int shortest = *std::min_element(sides.begin(), sides.end());
        const bool rectangle = sides[0] == sides[2] && sides[1] == sides[3];
        const bool two = !rectangle && shortest >= 2 && 2 * longest <= total - 4;
        const int brute = oracle::least(oracle::polygon(sides), 2, 40);
        EXPECT_EQ(brute, rectangle ? 0 : two ? 2 : -1) << testing::PrintToString(sides);
        if (brute >= 0) {
            EXPECT_EQ(least_singularities(sides), brute) << testing::PrintToString(sides);
        }
    }
    for (int n = 6; n <= 10; n += 2)
        EXPECT_EQ(oracle::least(oracle::polygon({n}), 3, 40), 3);
    EXPECT_EQ(oracle::least(oracle::polygon({4}), 3, 40), -1);
    for (int n0 = 1; n0 <= 6; ++n0)
        for (int n1 = n0; n1 <= 6; ++n1)
            if ((n0 + n1) % 2 == 0 && n0 + n1 >= 4) {
                EXPECT_EQ(oracle::least(oracle::polygon({n0, n1}), 2, 40), n0 >= 3 ? 2 : -1)
                    << n0 << " " << n1;
            }
    EXPECT_EQ(least_singularities({6}), 3);
    EXPECT_EQ(least_singularities({3, 5}), 2);
    EXPECT_EQ(least_singularities({3, 4}), -1);
}

} // namespace
