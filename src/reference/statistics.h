// What there is in a mesh, for outcomes of operations on the whole of it.
#pragma once

#include "geometry/embed.h"
#include "geometry/plane.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::reference {

// Interior vertices by valence, and the singular ones.
void count(const mesh::QuadMesh &mesh, std::map<int, std::int64_t> &valences, std::int64_t &singular);

// All vertices of the mesh in the plane.
geometry::Points flatten(const mesh::QuadMesh &mesh, const geometry::Plane &plane);

// FaceTree that make a boundary vertex regular less those that it has: its angle over 90 degrees,
// rounded, at least 1.
int mismatch(const mesh::QuadMesh &mesh, int vertex);

} // namespace alphamst::reference
