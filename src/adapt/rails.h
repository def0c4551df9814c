// Where vertices on the features of a curved mesh may slide.
#pragma once

#include <vector>

#include "geometry/rail.h"
#include "mesh/quad_mesh.h"

namespace alphamst::adapt {

// For a vertex on a feature that may slide there, see patch::slide, and that is on one line of the curves of
// the mesh with its two neighbours, between them: then the feature does not change wherever it slides. No
// rail for all other vertices, as there is none at the bends of curves.
geometry::Rail rail_of(const mesh::QuadMesh &mesh, int vertex);

// [vertex]; empty if no vertex may slide.
std::vector<geometry::Rail> rails_of(const mesh::QuadMesh &mesh);

} // namespace alphamst::adapt
