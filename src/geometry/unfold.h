// The quads around a vertex on a feature line, seen in a plane.
#pragma once

#include "geometry/star.h"

namespace alphamst::geometry {

// Quads on each side are turned about the feature line, which becomes the x-axis, until they are in the
// plane: however sharp the crease is, distances from the feature line stay. The vertex is point 0 and the
// origin; the sectors, which go all the way round, get points of their own. No sectors if they do not go
// round.
void unfold(std::span<const Sector> star, std::span<const Eigen::Vector3d> points, int vertex,
            const FeatureLine &feature_line, std::vector<Sector> &sectors, Points &flat);

} // namespace alphamst::geometry
