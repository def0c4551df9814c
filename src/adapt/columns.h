// Walls with layers: where rows of stretched faces lie along the boundary, columns of faces across them come
// and go, so that the rows keep their heights.
#pragma once

#include <cstdint>

#include "mesh/quad_mesh.h"
#include "settings.h"

namespace alphamst::adapt {

// Brings a plane mesh that consists of rows and columns nearer to the wanted number of faces, by columns
// alone, as evenly as it goes; the boundary may change. Whether it did; other meshes stay as they are.
bool adapt_columns(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings);

} // namespace alphamst::adapt
