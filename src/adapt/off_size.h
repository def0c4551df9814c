// Whole meshes under a field "size" of which only those places change where faces are off their size: what a
// solver asks for every few steps.
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::adapt {

// The vertex field that remembers for which length of edges a place was last adapted, or found good.
constexpr const char *adapted_size = "adapted size";

// Faces that are to change, ascending, and those around them that give way. Their area is off from what the
// field wants by more than Settings::size_band, log2; and what is wanted has changed since they were last
// adapted by half of that or more: what could not be had then is not tried again.
std::vector<int> faces_off_size(const mesh::QuadMesh &mesh, double alpha, const Settings &settings);

// Whether a call is for that: the mesh is plane, has a field "size", and there is a band.
bool goes_by_band(const mesh::QuadMesh &mesh, const Settings &settings);

// The field as it is, alpha times as dense, says how many faces there are. Everything but those faces stays
// bit for bit.
Outcome adapt_off_size(mesh::QuadMesh &mesh, double alpha, const Settings &settings,
                       const Progress &progress);

} // namespace alphamst::adapt
