// A face as a piece of surface: two triangles. No mesh is known here.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "quality/metric.h"

namespace alphamst::geometry {

using Quad = quality::Corners;

// Half the cross product of the diagonals: as long as the area of the quad, if that is flat.
inline Eigen::Vector3d area_vector(const Quad &quad) {
    return (quad[2] - quad[0]).cross(quad[3] - quad[1]) / 2;
}

inline Eigen::Vector3d centre(const Quad &quad) { return (quad[0] + quad[1] + quad[2] + quad[3]) / 4; }

// A point of a quad as an average of its corners, none of negative weight; or beyond it, see below.
struct QuadPoint {
    std::array<double, 4> weights{}; // of the corners; their sum is 1
    double distance = 0;             // squared
};

// The point of the quad that is nearest to `point`.
QuadPoint closest_point(const Quad &quad, const Eigen::Vector3d &point);

// The point of the plane of its nearest triangle that is nearest to `point`: beyond the quad some weights
// are negative, and a linear function is continued.
QuadPoint continued_point(const Quad &quad, const Eigen::Vector3d &point);

// The centroid of what it covers; of one without area the centre.
Eigen::Vector3d area_centroid(const Quad &quad);

struct Intersection {
    double area = 0;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero(); // if there is an area
};

// What `other` covers of `quad`, seen along the normal of `quad`. Only what faces the same
// side counts. The overlaps with quads that fill its plane sum up to its area but for rounding.
Intersection overlap(const Quad &quad, const Quad &other);

} // namespace alphamst::geometry
