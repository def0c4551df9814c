// What a caller asks for, on patches of a mesh: propose, judge, commit.
//
// Every function works on the mesh it is given and may leave it half done when it
// throws; the caller hands in a copy and swaps it in on success.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::adapt {

// Replaces each patch by the filling with the fewest singularities that has
// round(alpha * faces) faces.
std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha,
                           const Settings &settings, const Progress &progress);

// Replaces each patch by the filling with the fewest singularities of all, its face
// count as near to the old one as that allows.
std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                          const Settings &settings, const Progress &progress);

// The same for a whole mesh, with windows that the library chooses. adapt delivers
// round(alpha * faces) faces; a vertex field "size" says where they go, else they go where the surface
// bends or, in a plane, where the faces were. reduce_whole keeps the count within a few percent.
Outcome adapt_whole(mesh::QuadMesh &mesh, double alpha, const Settings &settings, const Progress &progress);
Outcome reduce_whole(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress);

// Removes doublets and splits valences above 5, each by refilling a small window
// around the vertex. One outcome for the mesh.
Outcome clean(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress);

// What adapt would deliver for the patch. Throws Failure as adapt would report it.
Prediction predict(const mesh::QuadMesh &mesh, const Patch &patch, double alpha, const Settings &settings);

} // namespace alphamst::adapt
