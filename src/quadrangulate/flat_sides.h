// The flat sides of a body, and what is to be done about those with an odd number of triangles.
#pragma once

#include "quadrangulate/pairing.h"

namespace alphamst::quadrangulate {

// TriangleSides are what sharp edges part. One with an odd number of triangles is united with its neighbour
// over the bluntest edge where a quad would be sound, preferably one with an odd number, too: the sharp edges
// between them become creases. One of each component with an odd number in all can do without, if it is on
// the boundary.
void unite_odd_sides(mesh::Coordinates points, mesh::Faces faces, TriangleSides &sides);

} // namespace alphamst::quadrangulate
