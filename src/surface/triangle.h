// One triangle in space: its normal and its place nearest to a point.
#pragma once

#include <Eigen/Core>
#include <array>

namespace alphamst::surface {

struct Closest {
    Eigen::Vector3d point, weights; // weights of the three corners, their sum is 1
    double squared = 0;             // distance
};

// The ids tell two triangles the same about an edge they target_count: a place on it is computed from the
// corner of smaller id, so that both find the same place, to the last bit.
Closest closest(const Eigen::Vector3d &p, const std::array<Eigen::Vector3d, 3> &triangle,
                const std::array<int, 3> &ids);

// Zero if the triangle is degenerate.
Eigen::Vector3d unit_normal(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c);

} // namespace alphamst::surface
