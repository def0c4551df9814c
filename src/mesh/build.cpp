// Half-edges from a list of faces. OpenMesh's add_face looks for each edge around its
// vertex and prints what it cannot add; here all sides are sorted first, every fault
// is found before the kernel is filled, and the kernel is filled in one sweep.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "mesh/link.h"

namespace alphamst::mesh {

namespace {

using Points = std::span<const double>;
using Faces = std::span<const std::int32_t>;

// Corner c of the list stands for the side of its face from there to the next corner.
std::size_t next_corner(std::size_t c) { return c % 4 == 3 ? c - 3 : c + 1; }

void test_lengths(int dim, Points points, Faces faces) {
    if (dim != 2 && dim != 3)
        throw Failure(Fault::argument, "the dimension of a mesh is 2 or 3");
    if (points.size() % 3 != 0)
        throw Failure(Fault::argument, "the length of the points is not a multiple of 3");
    if (faces.size() % 4 != 0)
        throw Failure(Fault::argument, "the length of the faces is not a multiple of 4");
    // OpenMesh's ids are int, and each corner may bring an edge of two half-edges.
    constexpr std::size_t most = std::numeric_limits<int>::max();
    if (points.size() / 3 > most || faces.size() > most / 2)
        throw Failure(Fault::range, "the mesh has more entities than 32-bit ids can name");
}

void test_points(Points points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!std::isfinite(points[i]))
            throw Failure(Fault::not_finite,
                          "vertex {} has a coordinate that is infinite or not a number; give it a finite one",
                          Entity::vertex, {static_cast<std::int64_t>(i / 3)});
}

void test_corners(Faces faces, std::size_t n_vertices) {
    for (std::size_t c = 0; c < faces.size(); c += 4) {
        const auto face = static_cast<std::int64_t>(c / 4);
        for (std::size_t i = c; i < c + 4; ++i)
            if (faces[i] < 0 || static_cast<std::size_t>(faces[i]) >= n_vertices)
                throw Failure(Fault::range,
                              "face {} has corner {}, but the mesh has " + std::to_string(n_vertices) +
                                  " vertices; correct the corner or add the vertex",
                              Entity::face, {face, faces[i]});
        for (std::size_t i = c; i < c + 4; ++i)
            for (std::size_t j = i + 1; j < c + 4; ++j)
                if (faces[i] == faces[j])
                    throw Failure(Fault::not_quad,
                                  "face {} has vertex {} at two corners; give it four different corners",
                                  Entity::face, {face, faces[i]});
    }
}

// One side of a face, filed under the smaller of its two vertices.
struct Side {
    std::int32_t larger;
    std::int32_t corner;
};

struct Buckets {
    std::vector<std::int32_t> end; // [vertex], one behind its last side
    std::vector<Side> sides;
};

// Counting sort by the smaller vertex, then each bucket by the larger one.
Buckets sort_sides(Faces faces, std::size_t n_vertices) {
    Buckets buckets{std::vector<std::int32_t>(n_vertices + 1), std::vector<Side>(faces.size())};
    auto &end = buckets.end;
    for (std::size_t c = 0; c < faces.size(); ++c)
        ++end[static_cast<std::size_t>(std::min(faces[c], faces[next_corner(c)])) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    for (std::size_t c = 0; c < faces.size(); ++c) {
        const auto [smaller, larger] = std::minmax(faces[c], faces[next_corner(c)]);
        const auto place = end[static_cast<std::size_t>(smaller)]++;
        buckets.sides[static_cast<std::size_t>(place)] = {larger, static_cast<std::int32_t>(c)};
    }
    std::ptrdiff_t begin = 0;
    for (std::size_t v = 0; v < n_vertices; ++v) {
        std::sort(buckets.sides.begin() + begin, buckets.sides.begin() + end[v],
                  [](const Side &a, const Side &b) {
                      return a.larger != b.larger ? a.larger < b.larger : a.corner < b.corner;
                  });
        begin = end[v];
    }
    return buckets;
}

[[noreturn]] void refuse_edge(Faces faces, std::span<const Side> sides) {
    const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(sides[i].corner); };
    const std::int64_t from = faces[corner(0)], to = faces[next_corner(corner(0))];
    if (sides.size() > 2)
        throw Failure(Fault::not_manifold,
                      "face {} is the third one at the edge between vertices {} and {}; split the mesh there",
                      Entity::face, {sides[2].corner / 4, from, to});
    throw Failure(Fault::not_manifold,
                  "faces {} and {} both run from vertex {} to vertex {}; reverse the corners of one of them, "
                  "or split the mesh there if it has only one side",
                  Entity::face, {sides[1].corner / 4, sides[0].corner / 4, from, to});
}

struct Halfedges {
    std::vector<std::int32_t> of_corner; // 2 * edge, + 1 if it runs from the larger vertex
    std::size_t n_edges = 0;
};

Halfedges match(Faces faces, std::size_t n_vertices) {
    const Buckets buckets = sort_sides(faces, n_vertices);
    Halfedges halfedges{std::vector<std::int32_t>(faces.size())};
    const std::span<const Side> sides = buckets.sides;
    for (std::size_t v = 0, i = 0; v < n_vertices; ++v) {
        const auto end = static_cast<std::size_t>(buckets.end[v]);
        while (i < end) {
            std::size_t last = i + 1;
            while (last < end && sides[last].larger == sides[i].larger)
                ++last;
            const auto reversed = [&](std::size_t k) {
                return faces[static_cast<std::size_t>(sides[k].corner)] == sides[k].larger;
            };
            if (last - i > 2 || (last - i == 2 && reversed(i) == reversed(i + 1)))
                refuse_edge(faces, sides.subspan(i, last - i));
            for (; i < last; ++i)
                halfedges.of_corner[static_cast<std::size_t>(sides[i].corner)] =
                    static_cast<std::int32_t>(2 * halfedges.n_edges + (reversed(i) ? 1 : 0));
            ++halfedges.n_edges;
        }
    }
    return halfedges;
}

[[noreturn]] void refuse_vertex(int v) {
    throw Failure(
        Fault::not_manifold,
        "the faces at vertex {} meet there without sharing edges; give each group of them a vertex of "
        "its own",
        Entity::vertex, {v});
}

// Joins the half-edges without a face into loops; a vertex keeps the one that leaves it.
void link_boundary(Kernel &kernel) {
    std::vector<Halfedge> boundary;
    for (int i = 0; i < static_cast<int>(kernel.n_halfedges()); ++i) {
        const Halfedge h(i);
        if (!kernel.is_boundary(h))
            continue;
        const Vertex v = kernel.from_vertex_handle(h);
        if (kernel.is_boundary(kernel.halfedge_handle(v)))
            refuse_vertex(v.idx());
        kernel.set_halfedge_handle(v, h);
        boundary.push_back(h);
    }
    // As many half-edges enter a vertex as leave it, with a face and so without, too:
    // every loop goes on.
    for (const Halfedge h : boundary)
        kernel.set_next_halfedge_handle(h, kernel.halfedge_handle(kernel.to_vertex_handle(h)));
}

} // namespace

QuadMesh QuadMesh::build(int dim, std::span<const double> points, std::span<const std::int32_t> faces) {
    test_lengths(dim, points, faces);
    const std::size_t n_vertices = points.size() / 3;
    const std::size_t n_faces = faces.size() / 4;
    test_points(points);
    test_corners(faces, n_vertices);
    const Halfedges halfedges = match(faces, n_vertices);

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
    link_boundary(kernel);
    if (const int v = find_pinch(kernel); v >= 0)
        refuse_vertex(v);
    mesh.reset_origins();
    return mesh;
}

} // namespace alphamst::mesh
