#include "geometry/parametrise.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/tutte.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
std::size_t at(int i) { return static_cast<std::size_t>(i); }

// n x m quads with a vertex at place(0..1, 0..1), those of the loop first.
struct Sheet {
    std::vector<std::array<int, 4>> quads;
    std::vector<Vector3d> points;
    int boundary;

    Sheet(int n, int m, const std::function<Vector3d(double, double)> &place) : boundary(2 * (n + m)) {
        std::vector<std::pair<int, int>> order;
        for (int i = 0; i < n; ++i)
            order.emplace_back(i, 0);
        for (int j = 0; j < m; ++j)
            order.emplace_back(n, j);
        for (int i = n; i > 0; --i)
            order.emplace_back(i, m);
        for (int j = m; j > 0; --j)
            order.emplace_back(0, j);
        for (int j = 1; j < m; ++j)
            for (int i = 1; i < n; ++i)
                order.emplace_back(i, j);
        std::vector<int> number(at((n + 1) * (m + 1)));
        for (const auto &[i, j] : order) {
            number[at(j * (n + 1) + i)] = static_cast<int>(points.size());
            points.push_back(place(double(i) / n, double(j) / m));
        }
        const auto id = [&](int i, int j) { return number[at(j * (n + 1) + i)]; };
        for (int j = 0; j < m; ++j)
            for (int i = 0; i < n; ++i)
                quads.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
    }
    Disk disk() const { return {quads, boundary, points}; }
};

// Into space by a turn that is along no axis.
Vector3d turned(const Vector2d &p) {
    return Vector3d(3, -2, 1) +
           Eigen::AngleAxisd(1.1, Vector3d(1, 2, -3).normalized()) * Vector3d(p.x(), p.y(), 0);
}

Sheet flat(unsigned seed) {
    std::mt19937 random(seed);
    const auto shift = [&] { return 0.05 * static_cast<double>(random()) / std::mt19937::max(); };
    return {8, 6, [&](double s, double t) { return turned({2 * s + shift(), t + shift()}); }};
}

// Part of the sphere of radius 1 around its lowest point, seen from inside: n x n squares by
// stereographic projection, which keeps angles.
Sheet bowl(int n, double size) {
    return {n, n, [&](double s, double t) {
                const Vector2d p(size * (2 * s - 1), size * (2 * t - 1));
                const double scale = 2 / (1 + p.squaredNorm());
                return Vector3d(scale * p.x(), scale * p.y(), 1 - scale);
            }};
}

// The same sphere up to an angle from the lowest point, so that the loop is round.
Sheet pouch(double most) {
    return {14, 14, [&](double s, double t) {
                const double x = 2 * s - 1, y = 2 * t - 1;
                const Vector2d p(x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2));
                const double turn = most * p.norm(), scale = p.norm() > 0 ? std::sin(turn) / p.norm() : 0;
                return Vector3d(scale * p.x(), scale * p.y(), 1 - std::cos(turn));
            }};
}

// A spiral ramp of so many turns, hardly steep: what is flat and keeps its angles lies on itself.
Sheet ramp(double turns) {
    return {60, 3, [&](double s, double t) {
                const double angle = -2 * pi * turns * s, radius = 2 + t;
                return Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.6 * turns * s);
            }};
}

void expect_distances(const Points &positions, const std::vector<Vector3d> &points, double scale) {
    ASSERT_EQ(positions.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            ASSERT_NEAR((positions[i] - positions[j]).norm(), scale * (points[i] - points[j]).norm(), 1e-9);
}

template <class Vector> double angle(const Vector &a, const Vector &b, const Vector &c) {
    return std::acos((b - a).normalized().dot((c - a).normalized()));
}

// In degrees, of all corners of the quads.
double mean_angle_error(const Sheet &sheet, const Points &flat) {
    double sum = 0;
    for (const auto &q : sheet.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t a = at(q[k]), b = at(q[(k + 1) % 4]), c = at(q[(k + 3) % 4]);
            sum += std::abs(angle(flat[a], flat[b], flat[c]) -
                            angle(sheet.points[a], sheet.points[b], sheet.points[c]));
        }
    return sum / (4 * static_cast<double>(sheet.quads.size())) * 180 / pi;
}

bool bijective(const Sheet &sheet, const Points &positions) {
    return is_bijective(sheet.quads, sheet.boundary, positions);
}

TEST(Parametrise, ConformalGivesAFlatDiskBack) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Sheet sheet = flat(seed);
        const Points positions = conformal(sheet.disk());
        expect_distances(positions, sheet.points, 1);
        EXPECT_TRUE(bijective(sheet, positions)); // not its mirror image
        EXPECT_NEAR(stretch(sheet.disk(), positions), 1, 1e-9);
    }
}

TEST(Parametrise, ConformalUnrollsHalfACylinder) {
    const int n = 20;
    const Sheet sheet(n, 8, [](double s, double t) {
        return Vector3d(std::cos(pi * s), 1.5 * (1 - t), std::sin(pi * s)); // from inside
    });
    const Sheet unrolled(
        n, 8, [](double s, double t) { return Vector3d(2 * n * std::sin(pi / 2 / n) * s, 1.5 * t, 0); });
    expect_distances(conformal(sheet.disk()), unrolled.points, 1);
}

TEST(Parametrise, MeanValuesGiveARegularPolygonBack) {
    std::mt19937 random(2);
    const auto shift = [&] { return 0.02 * (2.0 * static_cast<double>(random()) / std::mt19937::max() - 1); };
    Sheet sheet(8, 8, [](double, double) { return Vector3d(0, 0, 0); });
    const std::vector<double> equal(at(sheet.boundary), 2 * pi / sheet.boundary); // circle of radius 1
    const Points even =
        embed_on_circle(sheet.quads, sheet.boundary, static_cast<int>(sheet.points.size()), equal);
    for (std::size_t v = 0; v < even.size(); ++v)
        sheet.points[v] = turned(even[v] + (v < equal.size() ? 0 : 1) * Vector2d(shift(), shift()));
    const Points positions = mean_value_on_circle(sheet.disk());
    // A polygon of the length of a circle has a larger one around it.
    expect_distances(positions, sheet.points, sheet.boundary * std::sin(pi / sheet.boundary) / pi);
    EXPECT_TRUE(bijective(sheet, positions));
}

TEST(Parametrise, ConformalKeepsAngles) {
    for (const double size : {0.4, 0.7}) {
        const Sheet coarse = bowl(12, size), fine = bowl(24, size);
        const Points kept = conformal(coarse.disk());
        const double error = mean_angle_error(coarse, kept);
        EXPECT_TRUE(bijective(coarse, kept));
        EXPECT_LT(error, 2.5);
        EXPECT_LT(5 * error, mean_angle_error(coarse, mean_value_on_circle(coarse.disk())));
        EXPECT_NEAR(mean_angle_error(fine, conformal(fine.disk())) / error, 0.5, 0.02); // to nothing
    }
}

TEST(Parametrise, LowStretchStretchesLess) {
    for (const auto &[sheet, part] :
         {std::pair(pouch(1), 0.4), {pouch(2), 0.4}, {pouch(2.5), 0.4}, {bowl(12, 0.9), 0.8}}) {
        const Points round = mean_value_on_circle(sheet.disk()), low = low_stretch_on_circle(sheet.disk());
        ASSERT_TRUE(bijective(sheet, round));
        ASSERT_TRUE(bijective(sheet, low));
        for (std::size_t i = 0; i < at(sheet.boundary); ++i)
            EXPECT_EQ(low[i], round[i]);
        EXPECT_GE(stretch(sheet.disk(), low), 1);
        EXPECT_LT(stretch(sheet.disk(), low) - 1, part * (stretch(sheet.disk(), round) - 1));
    }
}

TEST(Parametrise, LoopIsOnACircleSpacedByLength) {
    const Sheet sheet = bowl(12, 0.7);
    for (const Points &positions :
         {mean_value_on_circle(sheet.disk()), low_stretch_on_circle(sheet.disk())}) {
        ASSERT_EQ(positions.size(), sheet.points.size());
        double length = 0;
        for (std::size_t i = 0; i < at(sheet.boundary); ++i)
            length += (sheet.points[(i + 1) % at(sheet.boundary)] - sheet.points[i]).norm();
        for (std::size_t i = 0; i < at(sheet.boundary); ++i) {
            const Vector2d &p = positions[i], &next = positions[(i + 1) % at(sheet.boundary)];
            EXPECT_NEAR(p.norm(), length / (2 * pi), 1e-12);
            EXPECT_NEAR(std::asin((p.x() * next.y() - p.y() * next.x()) / p.squaredNorm()) * p.norm(),
                        (sheet.points[(i + 1) % at(sheet.boundary)] - sheet.points[i]).norm(), 1e-9);
        }
    }
}

TEST(Parametrise, WhatLiesOnItselfIsFound) {
    const Sheet half = ramp(0.5), twice = ramp(1.5);
    EXPECT_TRUE(bijective(half, conformal(half.disk())));
    const Points folded = conformal(twice.disk());
    EXPECT_TRUE(shapes_of(twice.quads, folded).valid); // no quad alone tells
    EXPECT_FALSE(bijective(twice, folded));
    EXPECT_TRUE(bijective(twice, mean_value_on_circle(twice.disk())));
    EXPECT_TRUE(bijective(twice, low_stretch_on_circle(twice.disk())));
    // And a quad that is turned over, in a loop that is as it was.
    const Sheet sheet = flat(1);
    Points turned_over = conformal(sheet.disk());
    turned_over.back() = turned_over.front();
    EXPECT_FALSE(bijective(sheet, turned_over));
}

TEST(Parametrise, SimpleLoops) {
    const auto simple = [](Points loop) {
        bool same = is_simple(loop);
        for (std::size_t i = 0; i < loop.size(); ++i) { // wherever it begins
            std::rotate(loop.begin(), loop.begin() + 1, loop.end());
            EXPECT_EQ(is_simple(loop), same);
        }
        return same;
    };
    EXPECT_TRUE(simple({{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_TRUE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}));
    EXPECT_TRUE(simple({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}})); // in line
    EXPECT_TRUE(simple({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {2, 3}, {0, 1}}));                 // likewise
    EXPECT_FALSE(simple({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));                                // crosses
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));                        // touches an edge
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));                // at a vertex
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));                                // back on itself
    EXPECT_FALSE(simple({{0, 0}, {1, 0}}));
}

TEST(Parametrise, NoPositionsWithoutASolution) {
    const Sheet point(4, 4, [](double, double) { return Vector3d(1, 2, 3); });
    EXPECT_TRUE(conformal(point.disk()).empty());
    EXPECT_TRUE(mean_value_on_circle(point.disk()).empty());
    EXPECT_TRUE(low_stretch_on_circle(point.disk()).empty());
    Sheet pinched = bowl(12, 0.7);
    pinched.points.back() = pinched.points[pinched.points.size() - 2];
    EXPECT_TRUE(mean_value_on_circle(pinched.disk()).empty());
}

TEST(Parametrise, StretchIsTheRootMeanSquareOfSingularValues) {
    const Sheet sheet(4, 4, [](double s, double t) { return Vector3d(6 * s, 2 * t, 0); });
    Points square; // 3 times as long as wide
    for (const Vector3d &p : sheet.points)
        square.emplace_back(p.x() / 3, p.y());
    // Singular values 3 and 1: root of (9 + 1) / 2, over the root of the growth of area.
    EXPECT_NEAR(stretch(sheet.disk(), square), std::sqrt(5.0 / 3), 1e-12);
    for (const double s : vertex_stretch(sheet.disk(), square))
        EXPECT_NEAR(s, std::sqrt(5.0), 1e-12);
}

} // namespace
} // namespace alphamst::geometry
