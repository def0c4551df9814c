// Triangles among quads.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// Makes quads of all triangles: from each one a row of faces leads to another one, the edges
// across it get midpoints, and its quads are split along it. Of each component that has an odd number of
// triangles one row leads to the boundary. Adds to flat the sides of former triangles that lead to their
// midpoints.
void split_rows(QuadArrays &quads, std::vector<std::array<std::int32_t, 2>> &flat);

} // namespace alphamst::quadrangulate
