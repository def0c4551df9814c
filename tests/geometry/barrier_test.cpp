#include "geometry/barrier.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "fan.h"

namespace {

using namespace alphamst::geometry;
using Eigen::Vector2d;
using samples::Fan;

TEST(Barrier, SquareOfTheWantedSizeHasValueOnePerCorner) {
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}};
    const Stars stars(quads, 4);
    const Points points{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
    const std::vector<double> right{9.0}, wrong{4.0};
    EXPECT_NEAR(value({.area = right}, stars.at(0), points, points[0]), 3, 1e-14);
    EXPECT_GT(value({.area = wrong}, stars.at(0), points, points[0]), 3);
}

TEST(Barrier, GradientMatchesDifferencesAndHessianIsPositive) {
    const Fan f;
    for (const double epsilon : {0.0, 0.1, 1.0})
        for (const Vector2d &x : {Vector2d(0.1, 0.2), Vector2d(-0.2, 0.1), Vector2d(1.2, 1.4)}) {
            const Barrier barrier{.theta = 0.1, .epsilon = epsilon, .area = f.area};
            const auto at = [&](double dx, double dy) {
                return value(barrier, f.stars.at(0), f.points, x + Vector2d(dx, dy));
            };
            const Expansion e = taylor_expansion(barrier, f.stars.at(0), f.points, x);
            if (!std::isfinite(at(0, 0))) {
                EXPECT_EQ(epsilon, 0.0);
                EXPECT_FALSE(std::isfinite(e.value));
                continue;
            }
            const double h = 1e-6, tolerance = 1e-5 * (1 + e.value);
            EXPECT_NEAR(e.value, at(0, 0), 1e-12 * e.value);
            EXPECT_NEAR(e.gx, (at(h, 0) - at(-h, 0)) / (2 * h), tolerance);
            EXPECT_NEAR(e.gy, (at(0, h) - at(0, -h)) / (2 * h), tolerance);
            EXPECT_GT(e.hxx, 0);
            EXPECT_GT(e.hxx * e.hyy - e.hxy * e.hxy, 0);
            if (epsilon == 0) { // chi is affine there and nothing is left out
                const double k = 1e-4;
                EXPECT_NEAR(e.hxx, (at(k, 0) - 2 * at(0, 0) + at(-k, 0)) / (k * k), 1e-3 * e.hxx);
                EXPECT_NEAR(e.hxy, (at(k, k) - at(k, -k) - at(-k, k) + at(-k, -k)) / (4 * k * k),
                            1e-3 * e.hxx);
            }
        }
}

TEST(Barrier, CornerGradientMatchesDifferencesAndHessianIsPositive) {
    const std::vector<double> unused;
    for (const double epsilon : {0.1, 1.0})
        for (const Eigen::Vector4d &edges :
             {Eigen::Vector4d(1, 0.2, -0.1, 0.9), Eigen::Vector4d(1, 0, 0.3, -0.4)}) {
            const Barrier barrier{.theta = 0.1, .epsilon = epsilon, .area = unused};
            const CornerExpansion e = expand_corner(barrier, edges, 0.7);
            for (int i = 0; i < 4; ++i) {
                const Eigen::Vector4d step = 1e-6 * Eigen::Vector4d::Unit(i);
                EXPECT_NEAR(
                    e.gradient[i],
                    (corner_value(barrier, edges + step, 0.7) - corner_value(barrier, edges - step, 0.7)) /
                        2e-6,
                    1e-5 * (1 + e.value));
            }
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(e.hessian);
            EXPECT_GE(eigen.eigenvalues()[0], -1e-10 * eigen.eigenvalues()[3]);
        }
}

TEST(Barrier, WorstCornerIsTheSignedSquareOfTheScaledJacobian) {
    const Fan f;
    // All corners but those opposite the vertex depend on it; none of those is the worst here.
    const double s = judge(f.quads, f.points).min_scaled_jacobian;
    EXPECT_NEAR(worst_corner(f.stars.at(0), f.points, f.points[0]), s * std::abs(s), 1e-12);
    EXPECT_LT(worst_corner(f.stars.at(0), f.points, {2, 2}), 0);
}

} // namespace
