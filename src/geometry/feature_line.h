// FeatureLine: the straight line that a vertex on a surface may slide along.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "surface/curve.h"

namespace alphamst::geometry {

struct FeatureLine {
    surface::Line line;
    std::array<int, 2> between = {
        -1, -1}; // its neighbours on the line, not to be passed; -1: there is no feature line

    explicit operator bool() const { return between[0] >= 0; }

    // Strictly between the two, whichever of them comes first.
    bool holds(const Eigen::Vector3d &p, std::span<const Eigen::Vector3d> points) const {
        const double here = line.place(p), one = line.place(points[static_cast<std::size_t>(between[0])]),
                     other = line.place(points[static_cast<std::size_t>(between[1])]);
        return std::min(one, other) < here && here < std::max(one, other);
    }
};

} // namespace alphamst::geometry
