// Turns faces over until neighbours run the same way round.
#pragma once

#include "mesh/sides.h"

namespace alphamst::mesh {

struct Oriented {
    std::vector<std::int32_t> faces; // empty: none had to be turned over
    std::int64_t n_turned = 0, first_turned = -1;
};

// In the plane components become counter-clockwise by their whole area, so that a single inverted face stays
// one; in space as most of their faces are, or the first. The first corner of a face stays the first. Throws
// what find_lasting_defects says where faces run both ways.
Oriented orient(int dim, Coordinates points, Faces faces);

} // namespace alphamst::mesh
