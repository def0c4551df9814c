// Quads turned towards given directions.
#pragma once

#include <Eigen/Core>
#include <span>

#include "geometry/surface_positions.h"

namespace alphamst::geometry {

// Moves the free vertices over the surface so that the sides of each quad come nearer to its direction, and
// to right angles with it: each towards the mean of where the corners of squares of the wanted areas
// (options.area; else all equal) would be that lie along the directions (after Bouaziz et al. 2012,
// "Shape-up: shaping discrete geometry with projections"). No scaled Jacobian below 0.4 comes about or falls
// by that. directions: [quad], not zero; options.steps sweeps.
void align(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
           std::span<const Eigen::Vector3d> directions, SurfacePositions &on_surface,
           const EmbedOptions &options);

} // namespace alphamst::geometry
