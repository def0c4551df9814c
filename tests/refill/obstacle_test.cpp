#include "refill/obstacle.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace alphamst::refill {
namespace {

// n x n squares; the boundary counter-clockwise from the lower left corner.
fill::Filling block(int n) {
    fill::Filling filling;
    filling.boundary = 4 * n;
    auto name = [&](int i, int j) {
        if (j == 0)
            return i;
        if (i == n)
            return n + j;
        if (j == n)
            return 3 * n - i;
        if (i == 0)
            return 4 * n - j;
        return 4 * n + (j - 1) * (n - 1) + i - 1;
    };
    filling.vertices = 4 * n + (n - 1) * (n - 1);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            filling.quads.push_back({name(i, j), name(i + 1, j), name(i + 1, j + 1), name(i, j + 1)});
    return filling;
}

TEST(Obstacles, NothingIsMetBeforeAnythingIsLearnt) { EXPECT_FALSE(Obstacles().met_by(block(4))); }

TEST(Obstacles, TheSamePieceIsMetWhateverTheNamesOfNewVerticesAndTheOrderOfQuads) {
    const fill::Filling filling = block(8);
    Obstacles obstacles;
    obstacles.learn(filling, 3);
    fill::Filling same = filling;
    for (auto &quad : same.quads)
        for (int &v : quad)
            if (v >= same.boundary)
                v = same.boundary + same.vertices - 1 - v;
    std::reverse(same.quads.begin(), same.quads.end());
    for (auto &quad : same.quads)
        std::rotate(quad.begin(), quad.begin() + 1, quad.end());
    EXPECT_TRUE(obstacles.met_by(same));
}

TEST(Obstacles, AChangeFarAwayIsNoDifferenceOneNearbyIs) {
    const fill::Filling filling = block(12);
    Obstacles obstacles;
    obstacles.learn(filling, 1);
    // A new vertex inside a quad, joined to two opposite corners of it.
    auto split = [&](std::size_t at) {
        fill::Filling other = filling;
        const auto quad = other.quads[at];
        const int v = other.vertices++;
        other.quads[at] = {quad[0], quad[1], quad[2], v};
        other.quads.push_back({quad[0], v, quad[2], quad[3]});
        return other;
    };
    EXPECT_TRUE(obstacles.met_by(split(143)));
    EXPECT_FALSE(obstacles.met_by(split(1)));
    EXPECT_FALSE(obstacles.met_by(split(14)));
}

TEST(Obstacles, QuadsFarFromTheBoundaryTeachNothing) {
    const fill::Filling filling = block(9);
    Obstacles obstacles;
    obstacles.learn(filling, 40);
    EXPECT_FALSE(obstacles.met_by(filling));
}

} // namespace
} // namespace alphamst::refill
