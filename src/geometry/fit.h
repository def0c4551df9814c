// Quads brought nearer to a curved surface between their vertices, which stay on it.
#pragma once

#include <span>

#include "geometry/cover.h"
#include "geometry/surface_positions.h"

namespace alphamst::geometry {

// Moves the free vertices over the surface by Gauss-Newton steps on all of them at once, for less of the
// squared distance of quads and surface, and of samples of the surface and quads, weighed against shape and
// wanted area (options.area; else all equal): vertices come to ridges, edges turn along curvature and quads
// get longer where it bends less. No scaled Jacobian below 0.32 comes about or falls by that. O(quads) a
// step.
void fit(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
         SurfacePositions &on_surface, const EmbedOptions &options, std::span<const Sample> samples = {});

} // namespace alphamst::geometry
