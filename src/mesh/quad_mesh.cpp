#include "mesh/quad_mesh.h"

#include <algorithm>
#include <numeric>

#include "mesh/link.h"

namespace alphamst::mesh {

std::array<int, 2> QuadMesh::edge_vertices(int edge) const {
    const int v = kernel_.to_vertex_handle(Halfedge(2 * edge + 1)).idx();
    const int w = kernel_.to_vertex_handle(Halfedge(2 * edge)).idx();
    return {std::min(v, w), std::max(v, w)};
}

std::array<int, 2> QuadMesh::edge_faces(int edge) const {
    const Halfedge h(2 * edge), opposite(2 * edge + 1);
    const int left = kernel_.face_handle(h).idx(), right = kernel_.face_handle(opposite).idx();
    if (kernel_.to_vertex_handle(opposite).idx() < kernel_.to_vertex_handle(h).idx())
        return {left, right};
    return {right, left};
}

int QuadMesh::find_edge(int v, int w) const {
    const Halfedge first = kernel_.halfedge_handle(Vertex(v));
    if (!first.is_valid())
        return -1;
    Halfedge h = first;
    do {
        if (kernel_.to_vertex_handle(h).idx() == w)
            return h.idx() / 2;
        h = kernel_.ccw_rotated_halfedge_handle(h);
    } while (h != first);
    return -1;
}

bool QuadMesh::on_boundary(int v) const {
    const Halfedge h = kernel_.halfedge_handle(Vertex(v));
    return h.is_valid() && kernel_.is_boundary(h);
}

bool QuadMesh::isolated(int v) const { return kernel_.is_isolated(Vertex(v)); }

int QuadMesh::valence(int v) const {
    int result = 0;
    around(kernel_, v, [&](Halfedge) { ++result; });
    return result;
}

bool QuadMesh::singular(int v) const { return !isolated(v) && !on_boundary(v) && valence(v) != 4; }

std::vector<int> QuadMesh::faces_around(int v) const {
    std::vector<int> result;
    around(kernel_, v, [&](Halfedge h) {
        if (!kernel_.is_boundary(h))
            result.push_back(kernel_.face_handle(h).idx());
    });
    return result;
}

std::vector<int> QuadMesh::vertices_around(int v) const {
    std::vector<int> result;
    around(kernel_, v, [&](Halfedge h) { result.push_back(kernel_.to_vertex_handle(h).idx()); });
    return result;
}

std::array<int, 4> QuadMesh::neighbours(int face) const {
    std::array<int, 4> result;
    Halfedge h = kernel_.halfedge_handle(Face(face));
    for (int &neighbour : result) {
        h = kernel_.next_halfedge_handle(h);
        neighbour = kernel_.face_handle(kernel_.opposite_halfedge_handle(h)).idx();
    }
    return result;
}

std::vector<int> QuadMesh::singularities() const {
    std::vector<int> result;
    for (int v = 0; v < n_vertices(); ++v)
        if (singular(v))
            result.push_back(v);
    return result;
}

void QuadMesh::reset_origins() {
    std::iota(vertex_origin.begin(), vertex_origin.end(), 0);
    std::iota(edge_origin.begin(), edge_origin.end(), 0);
    std::iota(face_origin.begin(), face_origin.end(), 0);
}

// Makes room for that many entities, so that resize cannot fail.
void QuadMesh::reserve(std::size_t vertices, std::size_t edges, std::size_t faces) {
    // The kernel reserves exactly; half as much again keeps repeated growth linear.
    const auto roomy = [](std::size_t room, std::size_t wanted) {
        return wanted <= room ? room : wanted + wanted / 2;
    };
    Room room;
    room.vertices = roomy(std::max<std::size_t>(room_.vertices, kernel_.n_vertices()), vertices);
    room.edges = roomy(std::max<std::size_t>(room_.edges, kernel_.n_edges()), edges);
    room.faces = roomy(std::max<std::size_t>(room_.faces, kernel_.n_faces()), faces);
    kernel_.reserve(room.vertices, room.edges, room.faces);
    corners_.reserve(room.faces);
    vertex_flags.reserve(room.vertices);
    vertex_origin.reserve(room.vertices);
    edge_flags.reserve(room.edges);
    edge_origin.reserve(room.edges);
    face_flags.reserve(room.faces);
    face_origin.reserve(room.faces);
    if (!vertex_marker.empty())
        vertex_marker.reserve(room.vertices);
    if (!edge_marker.empty())
        edge_marker.reserve(room.edges);
    if (!face_marker.empty())
        face_marker.reserve(room.faces);
    room_.vertices = room.vertices;
    room_.edges = room.edges;
    room_.faces = room.faces;
}

void QuadMesh::resize(std::size_t vertices, std::size_t edges, std::size_t faces) {
    const bool marked_vertices = !vertex_marker.empty(), marked_edges = !edge_marker.empty(),
               marked_faces = !face_marker.empty();
    kernel_.resize(vertices, edges, faces);
    corners_.resize(faces);
    vertex_flags.resize(vertices);
    vertex_origin.resize(vertices, -1);
    edge_flags.resize(edges);
    edge_origin.resize(edges, -1);
    face_flags.resize(faces);
    face_origin.resize(faces, -1);
    if (marked_vertices)
        vertex_marker.resize(vertices);
    if (marked_edges)
        edge_marker.resize(edges);
    if (marked_faces)
        face_marker.resize(faces);
}

int find_pinch(const Kernel &kernel) {
    const int n_vertices = static_cast<int>(kernel.n_vertices());
    std::size_t reached = 0;
    for (int v = 0; v < n_vertices; ++v)
        around(kernel, v, [&](Halfedge) { ++reached; });
    if (reached == kernel.n_halfedges())
        return -1;
    std::vector<int> sides(kernel.n_vertices());
    for (int i = 0; i < static_cast<int>(kernel.n_halfedges()); ++i)
        ++sides[static_cast<std::size_t>(kernel.to_vertex_handle(Halfedge(i)).idx())];
    for (int v = 0; v < n_vertices; ++v) {
        around(kernel, v, [&](Halfedge) { --sides[static_cast<std::size_t>(v)]; });
        if (sides[static_cast<std::size_t>(v)] != 0)
            return v;
    }
    return -1;
}

} // namespace alphamst::mesh
