// What the metrics of one quadrilateral are made of, in units of its own size.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "quality/metric.h"

namespace alphamst::quality {

// Verdict 1.4 counts smaller lengths and areas as zero (relative to the element) and
// reports no larger values.
inline constexpr double tiny = 2.2204460492503131e-15;
inline constexpr double huge = 1e30;

using Vector = Eigen::Vector3d;

// Never infinite and never NaN: what is undefined is reported as -huge, as Verdict does.
inline double bounded(double value) { return value > 0 ? std::min(value, huge) : std::fmax(value, -huge); }

// Unit vector, or zero where the direction is undefined.
inline Vector direction(const Vector &v) {
    const double length = v.norm();
    return length > 2 * tiny ? Vector(v / length) : Vector(Vector::Zero());
}

// Corner k lies between the edges k-1 and k. All lengths are divided by `size`, the
// diagonal of the bounding box, so that every metric but the areas is free of scale.
struct Element {
    explicit Element(const Corners &quad);

    double size = 1;
    std::array<Vector, 4> edge;        // from corner k to corner k+1
    std::array<double, 4> length;      // of the edges
    std::array<Vector, 2> diagonal;    // 0-2, 1-3
    std::array<Vector, 2> axis;        // twice the lines between midpoints of opposite edges
    std::array<Vector, 4> normal;      // cross products at the corners
    std::array<double, 4> corner_area; // normals measured along the normal of the centre

    bool collapsed() const { return edge[2].isZero(0); } // corners 2 and 3 coincide: a triangle
    double area() const { return (corner_area[0] + corner_area[1] + corner_area[2] + corner_area[3]) / 4; }
    double shortest() const { return *std::min_element(length.begin(), length.end()); }
    double longest() const { return *std::max_element(length.begin(), length.end()); }
};

double distortion(const Element &e);

} // namespace alphamst::quality
