// Turning every corner positive.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/star.h"

namespace alphamst::geometry {

// Garanzha et al. (2021): minimises the regularised barrier while epsilon falls with the
// worst corner. First vertex by vertex near the bad corners, then, for what is left, by
// Newton's method on all vertices of a region around them that grows up to the whole.
// True if every corner is positive. Gives up where a wider region does not move the worst corner.
// The effort, in vertices times iterations of Newton's method, is at most `effort`, which is
// lowered by what was spent: so the time is bounded by a multiple of the number of vertices also
// where there is no solution.
// Unless `patient`, one narrow region is all that Newton's method gets.
bool untangle(const Problem &problem, Points &points, int sweeps, std::ptrdiff_t &effort,
              bool patient = true);

// The quads with a corner that is not positive, the worst first.
std::vector<int> tangled(const Problem &problem, const Points &points);

// Effort that a disk deserves.
std::ptrdiff_t untangling_effort(const Problem &problem);

} // namespace alphamst::geometry
