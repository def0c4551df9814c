// Free vertices in classes whose members share no quad, to be moved at the same time.
#pragma once

#include <vector>

#include "geometry/star.h"

namespace alphamst::geometry {

// Greedy, in the order of the vertices: O(quads). Few classes: 5 to 9 on quad meshes.
std::vector<std::vector<int>> colour(const Problem &problem);

} // namespace alphamst::geometry
