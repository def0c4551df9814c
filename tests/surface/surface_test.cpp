#include "surface/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "failure.h"
#include "grid.h"
#include "surface/triangle.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;
using Triangles = std::vector<std::array<int, 3>>;

double chance(std::mt19937 &random) { return static_cast<double>(random()) / 4294967296.0; }

Vector3d anywhere(std::mt19937 &random, double reach) {
    const double x = chance(random), y = chance(random), z = chance(random);
    return (Vector3d(x, y, z) * 2 - Vector3d::Ones()) * reach;
}

// Its poles and its seam are many points at one place, and triangles without area at the poles.
Surface bumpy_sphere(int n) {
    return grid(2 * n, n, [](double s, double t) {
        const double u = 2 * std::numbers::pi * s, v = std::numbers::pi * (t - 0.5);
        const double r = 1 + 0.1 * std::sin(5 * u) * std::cos(v) * std::cos(4 * v);
        return Vector3d(r * std::cos(u) * std::cos(v), r * std::sin(u) * std::cos(v), r * std::sin(v));
    });
}

// Two squares of side 1, one 0.01 above the other, that look up and down.
Surface thin_plate(int n) {
    std::vector<Vector3d> points;
    Triangles triangles;
    for (const double z : {0.0, 0.01}) {
        const Surface side =
            grid(n, n, [&](double s, double t) { return z > 0 ? Vector3d(s, t, z) : Vector3d(t, s, z); });
        const int first = static_cast<int>(points.size());
        points.insert(points.end(), side.points().begin(), side.points().end());
        for (const auto &[a, b, c] : side.triangles())
            triangles.push_back({first + a, first + b, first + c});
    }
    return {points, triangles};
}

// Of side 2 around the origin, each side of two triangles.
Surface cube() {
    std::vector<Vector3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    Triangles triangles;
    for (const auto &[a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return {points, triangles};
}

// By a search through all; -1 if none is accepted.
template <class Accept> int nearest_of_all(const Surface &surface, const Vector3d &p, const Accept &accept) {
    int best = -1;
    double least = HUGE_VAL;
    for (int t = 0; t < static_cast<int>(surface.triangles().size()); ++t) {
        if (!accept(t))
            continue;
        const auto &ids = surface.triangles()[static_cast<std::size_t>(t)];
        std::array<Vector3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = surface.points()[static_cast<std::size_t>(ids[i])];
        if (const double squared = closest(p, corners, ids).squared; squared < least) {
            least = squared;
            best = t;
        }
    }
    return best;
}

Vector3d weights_of(const Surface &surface, const Spot &spot) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) {
        const auto &ids = surface.triangles()[static_cast<std::size_t>(spot.triangle)];
        corners.col(i) = surface.points()[static_cast<std::size_t>(ids[static_cast<std::size_t>(i)])];
    }
    return corners.inverse() * spot.point;
}

void expect_near(const Vector3d &a, const Vector3d &b, double tolerance) {
    EXPECT_LE((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

TEST(Surface, NearestIsThatOfASearchThroughAll) {
    std::mt19937 random(1);
    const Surface surface = bumpy_sphere(20);
    for (int i = 0; i < 1000; ++i) {
        Vector3d p = anywhere(random, i % 2 ? 1.2 : 4);
        if (i % 5 == 0) // at a corner of several triangles
            p = surface.points()[random() % surface.points().size()];
        const Spot spot = surface.nearest(p);
        EXPECT_EQ(spot.triangle, nearest_of_all(surface, p, [](int) { return true; }));
        EXPECT_EQ(spot.distance, (p - spot.point).norm());
        EXPECT_NEAR(spot.normal.norm(), 1, 1e-14);
    }
}

TEST(Surface, NearestOfLikeNormalIsThatOfASearchThroughAll) {
    std::mt19937 random(2);
    const Surface surface = bumpy_sphere(15);
    const double least = std::cos(75 * std::numbers::pi / 180);
    for (int i = 0; i < 500; ++i) {
        const Vector3d p = anywhere(random, 1.5), normal = anywhere(random, 3);
        const auto like = [&](int t) { return surface.normal(t).dot(normal) > least * normal.norm(); };
        const Spot spot = surface.nearest(p, normal);
        EXPECT_TRUE(like(spot.triangle));
        EXPECT_EQ(spot.triangle, nearest_of_all(surface, p, like));
    }
}

TEST(Surface, NormalKeepsToOneSideOfAPlate) {
    std::mt19937 random(3);
    const Surface surface = thin_plate(8);
    for (int i = 0; i < 200; ++i) {
        const Vector3d p(chance(random), chance(random), 0.03 * chance(random) - 0.01);
        const double up = i % 2 ? 2 : -2;
        const Spot spot = surface.nearest(p, Vector3d(0.5, 0, up));
        EXPECT_EQ(spot.point.z(), up > 0 ? 0.01 : 0);
        expect_near(spot.normal, Vector3d::UnitZ() * (up > 0 ? 1 : -1), 1e-15);
        EXPECT_EQ(surface.nearest(p).point.z(), p.z() > 0.005 ? 0.01 : 0);
    }
}

TEST(Surface, NormalOfNoTriangleAsksForTheNearestOfAll) {
    const Surface surface = thin_plate(3);
    for (const Vector3d &normal : {Vector3d(1, 0, 0), Vector3d(0, 0, 0)})
        for (const double z : {-0.2, 0.2}) {
            const Vector3d p(0.4, 0.7, z);
            EXPECT_EQ(surface.nearest(p, normal).triangle, surface.nearest(p).triangle);
        }
}

// A short way from the spot, on the surface or a little off, and not across the seam, where triangles
// have no points in common.
Vector3d near(const Surface &surface, const Spot &spot, bool off, std::mt19937 &random) {
    for (;;) {
        const Vector3d p = spot.point + anywhere(random, 0.05);
        const Spot there = surface.nearest(p);
        if (there.point.x() < -0.1 && std::abs(there.point.z()) < 0.7)
            return off ? Vector3d(there.point + 0.02 * there.normal) : there.point;
    }
}

TEST(Surface, FollowIsTheNearestAfterAShortWay) {
    std::mt19937 random(4);
    const Surface surface = bumpy_sphere(40);
    Spot spot = surface.nearest({-1.1, 0.3, 0.2});
    int ways = 0, same = 0;
    for (int i = 0; i < 2000; ++i) {
        const bool off = i % 2 == 1;
        const Vector3d p = near(surface, spot, off, random);
        const Spot next = surface.nearest(p), followed = surface.follow(p, spot.triangle);
        ways += next.triangle != spot.triangle;
        same += next.triangle == followed.triangle;
        if (off) // beside a hollow edge there are two near places
            EXPECT_LE(followed.distance, 1.02 * next.distance);
        else
            expect_near(followed.point, p, 1e-14);
        expect_near(followed.normal, next.normal, 0.02);
        spot = next;
    }
    EXPECT_GT(ways, 1300);
    EXPECT_GT(same, 1960);
}

TEST(Surface, FollowCrossesATriangleWithoutArea) {
    for (const bool last : {false, true}) {
        Triangles triangles{{0, 2, 3}, {0, 4, 1}, {1, 4, 2}};
        triangles.insert(last ? triangles.end() : triangles.begin(), {0, 1, 2}); // points in one line
        const Surface surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}}, triangles);
        for (const Vector3d &p : {Vector3d(0.6, 0.3, 0.1), Vector3d(0.8, -0.3, 0.1), Vector3d(1.4, 0.2, 0.1)})
            for (int t = 0; t < 4; ++t)
                expect_near(surface.follow(p, t).point, {p.x(), p.y(), 0}, 1e-15);
    }
}

TEST(Surface, FollowStaysWhereItIsConnected) {
    const Surface surface = thin_plate(4);
    const Vector3d above(0.3, 0.9, 0.1);
    EXPECT_EQ(surface.nearest(above).point.z(), 0.01);
    const Spot spot = surface.follow(above, 0);
    expect_near(spot.point, Vector3d(0.3, 0.9, 0), 1e-15);
    EXPECT_NEAR(spot.distance, 0.1, 1e-15);
}

TEST(Surface, NormalsAreSharpAtTheEdgesOfACube) {
    const Surface surface = cube();
    EXPECT_DOUBLE_EQ(surface.area(), 24);
    for (int t = 0; t < 12; ++t)
        for (int i = 0; i < 3; ++i)
            expect_near(surface.normal_at(t, Vector3d::Unit(i)), surface.normal(t), 1e-15);
    const Spot side = surface.nearest({0.9, 0.3, 1.4});
    expect_near(side.point, {0.9, 0.3, 1}, 1e-15);
    expect_near(side.normal, {0, 0, 1}, 1e-15);
    const Spot edge = surface.nearest({1.2, 0.3, 1.4});
    EXPECT_EQ(edge.triangle, 2); // and 11, which has the edge, too
    expect_near(edge.normal, {0, 0, 1}, 1e-15);
}

TEST(Surface, NormalsOfASmoothSurfaceAreBlended) {
    const int n = 40;
    const Surface surface = grid(2 * n, n, [](double s, double t) {
        const double u = 2 * std::numbers::pi * s, v = std::numbers::pi * (t - 0.5) * 0.6;
        return Vector3d(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
    });
    std::mt19937 random(5);
    double flat = 0, blended = 0; // largest errors
    for (int i = 0; i < 500; ++i) {
        const Spot spot = surface.nearest(Vector3d(-1, chance(random) - 0.5, chance(random) - 0.5));
        const Vector3d exact = spot.point.normalized();
        blended = std::max(blended, (spot.normal - exact).norm());
        flat = std::max(flat, (surface.normal(spot.triangle) - exact).norm());
        expect_near(surface.normal_at(spot.triangle, weights_of(surface, spot)), spot.normal, 1e-10);
    }
    EXPECT_LT(blended, 0.005);
    EXPECT_GT(flat, 0.03);
}

TEST(Surface, NormalsAreBlendedBelowFortyDegreesOnly) {
    for (const double angle : {39.0, 41.0}) {
        const double a = angle * std::numbers::pi / 180;
        // Two squares with the y axis between them, the second one turned up.
        const Surface surface({{-1, 0, 0},
                               {0, 0, 0},
                               {0, 1, 0},
                               {-1, 1, 0},
                               {std::cos(a), 0, std::sin(a)},
                               {std::cos(a), 1, std::sin(a)}},
                              {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}});
        const Spot spot = surface.nearest({0, 0.5, -1});
        EXPECT_EQ(spot.triangle, 0);
        const double turned = angle < 40 ? a / 2 : 0;
        expect_near(spot.normal, {-std::sin(turned), 0, std::cos(turned)}, 1e-12);
    }
}

TEST(Surface, OfEqualTrianglesTheFirstIsNearest) {
    // Irregular, so that the same edge seen from two triangles would be rounded in two ways.
    std::mt19937 random(6);
    for (int i = 0; i < 300; ++i) {
        const Vector3d a = anywhere(random, 1), b = a + Vector3d(0.1, 1, 0.2),
                       c = a + Vector3d(-1, 0.3, -0.5), d = a + Vector3d(1, 0.4, -0.5);
        const Surface one({a, b, c, d}, {{0, 1, 2}, {1, 0, 3}});
        const Surface other({a, b, c, d}, {{1, 0, 3}, {0, 1, 2}});
        const Vector3d above = a + (0.2 + 0.6 * chance(random)) * (b - a) + Vector3d(0, 0, 1);
        EXPECT_EQ(one.nearest(above).triangle, 0);
        EXPECT_EQ(other.nearest(above).triangle, 0);
        EXPECT_EQ(one.follow(above, 1).triangle, 0);
        EXPECT_EQ(one.nearest(above).point, other.nearest(above).point);
    }
}

TEST(Surface, ToleratesTrianglesWithoutArea) {
    const Surface surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {5, 5, 5}},
                          {{0, 1, 2}, {0, 2, 3}, {4, 4, 4}, {3, 3, 1}});
    EXPECT_EQ(surface.normal(0), Vector3d::Zero());
    const Spot spot = surface.nearest({1.5, -1, 0});
    EXPECT_EQ(spot.triangle, 0);
    expect_near(spot.point, {1.5, 0, 0}, 1e-15);
    expect_near(spot.normal, {0, 0, 1}, 1e-15); // of its neighbour
    EXPECT_EQ(surface.nearest({6, 6, 6}).triangle, 2);
    EXPECT_NEAR(surface.nearest({6, 6, 6}).normal.norm(), 1, 1e-15);
    expect_near(surface.nearest({1, 0.5, 1}).point, {1, 0.5, 0}, 1e-15);
}

TEST(Surface, RefusesWhatIsNoSurface) {
    const auto fault = [](std::vector<Vector3d> points, Triangles triangles) {
        try {
            const Surface surface(std::move(points), std::move(triangles));
        } catch (const Failure &failure) {
            return std::pair(failure.fault, failure.ids);
        }
        return std::pair(Fault::internal, std::vector<std::int64_t>{});
    };
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    using Ids = std::vector<std::int64_t>;
    EXPECT_EQ(fault(points, {}), std::pair(Fault::range, Ids{}));
    EXPECT_EQ(fault(points, {{0, 1, 2}, {0, 1, 3}}), std::pair(Fault::range, Ids{1, 3}));
    EXPECT_EQ(fault(points, {{0, -1, 2}}), std::pair(Fault::range, Ids{0, -1}));
    EXPECT_EQ(fault({{0, 0, 0}, {1, NAN, 0}, {0, 1, 0}}, {{0, 1, 2}}), std::pair(Fault::not_finite, Ids{1}));
}

} // namespace
} // namespace alphamst::surface
