#include "surface/triangle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

Vector3d random_point(std::mt19937 &random, double size) {
    const auto one = [&] { return size * (2.0 * static_cast<double>(random()) / std::mt19937::max() - 1); };
    const double x = one(), y = one(), z = one();
    return {x, y, z};
}

Vector3d sum(const Triangle &t, const Vector3d &weights) {
    return weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
}

TEST(Triangle, NoPlaceIsNearerThanTheClosest) {
    std::mt19937 random(1);
    constexpr int n = 40;
    for (int round = 0; round < 300; ++round) {
        const Triangle t{random_point(random, 1), random_point(random, 1), random_point(random, 1)};
        const Vector3d p = random_point(random, 2);
        const Closest found = closest(p, t, {0, 1, 2});
        EXPECT_NEAR(found.weights.sum(), 1, 1e-12);
        EXPECT_GE(found.weights.minCoeff(), 0);
        EXPECT_LT((sum(t, found.weights) - found.point).norm(), 1e-12);
        EXPECT_NEAR((p - found.point).squaredNorm(), found.squared, 1e-12);
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const Vector3d place = sum(t, Vector3d(i, j, n - i - j) / n);
                EXPECT_GE((p - place).squaredNorm(), found.squared - 1e-12);
            }
    }
}

TEST(Triangle, CornersEdgesAndInsideEachHaveTheirPlaces) {
    const Triangle t{Vector3d(0, 0, 0), Vector3d(2, 0, 0), Vector3d(0, 2, 0)};
    const auto at = [&](double x, double y) { return closest({x, y, 3}, t, {0, 1, 2}); };
    EXPECT_EQ(at(-1, -1).point, t[0]);
    EXPECT_EQ(at(5, -1).point, t[1]);
    EXPECT_EQ(at(-1, 5).point, t[2]);
    EXPECT_EQ(at(0.5, -1).weights, Vector3d(0.75, 0.25, 0));
    EXPECT_EQ(at(-1, 0.5).weights, Vector3d(0.75, 0, 0.25));
    EXPECT_LT((at(2, 2).weights - Vector3d(0, 0.5, 0.5)).norm(), 1e-15);
    const Closest inside = at(0.5, 0.5);
    EXPECT_EQ(inside.squared, 9);
    EXPECT_LT((inside.weights - Vector3d(0.5, 0.25, 0.25)).norm(), 1e-15);
}

// Whichever triangle is asked, and wherever it begins.
TEST(Triangle, BothSidesOfAnEdgeFindTheSamePlaceOnIt) {
    std::mt19937 random(2);
    int on_edge = 0;
    for (int round = 0; round < 2000; ++round) {
        const Vector3d a = random_point(random, 1), b = random_point(random, 1), c = random_point(random, 1),
                       d = random_point(random, 1), p = random_point(random, 2);
        const Closest left = closest(p, {a, b, c}, {7, 3, 5}), right = closest(p, {b, a, d}, {3, 7, 9}),
                      turned = closest(p, {c, a, b}, {5, 7, 3});
        if (left.weights[2] == 0 && turned.weights[0] == 0) {
            EXPECT_EQ(left.point, turned.point);
        }
        if (left.weights[2] == 0 && right.weights[2] == 0) {
            EXPECT_EQ(left.point, right.point);
            EXPECT_EQ(left.squared, right.squared);
            on_edge += left.weights[0] > 0 && left.weights[1] > 0;
        }
    }
    EXPECT_GT(on_edge, 50);
}

// Above the inside, or beside the long edges: no more digits are lost than length / width says.
TEST(Triangle, SliversLoseNoMoreDigitsThanTheyMust) {
    std::mt19937 random(3);
    const auto any = [&](double most) { return most * static_cast<double>(random()) / std::mt19937::max(); };
    for (const double width : {1e-2, 1e-4, 1e-6})
        for (int round = 0; round < 2000; ++round) {
            const Eigen::Quaterniond turn(1, any(1), any(1), any(1));
            const Eigen::Matrix3d axes = turn.normalized().toRotationMatrix();
            const Vector3d a = random_point(random, 3);
            const Triangle t{a, a + axes.col(0) + any(width) * axes.col(1),
                             a + any(1) * axes.col(0) + (1.5 + any(1)) * width * axes.col(1)};
            const Vector3d normal = unit_normal(t[0], t[1], t[2]);
            const double i = any(1), j = any(1), height = any(10 * width);
            const Vector3d inside = sum(t, Vector3d(1 - std::max(i, j), std::abs(i - j), std::min(i, j)));
            const Vector3d edge = t[0] + i * (t[1] - t[0]);
            const Vector3d out = (t[1] - t[0]).cross(normal).normalized();
            const std::array<int, 3> ids{0, 1, 2};
            const double most = 2e-15 / width;
            EXPECT_LT((closest(inside + height * normal, t, ids).point - inside).norm(), most) << width;
            EXPECT_LT((closest(edge + height * out, t, ids).point - edge).norm(), 1e-14) << width;
            // From the other corners it is the same place.
            const Closest turned = closest(inside + height * normal, {t[1], t[2], t[0]}, {1, 2, 0});
            EXPECT_LT((turned.point - inside).norm(), most) << width;
            EXPECT_NEAR(turned.weights.sum(), 1, 1e-15);
            EXPECT_GE(turned.weights.minCoeff(), 0);
        }
}

TEST(Triangle, WithoutAreaItIsItsEdges) {
    const Triangle line{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(3, 0, 0)};
    const Closest found = closest({2, 1, 0}, line, {0, 1, 2});
    EXPECT_LT((found.point - Vector3d(2, 0, 0)).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(found.squared, 1);
    const Triangle point{Vector3d(1, 1, 1), Vector3d(1, 1, 1), Vector3d(1, 1, 1)};
    EXPECT_EQ(closest({1, 1, 3}, point, {0, 1, 2}).squared, 4);
}

TEST(Triangle, NormalsAreOfUnitLengthOrNone) {
    EXPECT_EQ(unit_normal({0, 0, 0}, {5, 0, 0}, {1, 3, 0}), Vector3d(0, 0, 1));
    EXPECT_EQ(unit_normal({0, 0, 0}, {1, 3, 0}, {5, 0, 0}), Vector3d(0, 0, -1));
    EXPECT_EQ(unit_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), Vector3d(0, 0, 0));
}

} // namespace
} // namespace alphamst::surface
