// The full test, and the digest.
#include <cmath>

#include "digest.h"
#include "mesh/link.h"
#include "quality/corner.h"

namespace alphamst::mesh {

namespace {

[[noreturn]] void broken(const char *text, Entity entity, std::vector<std::int64_t> ids) {
    throw Failure(Fault::internal, text, entity, std::move(ids));
}

template <class Handle> bool within(Handle handle, std::size_t count) {
    return handle.is_valid() && static_cast<std::size_t>(handle.idx()) < count;
}

// Each half-edge against its neighbours. Afterwards next is a permutation.
void check_halfedges(const Kernel &kernel) {
    for (int i = 0; i < static_cast<int>(kernel.n_halfedges()); ++i) {
        const Halfedge h(i);
        const Halfedge next = kernel.next_halfedge_handle(h), previous = kernel.prev_halfedge_handle(h);
        const Halfedge opposite = kernel.opposite_halfedge_handle(h);
        const Vertex to = kernel.to_vertex_handle(h);
        const auto fault = [&](const char *text) { broken(text, Entity::edge, {i / 2}); };
        if (!within(to, kernel.n_vertices()))
            fault("edge {} ends at a vertex that is not in the mesh");
        if (!within(next, kernel.n_halfedges()) || !within(previous, kernel.n_halfedges()))
            fault("edge {} is followed by an edge that is not in the mesh");
        if (to == kernel.to_vertex_handle(opposite))
            fault("edge {} ends where it starts");
        if (kernel.prev_halfedge_handle(next) != h || kernel.next_halfedge_handle(previous) != h)
            fault("edge {} and the one behind it disagree about their order");
        if (kernel.from_vertex_handle(next) != to)
            fault("edge {} and the one behind it do not share a vertex");
        if (kernel.face_handle(next) != kernel.face_handle(h))
            fault("edge {} and the one behind it are not at the same face");
        if (kernel.is_boundary(h) && kernel.is_boundary(opposite))
            fault("edge {} has no face");
        if (!kernel.is_boundary(h) && !within(kernel.face_handle(h), kernel.n_faces()))
            fault("edge {} is at a face that is not in the mesh");
    }
}

void check_faces(const Kernel &kernel, std::span<const std::array<int, 4>> kept) {
    std::size_t sides = 0;
    for (int i = 0; i < static_cast<int>(kernel.n_halfedges()); ++i)
        sides += kernel.is_boundary(Halfedge(i)) ? 0 : 1;
    for (int f = 0; f < static_cast<int>(kernel.n_faces()); ++f) {
        const Halfedge first = kernel.halfedge_handle(Face(f));
        if (!within(first, kernel.n_halfedges()) || kernel.face_handle(first) != Face(f))
            broken("face {} has an edge that is not at it", Entity::face, {f});
        std::array<Vertex, 4> corners;
        Halfedge h = first;
        for (Vertex &corner : corners) {
            corner = kernel.to_vertex_handle(h);
            h = kernel.next_halfedge_handle(h);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j)
                if (corners[i] == corners[j])
                    broken("face {} has vertex {} at two corners", Entity::face, {f, corners[i].idx()});
        if (h != first)
            broken("face {} has not four edges", Entity::face, {f});
        if (!std::equal(corners.begin(), corners.end(), kept[static_cast<std::size_t>(f)].begin(),
                        [](Vertex corner, int v) { return corner.idx() == v; }))
            broken("face {} has other corners than its edges have", Entity::face, {f});
    }
    if (sides != 4 * kernel.n_faces())
        throw Failure(Fault::internal, "some half-edges run around no face of the mesh");
}

void check_vertices(const Kernel &kernel) {
    const int n_vertices = static_cast<int>(kernel.n_vertices());
    for (int v = 0; v < n_vertices; ++v) {
        const Halfedge first = kernel.halfedge_handle(Vertex(v));
        if (first.is_valid() &&
            (!within(first, kernel.n_halfedges()) || kernel.from_vertex_handle(first) != Vertex(v)))
            broken("vertex {} has an edge that does not start at it", Entity::vertex, {v});
    }
    if (const int v = find_pinch(kernel); v >= 0)
        broken("the faces at vertex {} are not one fan", Entity::vertex, {v});
    std::vector<int> seen(kernel.n_vertices(), -1); // the vertex from which one was last seen
    for (int v = 0; v < n_vertices; ++v) {
        around(kernel, v, [&](Halfedge h) {
            if (kernel.is_boundary(h) && h != kernel.halfedge_handle(Vertex(v)))
                broken("vertex {} is on the boundary but does not keep its boundary edge", Entity::vertex,
                       {v});
            int &last = seen[static_cast<std::size_t>(kernel.to_vertex_handle(h).idx())];
            if (last == v)
                broken("edge {} is there twice", Entity::edge, {h.idx() / 2});
            last = v;
        });
    }
}

void check_points(const Kernel &kernel) {
    for (int v = 0; v < static_cast<int>(kernel.n_vertices()); ++v)
        for (const double x : kernel.point(Vertex(v)))
            if (!std::isfinite(x))
                throw Failure(Fault::not_finite,
                              "vertex {} has a coordinate that is infinite or not a number", Entity::vertex,
                              {v});
}

void check_orientation(const QuadMesh &mesh) {
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const auto corners = mesh.corners(f);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto &here = mesh.point(corners[i]);
            const auto next = mesh.point(corners[(i + 1) % 4]) - here;
            const auto previous = mesh.point(corners[(i + 3) % 4]) - here;
            if (mesh.point(corners[(i + 1) % 4]) == here)
                throw Failure(
                    Fault::argument,
                    "face {} has an edge without length, between vertices {} and {}; make one vertex "
                    "of the two, or move them apart",
                    Entity::face, {f, corners[i], corners[(i + 1) % 4]});
            if (!(quality::determinant({next[0], next[1]}, {previous[0], previous[1]}) > 0))
                throw Failure(Fault::argument,
                              "face {} is inverted or flat at vertex {}; move vertices there until all "
                              "four corners of the face are convex",
                              Entity::face, {f, corners[i]});
        }
    }
}

std::int32_t marker_of(const std::vector<std::int32_t> &markers, std::size_t i) {
    return markers.empty() ? 0 : markers[i];
}

} // namespace

void QuadMesh::refuse_with_journal() const {
    if (journal)
        throw Failure(Fault::internal, "a mesh with a journal keeps its chords");
}

void QuadMesh::check_sizes() const {
    const auto fits = [](const auto &values, std::size_t n) { return values.size() == n; };
    const std::size_t vertices = kernel_.n_vertices(), edges = kernel_.n_edges(), faces = kernel_.n_faces();
    if (!fits(vertex_flags, vertices) || !fits(edge_flags, edges) || !fits(face_flags, faces) ||
        !fits(vertex_origin, vertices) || !fits(edge_origin, edges) || !fits(face_origin, faces) ||
        !fits(corners_, faces) || !(vertex_marker.empty() || fits(vertex_marker, vertices)) ||
        !(edge_marker.empty() || fits(edge_marker, edges)) ||
        !(face_marker.empty() || fits(face_marker, faces)))
        throw Failure(Fault::internal, "flags, markers, origins or corners are not one for each entity");
}

void QuadMesh::check() const {
    check_sizes();
    check_halfedges(kernel_);
    check_faces(kernel_, corners_);
    check_vertices(kernel_);
    check_points(kernel_);
    if (dim_ == 2)
        check_orientation(*this);
}

std::uint64_t QuadMesh::checksum() const {
    Digest digest;
    digest.add(static_cast<std::uint64_t>(dim_));
    digest.add(kernel_.n_vertices());
    digest.add(kernel_.n_faces());
    for (int v = 0; v < n_vertices(); ++v) {
        for (const double x : point(v))
            digest.add_real(x);
        digest.add(vertex_flags[static_cast<std::size_t>(v)]);
    }
    for (int f = 0; f < n_faces(); ++f) {
        const auto c = corners(f);
        digest.add(c[0], c[1]);
        digest.add(c[2], c[3]);
        digest.add(face_flags[static_cast<std::size_t>(f)],
                   marker_of(face_marker, static_cast<std::size_t>(f)));
    }
    // Edges in any order: the sum of a digest for each with something to say.
    std::uint64_t edges = 0;
    for (std::size_t e = 0; e < kernel_.n_edges(); ++e) {
        const std::int32_t marker = marker_of(edge_marker, e);
        if (edge_flags[e] == 0 && marker == 0)
            continue;
        const auto [v, w] = edge_vertices(static_cast<int>(e));
        Digest edge;
        edge.add(v, w);
        edge.add(edge_flags[e], marker);
        edges += edge.value();
    }
    digest.add(edges);
    for (std::size_t v = 0; v < vertex_marker.size(); ++v)
        if (vertex_marker[v] != 0)
            digest.add(static_cast<int>(v), vertex_marker[v]);
    return digest.value();
}

} // namespace alphamst::mesh
