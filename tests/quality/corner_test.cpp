#include "quality/corner.h"

#include <gtest/gtest.h>

#include <limits>

#include "quality/metric.h"

namespace alphamst::quality {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Corner, TheDeterminantIsTheSignedArea) {
    EXPECT_EQ(determinant({2, 0}, {1, 3}), 6);
    EXPECT_EQ(determinant({1, 3}, {2, 0}), -6);
    EXPECT_EQ(determinant({2, 0, 1, 3}), 6);
    EXPECT_EQ(determinant({2, 0, 0}, {1, 3, 0}, {0, 0, 1}), 6);
    EXPECT_EQ(determinant({2, 0, 0}, {1, 3, 0}, {0, 0, -1}), -6);
}

TEST(Corner, TheScaledJacobianIsTheSine) {
    EXPECT_EQ(scaled_jacobian(Vector2d(3, 0), Vector2d(0, 5)), 1);
    EXPECT_DOUBLE_EQ(scaled_jacobian(Vector2d(3, 0), Vector2d(-2, 2)), std::sqrt(0.5));
    EXPECT_DOUBLE_EQ(scaled_jacobian(Vector2d(-2, 2), Vector2d(3, 0)), -std::sqrt(0.5));
    EXPECT_DOUBLE_EQ(scaled_jacobian(Vector3d(3, 0, 0), Vector3d(-2, 2, 7), {0, 0, 1}),
                     6 / (3 * std::sqrt(57)));
    EXPECT_EQ(scaled_jacobian(Vector2d(3, 0), Vector2d(0, 0)), 0);
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(scaled_jacobian(none, 1)));
}

TEST(Corner, EdgesThroughTheCornerCountAsEdgesThatLeaveIt) {
    const Vector2d before(0.3, -2.1), next(1.7, 0.4);
    EXPECT_EQ(determinant(before, next), determinant(next, -before));
}

TEST(Corner, TheSignedSquareIsThatOfTheScaledJacobian) {
    const Vector2d a(3, 1);
    for (const Vector2d &b : {Vector2d(1, 2), Vector2d(1, -2), Vector2d(6, 2)}) {
        const double square = signed_square(determinant(a, b), a.squaredNorm() * b.squaredNorm());
        EXPECT_NEAR(of_signed_square(square), scaled_jacobian(a, b), 1e-15);
    }
    EXPECT_EQ(signed_square(0, 0), 0);
}

TEST(Corner, TheWorstOfAPlaneQuadIsItsMetric) {
    const std::array<Vector2d, 4> quad{Vector2d(0, 0), Vector2d(2, 0.5), Vector2d(2.5, 2), Vector2d(-0.5, 1)};
    double jacobian = 1, shape = 1;
    Corners corners;
    for (std::size_t k = 0; k < 4; ++k) {
        corners[k] << quad[k], 0;
        const Vector2d a = quad[(k + 1) % 4] - quad[k], b = quad[(k + 3) % 4] - quad[k];
        jacobian = std::min(jacobian, scaled_jacobian(a, b));
        shape = std::min(shape, corner_shape(determinant(a, b), a.squaredNorm() + b.squaredNorm()));
    }
    EXPECT_NEAR(measure(Metric::scaled_jacobian, corners, 1), jacobian, 1e-14);
    EXPECT_NEAR(measure(Metric::shape, corners, 1), shape, 1e-14);
}

} // namespace
} // namespace alphamst::quality
