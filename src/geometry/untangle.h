// Turning every corner positive.
#pragma once

#include "geometry/star.h"

namespace alphamst::geometry {

// Garanzha et al. (2021): minimises the regularised barrier while epsilon falls with the
// worst corner. First vertex by vertex near the bad corners, then, for what is left, by
// Newton's method on all vertices of a region around them that grows up to the whole.
// True if every corner is positive.
bool untangle(const Problem &problem, Points &points, int sweeps);

} // namespace alphamst::geometry
