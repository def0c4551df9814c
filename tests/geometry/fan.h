// A star of quads for the tests of moving one vertex.
#pragma once

#include <array>
#include <vector>

#include "geometry/star.h"

namespace alphamst::geometry::samples {

// A vertex with three quads around it, some of them folded for some positions.
struct Fan {
    std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
    Stars stars{quads, 7};
    Points points{{0.1, 0.2}, {1, 0.1}, {0.6, 0.9}, {-0.5, 0.8}, {-1, 0}, {-0.4, -0.9}, {0.7, -0.8}};
    std::vector<double> area{1.0, 0.5, 2.0};
};

} // namespace alphamst::geometry::samples
