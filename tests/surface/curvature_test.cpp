#include "surface/curvature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "grid.h"
#include "mesh/curved.h"
#include "reference/surface_of.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

double largest(const std::vector<double> &values) { return *std::max_element(values.begin(), values.end()); }
double smallest(const std::vector<double> &values) { return *std::min_element(values.begin(), values.end()); }

Surface waves(double scale) {
    return grid(30, 20, [scale](double s, double t) {
        return Vector3d(scale * Vector3d(1.5 * s, t, 0.1 * std::sin(7 * s) * std::cos(5 * t)));
    });
}

TEST(Curvature, OfASphereIsOneOverItsRadius) {
    mesh::QuadMesh ball = mesh::sphere(24);
    for (const double radius : {0.2, 1.0, 30.0}) {
        mesh::QuadMesh sphere = ball;
        for (int v = 0; v < sphere.n_vertices(); ++v)
            sphere.set_point(v, ball.point(v) * radius);
        const auto surface = reference::surface_of(sphere);
        for (const int rings : {0, 1, 3}) {
            const std::vector<double> found = curvature(*surface, rings);
            ASSERT_EQ(found.size(), surface->points().size());
            // Normals are a little off where the triangles around a point are uneven.
            EXPECT_GT(smallest(found) * radius, 0.8) << rings;
            EXPECT_LT(largest(found) * radius, 1.25) << rings;
            const double sum = std::accumulate(found.begin(), found.end(), 0.0);
            EXPECT_NEAR(sum / static_cast<double>(found.size()) * radius, 1, 0.03) << rings;
        }
    }
}

TEST(Curvature, OfACylinderIsThatAcrossItsAxis) {
    const double radius = 2.5;
    const auto surface = reference::surface_of(mesh::grid(
        48, 20,
        [&](double s, double t) {
            return Vector3d(radius * std::cos(2 * pi * s), radius * std::sin(2 * pi * s), 6 * t);
        },
        true));
    for (const int rings : {0, 2})
        for (const double found : curvature(*surface, rings))
            EXPECT_NEAR(found * radius, 1, 1e-6) << rings;
}

// Two squares that meet at an angle, cut from point 0 and from point 1.
TEST(Curvature, CountsAtBothEndsOfAnEdge) {
    const Vector3d down(std::cos(0.7), 0, -std::sin(0.7)), y(0, 1, 0);
    const Surface surface({{-1, 0, 0}, {0, 0, 0}, y, {-1, 1, 0}, down, down + y},
                          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}});
    const Vector3d left(0, 0, 1), right(std::sin(0.7), 0, std::cos(0.7));
    const Vector3d middle = (left + 2 * right).normalized(), behind = (2 * left + right).normalized();
    const std::vector<double> found = curvature(surface, 0);
    EXPECT_NEAR(found[0], (middle - left).norm(), 1e-12);
    EXPECT_NEAR(found[3], (behind - left).norm(), 1e-12);
    EXPECT_NEAR(found[4], (middle - right).norm(), 1e-12);
    EXPECT_NEAR(found[5], (behind - right).norm(), 1e-12);
}

TEST(Curvature, OfAPlaneIsNone) {
    std::mt19937 random(3);
    const auto shift = [&] { return static_cast<double>(random() % 100) / 2000; };
    const Vector3d along = Vector3d(1, 2, 2) / 3, across = Vector3d(2, -2, 1) / 3;
    const Surface plane = grid(15, 15, [&](double s, double t) {
        const double u = s + shift(), v = t + shift();
        return Vector3d(Vector3d(3, 1, 4) + u * along + v * across);
    });
    for (const int rings : {0, 2})
        EXPECT_LT(largest(curvature(plane, rings)), 1e-12) << rings;
}

TEST(Curvature, IsOneOverLength) {
    for (const int rings : {0, 3}) {
        const std::vector<double> one = curvature(waves(1), rings);
        for (const double scale : {0.125, 3.0, 1e6}) {
            const std::vector<double> other = curvature(waves(scale), rings);
            for (std::size_t i = 0; i < one.size(); ++i)
                EXPECT_NEAR(other[i] * scale, one[i], 1e-9 * one[i]);
        }
    }
}

TEST(Curvature, MoreRingsSmoothMore) {
    const Surface surface = waves(1);
    double range = HUGE_VAL;
    for (int rings = 0; rings < 6; ++rings) {
        const std::vector<double> found = curvature(surface, rings);
        EXPECT_LT(largest(found) - smallest(found), 0.99 * range) << rings;
        range = largest(found) - smallest(found);
    }
}

TEST(Curvature, OfRipplesFinerThanTheRingsDoesNotCount) {
    const Surface rippled =
        grid(40, 40, [](double s, double t) { return Vector3d(s, t, 0.002 * std::sin(pi / 2 * 40 * s)); });
    const std::size_t middle = 20 * 41 + 20;
    EXPECT_GT(curvature(rippled, 0)[middle], 3);
    EXPECT_LT(curvature(rippled, 6)[middle], 0.2);
}

// Nor on the order of points and triangles, but for rounding.
TEST(Curvature, DoesNotDependOnAnythingElse) {
    const Surface surface = waves(1);
    const std::vector<double> found = curvature(surface, 3);
    EXPECT_EQ(curvature(surface, 3), found);
    std::vector<int> order(surface.points().size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(5);
    for (std::size_t i = order.size() - 1; i > 0; --i)
        std::swap(order[i], order[random() % (i + 1)]);
    std::vector<Vector3d> points(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        points[static_cast<std::size_t>(order[i])] = surface.points()[i];
    std::vector<std::array<int, 3>> triangles;
    for (auto t = surface.triangles().rbegin(); t != surface.triangles().rend(); ++t) {
        triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            triangles.back()[k] = order[static_cast<std::size_t>((*t)[(k + 1) % 3])];
    }
    const std::vector<double> other = curvature(Surface(points, triangles), 3);
    for (std::size_t i = 0; i < order.size(); ++i)
        EXPECT_NEAR(other[static_cast<std::size_t>(order[i])], found[i], 1e-12);
}

} // namespace
} // namespace alphamst::surface
