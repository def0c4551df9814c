// Names for what the kernel numbers, and the two loops over half-edges that building, replacing and checking
// share.
#pragma once

#include <array>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

using Vertex = Kernel::VertexHandle;
using Halfedge = Kernel::HalfedgeHandle;
using Face = Kernel::FaceHandle;

// Ties four half-edges together as the sides of a face; side i starts at corner i.
inline void link_face(Kernel &kernel, int face, const std::array<int, 4> &sides,
                      const std::array<int, 4> &corners) {
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        const Halfedge side(sides[i]);
        kernel.set_vertex_handle(side, Vertex(corners[next]));
        kernel.set_vertex_handle(Halfedge(sides[i] ^ 1), Vertex(corners[i]));
        kernel.set_face_handle(side, Face(face));
        kernel.set_next_halfedge_handle(side, Halfedge(sides[next]));
    }
    kernel.set_halfedge_handle(Face(face), Halfedge(sides[3]));
}

// Calls visit(h) for every half-edge out of v, counter-clockwise. On the boundary the
// first has a face at its left only and the last has none there.
template <class Visit> void around(const Kernel &kernel, int v, Visit visit) {
    Halfedge first = kernel.halfedge_handle(Vertex(v));
    if (!first.is_valid())
        return;
    if (kernel.is_boundary(first))
        first = kernel.ccw_rotated_halfedge_handle(first);
    Halfedge h = first;
    do {
        visit(h);
        h = kernel.ccw_rotated_halfedge_handle(h);
    } while (h != first);
}

// A vertex with more half-edges than its fan has, -1 if there is none.
int find_pinch(const Kernel &kernel);

} // namespace alphamst::mesh
