// Faces that hang together by edges, and whether they run the same way round.
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/sides.h"

namespace alphamst::mesh {

// For each corner of the faces the one whose side is the same edge, -1 where an edge has one face or three.
std::vector<std::int32_t> neighbours(Faces faces, const EdgeSides &sides);

struct Components {
    std::vector<std::int32_t> of_face; // numbered by their first faces; -1: the face has no sides
    std::vector<bool> against;         // [face] runs the other way round than the first of its component
    // [component] a corner over whose side one comes back to faces that run the other way round; -1: none,
    // the component has two sides.
    std::vector<std::int32_t> one_sided;
};

Components find_components(Faces faces, const std::vector<std::int32_t> &across);

// [vertex] whether its faces meet there without sharing edges.
std::vector<bool> find_pinched(Faces faces, const EdgeSides &sides, std::size_t n_vertices);

// Faces that share no edge with another.
int count_lone_faces(const QuadMesh &mesh);

} // namespace alphamst::mesh
