// Shape optimisation of an untangled disk.
#pragma once

#include "geometry/relax.h"

namespace alphamst::geometry {

// Sweeps of the barrier over the vertices that still move, then `sharpen` around the worst
// corners until the smallest scaled Jacobian no longer rises. Vertices at a corner that is not
// positive stay.
void optimise(const Problem &problem, Points &points, const EmbedOptions &options, Floor floor);

// The last step of it alone.
void sharpen_corners(const Problem &problem, Points &points, const EmbedOptions &options, Floor floor);

} // namespace alphamst::geometry
