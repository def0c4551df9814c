// The reference surface of a mesh: the shape that its vertices keep to while they move.
#pragma once

#include <memory>

#include "mesh/quad_mesh.h"
#include "surface/surface.h"

namespace alphamst::mesh {

// The mesh as it is: point i is vertex i, triangles 2 f and 2 f + 1 are face f, cut along the shorter
// diagonal; or along the other one, where the two triangles would not look the same way and those of
// the other one do so better.
std::shared_ptr<const surface::Surface> surface_of(const QuadMesh &mesh);

} // namespace alphamst::mesh
