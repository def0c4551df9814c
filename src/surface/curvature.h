// How much a surface bends.
#pragma once

#include <vector>

#include "surface/surface.h"

namespace alphamst::surface {

// [point] most that the normal inverts the way along an edge, radians over length, of normals averaged
// over so many rings of triangles: what bends on a smaller scale does not count.
std::vector<double> curvature(const Surface &surface, int rings);

} // namespace alphamst::surface
