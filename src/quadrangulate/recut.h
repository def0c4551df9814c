// Quads that are triangles in shape.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// A triangle that became a quad by the midpoint of a side is flat there. With a neighbour across
// one of the other sides it is a hexagon, which is cut anew from the midpoint where that makes the
// worst corner better; a flat corner at an interior vertex, which can still move, counts for better than one
// on the boundary. flat: the sides that lead to such midpoints, counter-clockwise in their
// quads. on_boundary: of each vertex.
void recut(QuadArrays &quads, const Polygons &polygons, std::span<const std::array<std::int32_t, 2>> flat,
           const std::vector<bool> &on_boundary);

} // namespace alphamst::quadrangulate
