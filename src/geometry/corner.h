// The triangles at the corners of quads: four of each, which count half, so that no diagonal is preferred.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "geometry/embed.h"

namespace alphamst::geometry {

// Corner k and the ends of its sides, counter-clockwise.
inline std::array<int, 3> corner_of(const std::array<int, 4> &quad, std::size_t k) {
    return {quad[k], quad[(k + 1) % 4], quad[(k + 3) % 4]};
}

// A triangle laid in a plane: its first corner at the origin, the second on the x axis.
struct FlatTriangle {
    Eigen::Vector2d second, third;
    double twice_area = 0; // not negative

    FlatTriangle(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c) {
        const Eigen::Vector3d side = b - a, other = c - a;
        const double length = side.norm();
        twice_area = side.cross(other).norm();
        second = {length, 0};
        third = length > 0 ? Eigen::Vector2d(side.dot(other) / length, twice_area / length)
                           : Eigen::Vector2d(0, other.norm());
    }
};

} // namespace alphamst::geometry
