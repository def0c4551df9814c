// Angles between directions.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace alphamst::surface {

// 0 .. 180; 0 if one of them has no length.
inline double degrees_between(const Eigen::Vector3d &u, const Eigen::Vector3d &v) {
    return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

} // namespace alphamst::surface
