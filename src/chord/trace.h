// Chords: the row of faces met when each is left through the edge opposite to the one it was entered
// by. Every edge lies on exactly one chord, every face is the crossing of two (or of one with itself).
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::chord {

struct Chord {
    // A half-edge of every edge in order, all pointing to the same side of the chord; side i has face i
    // on its left. The last of an open chord has none.
    std::vector<int> sides;
    std::vector<int> faces; // one met twice is there twice
    bool closed = false;    // the last face leads back to the first edge
    int crossings = 0;      // faces it passes twice
    int touches = 0;        // vertices at more than one of its edges

    std::size_t length() const { return faces.size(); }
};

// The chord through an edge. A closed one begins with that edge, an open one at its end with the
// smaller edge. Costs O(length log length).
Chord trace(const mesh::QuadMesh &mesh, int edge);

struct Labels {
    std::vector<int> of_edge; // [edges]
    std::vector<int> first;   // [chords] its smallest edge; chords are in this order
};

// All chords, in linear time.
Labels label(const mesh::QuadMesh &mesh);

} // namespace alphamst::chord
