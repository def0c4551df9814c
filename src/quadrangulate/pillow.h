// Quads that nothing else mends.
#pragma once

#include <vector>

#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// A quad with a corner of 180 degrees or more at a vertex that is fixed becomes five: four along its
// sides around a smaller one (pillowing, Mitchell and Tautges 1995), if that makes them convex. Its corners
// and sides stay.
void pillow(QuadArrays &quads, const std::vector<bool> &fixed);

} // namespace alphamst::quadrangulate
