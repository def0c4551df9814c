// Half-edges from a list of faces. OpenMesh's add_face looks for each edge around its
// vertex and prints what it cannot add; here all sides are sorted first, every fault
// is found before the kernel is filled, and the kernel is filled in one sweep.
#include <algorithm>

#include "index.h"
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

[[noreturn]] void misfit(const char *text, Entity entity, std::size_t id) {
    throw Failure(Fault::argument, text, entity, {static_cast<std::int64_t>(id)});
}

// Each edge has one number, and its two half-edges run opposite ways.
void test_sides(std::span<const std::int32_t> sides, const Halfedges &halfedges) {
    constexpr std::int32_t none = -1;
    std::vector<std::int32_t> given(halfedges.n_edges, none); // [edge] the half-edge that runs up, as given
    std::vector<bool> used(halfedges.n_edges);
    for (std::size_t c = 0; c < sides.size(); ++c) {
        if (sides[c] < 0 || at(sides[c]) / 2 >= halfedges.n_edges)
            misfit("face {} has a half-edge that is not in the mesh", Entity::face, c / 4);
        const std::int32_t up = sides[c] ^ (halfedges.of_corner[c] & 1);
        std::int32_t &known = given[at(halfedges.of_corner[c]) / 2];
        if (known == none ? used[at(up) / 2] : known != up)
            misfit("face {} has a half-edge of another edge", Entity::face, c / 4);
        known = up;
        used[at(up) / 2] = true;
    }
}

} // namespace

QuadMesh QuadMesh::assemble(int dim, std::span<const double> points, std::span<const std::int32_t> faces,
                            std::span<const std::int32_t> given, std::size_t n_edges) {
    const std::size_t n_vertices = points.size() / 3;
    const std::size_t n_faces = faces.size() / 4;
    QuadMesh mesh;
    mesh.dim_ = dim;
    mesh.resize(n_vertices, n_edges, n_faces);
    Kernel &kernel = mesh.kernel_;
    auto &positions = kernel.property(kernel.points_property_handle()).data_vector();
    for (std::size_t v = 0; v < n_vertices; ++v)
        positions[v] = {points[3 * v], points[3 * v + 1], points[3 * v + 2]};
    for (std::size_t f = 0; f < n_faces; ++f) {
        std::array<int, 4> sides;
        std::array<int, 4> &corners = mesh.corners_[f];
        std::copy_n(given.begin() + static_cast<std::ptrdiff_t>(4 * f), 4, sides.begin());
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

QuadMesh QuadMesh::build(int dim, std::span<const double> points, std::span<const std::int32_t> faces) {
    test_lengths(dim, points, faces);
    test_arrays(points, faces, false);
    const Halfedges halfedges = pair_sides(faces, points.size() / 3);
    return assemble(dim, points, faces, halfedges.of_corner, halfedges.n_edges);
}

QuadMesh QuadMesh::restore(int dim, std::span<const double> points, const Connectivity &connectivity) {
    const auto &[faces, sides, first] = connectivity;
    test_lengths(dim, points, faces);
    if (sides.size() != faces.size() || first.size() != points.size() / 3)
        throw Failure(Fault::argument, "there is not one half-edge for each corner and each vertex");
    test_arrays(points, faces, false);
    const Halfedges halfedges = pair_sides(faces, points.size() / 3);
    test_sides(sides, halfedges);
    QuadMesh mesh = assemble(dim, points, faces, sides, halfedges.n_edges);
    Kernel &kernel = mesh.kernel_;
    for (std::size_t v = 0; v < first.size(); ++v) {
        const Vertex vertex(static_cast<int>(v));
        const Halfedge known = kernel.halfedge_handle(vertex), wanted(first[v]);
        if (wanted == known)
            continue;
        if (!known.is_valid() || !wanted.is_valid() || at(wanted.idx()) >= kernel.n_halfedges() ||
            kernel.is_boundary(known) || kernel.from_vertex_handle(wanted) != vertex)
            misfit("walks around vertex {} begin at a half-edge that is not there", Entity::vertex, v);
        kernel.set_halfedge_handle(vertex, wanted);
    }
    return mesh;
}

QuadMesh::Connectivity QuadMesh::connectivity() const {
    Connectivity result;
    result.faces.reserve(4 * kernel_.n_faces());
    result.sides.reserve(4 * kernel_.n_faces());
    for (int f = 0; f < n_faces(); ++f) {
        Halfedge h = kernel_.halfedge_handle(Face(f)); // from the last corner to the first
        for (const int corner : corners(f)) {
            h = kernel_.next_halfedge_handle(h);
            result.faces.push_back(corner);
            result.sides.push_back(h.idx());
        }
    }
    for (int v = 0; v < n_vertices(); ++v)
        result.first.push_back(kernel_.halfedge_handle(Vertex(v)).idx());
    return result;
}

} // namespace alphamst::mesh
