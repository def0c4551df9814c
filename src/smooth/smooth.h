// Vertices move, connectivity stays.
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::smooth {

// Moves the vertices inside the face sets, or of the whole mesh when patches is null; vertices on the
// mesh boundary and flagged ones stay. The smallest scaled Jacobian of each never falls; on a surface, where
// it is that of geometry::judge, vertices stay around the quads for which it would. One outcome per patch, or
// one for the mesh.
std::vector<Outcome> smooth(mesh::QuadMesh &mesh, const std::vector<Patch> *patches, const Settings &settings,
                            const Progress &progress);

} // namespace alphamst::smooth
