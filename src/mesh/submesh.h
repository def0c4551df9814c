// A part of a mesh as a mesh of its own, and what was replaced there done again in the whole: an operation on
// a few faces costs as much as these.
#pragma once

#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

struct Submesh {
    QuadMesh mesh;                    // it has a journal
    std::vector<int> faces, vertices; // [of the part as it was at first] in the whole
};

// faces: ascending. With flags, markers, what vertices keep to, and the vertex field "size". Where the whole
// goes on beyond, the boundary of the part is not one of the whole: the caller sees to it that nothing
// changes there, as the valences of its vertices are not those of the whole.
Submesh submesh_of(const QuadMesh &whole, std::span<const int> faces);

// After calls of replace_disk and set_point for the mesh of the part: does these in the whole, in which
// nothing has changed since.
void put_back(QuadMesh &whole, const Submesh &part);

} // namespace alphamst::mesh
