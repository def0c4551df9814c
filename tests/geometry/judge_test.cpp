#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/embed.h"

namespace alphamst::geometry {
namespace {

using QuadList = std::vector<std::array<int, 4>>;

TEST(Judge, UnitSquareAndSlantedQuad) {
    const QuadList quad{{0, 1, 2, 3}};
    const Embedding square = judge(quad, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_TRUE(square.valid);
    EXPECT_DOUBLE_EQ(square.min_determinant, 1);
    EXPECT_DOUBLE_EQ(square.min_scaled_jacobian, 1);
    // A parallelogram of 30 degrees: area 1 * 2 * sin 30.
    const double c = std::sqrt(3.0) / 2;
    const Embedding slanted = judge(quad, {{0, 0}, {2, 0}, {2 + c, 0.5}, {c, 0.5}});
    EXPECT_NEAR(slanted.min_determinant, 1, 1e-14);
    EXPECT_NEAR(slanted.min_scaled_jacobian, 0.5, 1e-14);
}

TEST(Judge, ConcaveStraightClockwiseAndCollapsedAreNotValid) {
    const QuadList quad{{0, 1, 2, 3}};
    const Embedding concave = judge(quad, {{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}});
    EXPECT_FALSE(concave.valid);
    EXPECT_NEAR(concave.min_determinant, -0.6, 1e-14); // (-0.8, 0.2) x (-0.2, 0.8)
    EXPECT_FALSE(judge(quad, {{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}).valid);
    EXPECT_DOUBLE_EQ(judge(quad, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}).min_scaled_jacobian, -1);
    EXPECT_FALSE(judge(quad, {{0, 0}, {0, 0}, {1, 1}, {0, 1}}).valid);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(judge(quad, {{0, 0}, {1, 0}, {nan, 1}, {0, 1}}).valid);
}

TEST(Judge, CountsInvertedAndPoorQuads) {
    // A square, one of 40 degrees, a thin rectangle and one that is inverted, side by side.
    const double c = std::cos(40 * 3.14159265358979323846 / 180), s = std::sqrt(1 - c * c);
    const QuadList quads{{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 1, 6, 7}, {3, 2, 1, 0}};
    const Points points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1 + c, s}, {c, s}, {1, 0.1}, {0, 0.1}};
    const Judgement all = shapes_of(quads, points);
    EXPECT_EQ(all.inverted, 1);
    EXPECT_EQ(all.poor, 3);
    EXPECT_FALSE(all.valid);
    const Judgement thin = shapes_of(Quads(quads).subspan(2, 1), points);
    EXPECT_NEAR(thin.min_shape, 0.2 / 1.01, 1e-14); // 2 * 0.1 / (1 + 0.01)
    EXPECT_NEAR(thin.min_scaled_jacobian, 1, 1e-14);
    EXPECT_EQ(thin.poor, 1);
    EXPECT_TRUE(thin.valid);
}

TEST(Judge, NoQuadsAreNothing) {
    const Embedding none = judge({}, {{1, 2}});
    EXPECT_EQ(none.min_determinant, 0);
    EXPECT_EQ(none.min_scaled_jacobian, 0);
    EXPECT_EQ(none.inverted, 0);
    EXPECT_EQ(none.positions, Points{Eigen::Vector2d(1, 2)});
}

} // namespace
} // namespace alphamst::geometry
