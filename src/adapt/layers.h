// Boundary layers: rows of faces much longer than they are high, made so on purpose. Windows and smoothing
// know nothing of directions and would even them out.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::adapt {

// The faces of layers, ascending.
std::vector<int> layers_of(const mesh::QuadMesh &mesh);
// Makes the faces of layers FIXED, the most stretched first, half of the faces at most; none where the mesh
// is to become much coarser. How many.
std::int64_t hold_layers(mesh::QuadMesh &mesh, std::int64_t wanted);
// As they were before.
void release_layers(mesh::QuadMesh &mesh);

} // namespace alphamst::adapt
