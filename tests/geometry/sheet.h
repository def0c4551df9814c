// Curved and flat sheets of quads, disks all of them, for the tests of maps to the plane.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geometry/parametrise.h"

namespace alphamst::geometry::samples {

using Eigen::Vector2d;
using Eigen::Vector3d;

inline constexpr double pi = std::numbers::pi;
inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
inline Vector3d turned(const Vector2d &p) {
    return Vector3d(3, -2, 1) +
           Eigen::AngleAxisd(1.1, Vector3d(1, 2, -3).normalized()) * Vector3d(p.x(), p.y(), 0);
}

inline Sheet flat(unsigned seed) {
    std::mt19937 random(seed);
    const auto shift = [&] { return 0.05 * static_cast<double>(random()) / std::mt19937::max(); };
    return {8, 6, [&](double s, double t) { return turned({2 * s + shift(), t + shift()}); }};
}

// Part of the sphere of radius 1 around its lowest point, seen from inside: n x n squares by
// stereographic projection, which keeps angles.
inline Sheet bowl(int n, double size) {
    return {n, n, [&](double s, double t) {
                const Vector2d p(size * (2 * s - 1), size * (2 * t - 1));
                const double scale = 2 / (1 + p.squaredNorm());
                return Vector3d(scale * p.x(), scale * p.y(), 1 - scale);
            }};
}

// The same sphere up to an angle from the lowest point, so that the loop is round.
inline Sheet pouch(double most) {
    return {14, 14, [&](double s, double t) {
                const double x = 2 * s - 1, y = 2 * t - 1;
                const Vector2d p(x * std::sqrt(1 - y * y / 2), y * std::sqrt(1 - x * x / 2));
                const double turn = most * p.norm(), scale = p.norm() > 0 ? std::sin(turn) / p.norm() : 0;
                return Vector3d(scale * p.x(), scale * p.y(), 1 - std::cos(turn));
            }};
}

// A spiral ramp of so many turns, hardly steep: what is flat and keeps its angles lies on itself.
inline Sheet ramp(double turns) {
    return {60, 3, [&](double s, double t) {
                const double angle = -2 * pi * turns * s, radius = 2 + t;
                return Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.6 * turns * s);
            }};
}

inline void expect_distances(const Points &positions, const std::vector<Vector3d> &points, double scale) {
    ASSERT_EQ(positions.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            ASSERT_NEAR((positions[i] - positions[j]).norm(), scale * (points[i] - points[j]).norm(), 1e-9);
}

template <class Vector> double angle(const Vector &a, const Vector &b, const Vector &c) {
    return std::acos((b - a).normalized().dot((c - a).normalized()));
}

// In degrees, of all corners of the quads.
inline double mean_angle_error(const Sheet &sheet, const Points &flat) {
    double sum = 0;
    for (const auto &q : sheet.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t a = at(q[k]), b = at(q[(k + 1) % 4]), c = at(q[(k + 3) % 4]);
            sum += std::abs(angle(flat[a], flat[b], flat[c]) -
                            angle(sheet.points[a], sheet.points[b], sheet.points[c]));
        }
    return sum / (4 * static_cast<double>(sheet.quads.size())) * 180 / pi;
}

inline bool bijective(const Sheet &sheet, const Points &positions) {
    return is_bijective(sheet.quads, sheet.boundary, positions);
}

} // namespace alphamst::geometry::samples
