// Boxes of things in space, by number, and the tree of them that finds those near a point.
#pragma once

#include <Eigen/Core>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <span>
#include <utility>

namespace alphamst::surface {

namespace spatial_index = boost::geometry::index;
using BoxCorner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<BoxCorner>;
using BoxEntry = std::pair<Box, int>;
using BoxTree = spatial_index::rtree<BoxEntry, spatial_index::rstar<16>>;

inline BoxCorner box_corner(const Eigen::Vector3d &p) { return {p.x(), p.y(), p.z()}; }

// Of at least one point, made wider by the margin on every side.
inline Box box_of(std::span<const Eigen::Vector3d> points, double margin = 0) {
    Eigen::Vector3d low = points[0], high = points[0];
    for (const Eigen::Vector3d &p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(margin);
    return {box_corner(low - around), box_corner(high + around)};
}

} // namespace alphamst::surface
