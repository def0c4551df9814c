// One step along a chord.
#pragma once

#include "mesh/link.h"
#include "mesh/quad_mesh.h"

namespace alphamst::chord {

using mesh::Halfedge;
using mesh::Vertex;

// The half-edge opposite in the face on the left, seen from beyond it: it points to the same side of
// the chord.
inline int ahead(const mesh::Kernel &kernel, int side) {
    return kernel.next_halfedge_handle(kernel.next_halfedge_handle(Halfedge(side))).idx() ^ 1;
}

// The half-edges of the face on the left along the chord, which are its rails there: one at the end of
// the side, the other at its start (this one points back).
inline int rail_at_end(const mesh::Kernel &kernel, int side) {
    return kernel.next_halfedge_handle(Halfedge(side)).idx();
}
inline int rail_at_start(const mesh::Kernel &kernel, int side) {
    return kernel.prev_halfedge_handle(Halfedge(side)).idx();
}

} // namespace alphamst::chord
