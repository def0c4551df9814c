#include "geometry/untangle.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "square.h"

namespace alphamst::geometry {
namespace {

using samples::noisy;
using samples::Square;

constexpr int sweeps = 200;

struct Case {
    explicit Case(Square square)
        : s(std::move(square)), stars(s.quads, static_cast<int>(s.points.size())), area(s.quads.size(), 1) {}
    Case(const Case &) = delete;

    Problem problem() const { return {s.quads, stars, s.fixed, area}; }
    double worst(int quad) const {
        return judge(Quads(&s.quads[static_cast<std::size_t>(quad)], 1), s.points).min_determinant;
    }

    Square s;
    Stars stars;
    std::vector<double> area;
};

TEST(Untangle, TheTangledAreListedTheWorstFirst) {
    const Case c(noisy(10, 1.2, 4));
    const std::vector<int> found = tangled(c.problem(), c.s.points);
    ASSERT_GT(found.size(), 5U);
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_LE(c.worst(found[i - 1]), c.worst(found[i]));
    for (int q = 0; q < static_cast<int>(c.s.quads.size()); ++q)
        EXPECT_EQ(std::count(found.begin(), found.end(), q), c.worst(q) > 0 ? 0 : 1);
}

TEST(Untangle, TurnsEveryCornerPositiveAndMovesNothingFixed) {
    for (unsigned seed = 1; seed < 6; ++seed) {
        const Case c(noisy(10, 2, seed));
        Points points = c.s.points;
        std::ptrdiff_t effort = untangling_effort(c.problem());
        EXPECT_TRUE(untangle(c.problem(), points, sweeps, effort));
        EXPECT_TRUE(judge(c.s.quads, points).valid);
        EXPECT_TRUE(tangled(c.problem(), points).empty());
        EXPECT_LE(effort, untangling_effort(c.problem()));
        for (std::size_t v = 0; v < points.size(); ++v)
            if (c.s.fixed[v]) {
                EXPECT_EQ(points[v], c.s.points[v]);
            }
    }
}

TEST(Untangle, LeavesWhatIsNotTangled) {
    const Case c(noisy(6, 0.2, 1));
    Points points = c.s.points;
    std::ptrdiff_t effort = 5;
    EXPECT_TRUE(untangle(c.problem(), points, sweeps, effort));
    EXPECT_EQ(points, c.s.points);
    EXPECT_EQ(effort, 5);
}

// The corner of the square is beyond its neighbours, which do not move either.
TEST(Untangle, GivesUpAtOnceWhereACornerIsOfFixedVertices) {
    Square s = noisy(6, 1, 2);
    s.points[0] = {1.5, 1.5};
    const Case c(std::move(s));
    Points points = c.s.points;
    std::ptrdiff_t effort = untangling_effort(c.problem());
    EXPECT_FALSE(untangle(c.problem(), points, sweeps, effort));
    EXPECT_EQ(points, c.s.points);
    EXPECT_EQ(effort, untangling_effort(c.problem()));
}

// A vertex of the boundary far inside: sweeps over vertices do not do, nor does anything else.
TEST(Untangle, SpendsNoMoreThanItsEffort) {
    Square s = noisy(8, 0, 1);
    s.points[4] = {4, 9}; // from the middle of the bottom to beyond the top
    const Case c(std::move(s));
    Points points = c.s.points;
    std::ptrdiff_t effort = 300;
    EXPECT_FALSE(untangle(c.problem(), points, sweeps, effort));
    EXPECT_GE(effort, 0);
    EXPECT_LT(effort, 300);
}

TEST(Untangle, EffortGrowsWithTheQuads) {
    const Case small(noisy(4, 0, 1)), large(noisy(12, 0, 1)), larger(noisy(20, 0, 1));
    const auto a = untangling_effort(small.problem()), b = untangling_effort(large.problem()),
               c = untangling_effort(larger.problem());
    EXPECT_GT(a, 0);
    EXPECT_GT(b, a);
    EXPECT_EQ((c - b) * (144 - 16), (b - a) * (400 - 144)); // the same for each
}

} // namespace
} // namespace alphamst::geometry
