// Half-edges from a list of faces. OpenMesh's add_face looks for each edge around its
// vertex and prints what it cannot add; here all sides are sorted first, every fault
// is found before the kernel is filled, and the kernel is filled in one sweep.
#include <algorithm>

#include "mesh/defects.h"
#include "mesh/link.h"
#include "mesh/sides.h"

namespace alphamst::mesh {

namespace {

// Joins the half-edges without a face into loops; a vertex keeps the one that leaves it. False if several
// loops meet at a vertex.
bool link_boundary(Kernel &kernel) {
    std::vector<Halfedge> boundary;
    for (int i = 0; i < static_cast<int>(kernel.n_halfedges()); ++i) {
        const Halfedge h(i);
        if (!kernel.is_boundary(h))
            continue;
        const Vertex v = kernel.from_vertex_handle(h);
        if (kernel.is_boundary(kernel.halfedge_handle(v)))
            return false;
        kernel.set_halfedge_handle(v, h);
        boundary.push_back(h);
    }
    // As many half-edges enter a vertex as leave it, with a face and so without, too:
    // every loop goes on.
    for (const Halfedge h : boundary)
        kernel.set_next_halfedge_handle(h, kernel.halfedge_handle(kernel.to_vertex_handle(h)));
    return true;
}

} // namespace

QuadMesh QuadMesh::build(int dim, std::span<const double> points, std::span<const std::int32_t> faces) {
    test_lengths(dim, points, faces);
    const std::size_t n_vertices = points.size() / 3;
    const std::size_t n_faces = faces.size() / 4;
    test_arrays(points, faces, false);
    const Halfedges halfedges = pair_sides(faces, n_vertices);

    QuadMesh mesh;
    mesh.dim_ = dim;
    mesh.resize(n_vertices, halfedges.n_edges, n_faces);
    Kernel &kernel = mesh.kernel_;
    auto &positions = kernel.property(kernel.points_property_handle()).data_vector();
    for (std::size_t v = 0; v < n_vertices; ++v)
        positions[v] = {points[3 * v], points[3 * v + 1], points[3 * v + 2]};
    for (std::size_t f = 0; f < n_faces; ++f) {
        std::array<int, 4> sides;
        std::array<int, 4> &corners = mesh.corners_[f];
        std::copy_n(halfedges.of_corner.begin() + static_cast<std::ptrdiff_t>(4 * f), 4, sides.begin());
        std::copy_n(faces.begin() + static_cast<std::ptrdiff_t>(4 * f), 4, corners.begin());
        link_face(kernel, static_cast<int>(f), sides, corners);
        for (std::size_t i = 0; i < 4; ++i)
            kernel.set_halfedge_handle(Vertex(corners[i]), Halfedge(sides[i]));
    }
    if (!link_boundary(kernel) || find_pinch(kernel) >= 0)
        throw find_defects(points, faces, n_vertices, false);
    mesh.reset_origins();
    return mesh;
}

} // namespace alphamst::mesh
