// The reference of a mesh: the surface and the curves that its vertices keep to while they move.
#pragma once

#include <memory>

#include "mesh/quad_mesh.h"
#include "surface/curve.h"
#include "surface/surface.h"

namespace alphamst::reference {

// The mesh as it is: point i is vertex i, triangles 2 f and 2 f + 1 are face f, cut along the shorter
// diagonal; or along the other one, where the two triangles would not look the same way and those of
// the other one do so better.
std::shared_ptr<const surface::Surface> surface_of(const mesh::QuadMesh &mesh);

// The lines of the edges inside that are features, numbered or between two regions. Those that the mesh has
// already, as long as edges lie on them; only other edges, which were no features before or have been put
// elsewhere, count as they are now.
std::shared_ptr<const surface::Curves> curves_of(const mesh::QuadMesh &mesh);

} // namespace alphamst::reference
