// A sorted set of faces seen as a region of the mesh: what bounds it, what lies within.
// Everything here costs O(faces of the region), whatever the size of the mesh.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/link.h"
#include "mesh/quad_mesh.h"

namespace alphamst::patch {

using mesh::Halfedge;
using mesh::Kernel;

inline bool contains(std::span<const int> sorted, int id) {
    return std::binary_search(sorted.begin(), sorted.end(), id);
}

std::vector<int> sorted_unique(std::span<const int> ids);

// The four half-edges of a face, from corner 0 on; the face is on their left.
std::array<Halfedge, 4> halfedges_of(const mesh::QuadMesh &mesh, int face);

inline int from(const mesh::QuadMesh &mesh, Halfedge h) { return mesh.kernel().from_vertex_handle(h).idx(); }
inline int to(const mesh::QuadMesh &mesh, Halfedge h) { return mesh.kernel().to_vertex_handle(h).idx(); }
// The face on the left of h, or on its right; -1 beyond the boundary.
inline int left(const mesh::QuadMesh &mesh, Halfedge h) { return mesh.kernel().face_handle(h).idx(); }
inline int right(const mesh::QuadMesh &mesh, Halfedge h) {
    return mesh.kernel().opposite_face_handle(h).idx();
}

// Whether no patch may reach across an edge: it has a flag or a marker, or the faces at
// it have different markers. Whether a vertex may not be inside a patch.
bool barrier(const mesh::QuadMesh &mesh, Halfedge h);
bool held(const mesh::QuadMesh &mesh, int vertex);
// A vertex that smoothing must not move wherever it lies: on the mesh boundary, flagged, at a
// face that is FIXED, or on an edge that is flagged, numbered or between two regions.
bool constrained(const mesh::QuadMesh &mesh, int vertex);
// The two vertices along a feature between which a constrained one may slide, if that keeps the feature as it
// is: it has just these two edges that are flagged, numbered or between two regions, which are alike, and
// nothing but FEATURE says that it stays. Whether the three are on one line is not looked at.
std::optional<std::array<int, 2>> slide(const mesh::QuadMesh &mesh, int vertex);

struct Region {
    explicit Region(const mesh::QuadMesh &mesh, std::span<const int> faces);

    std::vector<int> faces;         // ascending
    std::vector<Halfedge> boundary; // with the region on their left, by the vertex they start from
    std::vector<int> interior;      // vertices with all their faces in the region, ascending
    std::vector<Halfedge> inner;    // one half-edge of every edge with the region on both sides

    // Some vertex is passed twice by the boundary.
    bool pinched(const mesh::QuadMesh &mesh) const;
};

// Edge-connected parts, each ascending, in the order of their smallest face; barriers
// separate unless `across`.
std::vector<std::vector<int>> parts(const mesh::QuadMesh &mesh, std::span<const int> faces, bool across);
// The one with the most faces, the first of equals.
std::vector<int> largest_part(const mesh::QuadMesh &mesh, std::span<const int> faces, bool across);

// Interior angle of the face on the left of h at the start of h, radians, 0 .. 2 pi.
double corner_angle(const mesh::QuadMesh &mesh, Halfedge h);

OpenMesh::Vec3d centroid(const mesh::QuadMesh &mesh, int face);

} // namespace alphamst::patch
