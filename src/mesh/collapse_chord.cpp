// Zipping a chord up: everything is found and allocated first, then written without a throw.
#include <algorithm>

#include "index.h"
#include "mesh/ids.h"
#include "mesh/link.h"

namespace alphamst::mesh {

namespace {

[[noreturn]] void refuse(const char *text) { throw Failure(Fault::internal, text); }

std::vector<int> sorted(std::vector<int> ids, const char *repeated) {
    std::sort(ids.begin(), ids.end());
    if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
        refuse(repeated);
    return ids;
}

bool contains(const std::vector<int> &ascending, int id) {
    return std::binary_search(ascending.begin(), ascending.end(), id);
}

// The edges along the chord, and which of them glueing leaves: the one at the start of a side goes,
// in its place comes the one at the end. Where chords lie side by side both may be others by then.
class Rails {
public:
    explicit Rails(std::vector<int> edges) : edges_(std::move(edges)), heir_(edges_.size()) {
        std::sort(edges_.begin(), edges_.end());
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
        heir_ = edges_;
    }
    int heir(int edge) const {
        for (int next = heir_[place(edge)]; next != edge; next = heir_[place(edge)])
            edge = next;
        return edge;
    }
    void glue(int gone, int kept) { heir_[place(gone)] = kept; }

private:
    std::size_t place(int edge) const {
        return static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), edge) -
                                        edges_.begin());
    }
    std::vector<int> edges_, heir_;
};

struct Out {
    Halfedge halfedge; // leaves the group
    int survivor;
};

// Takes a half-edge out of its loop.
void bypass(Kernel &kernel, Halfedge h) {
    kernel.set_next_halfedge_handle(kernel.prev_halfedge_handle(h), kernel.next_halfedge_handle(h));
}

// `kept`, which leaves its face, gets the place of the half-edge across from `gone`, which ran beside it.
void glue(Kernel &kernel, Halfedge kept, Halfedge gone) {
    const Halfedge old = kernel.opposite_halfedge_handle(gone);
    const Face face = kernel.face_handle(old);
    const Halfedge previous = kernel.prev_halfedge_handle(old), next = kernel.next_halfedge_handle(old);
    kernel.set_next_halfedge_handle(previous, kept);
    kernel.set_next_halfedge_handle(kept, next);
    if (!face.is_valid()) {
        kernel.set_boundary(kept);
        return;
    }
    kernel.set_face_handle(kept, face);
    if (kernel.halfedge_handle(face) == old)
        kernel.set_halfedge_handle(face, kept);
}

// The half-edges along the chord in the face at the left of a side: from its end, and to its start.
std::array<Halfedge, 2> rails(const Kernel &kernel, int side) {
    return {kernel.next_halfedge_handle(Halfedge(side)), kernel.prev_halfedge_handle(Halfedge(side))};
}

// What a chord takes with it; all ascending.
struct Gone {
    std::vector<int> faces, vertices;
    std::vector<int> crossed; // the edges that the chord passes
    std::vector<int> edges;   // these and one of each two rails
};

// Everything but gone.edges.
Gone find_gone(const QuadMesh &mesh, std::span<const int> sides, std::span<const std::array<int, 2>> merged) {
    const Kernel &kernel = mesh.kernel();
    Gone gone;
    for (const int side : sides) {
        if (side < 0 || at(side) >= kernel.n_halfedges())
            refuse("a chord has an edge that is not in the mesh");
        gone.crossed.push_back(side / 2);
        if (!kernel.is_boundary(Halfedge(side)))
            gone.faces.push_back(kernel.face_handle(Halfedge(side)).idx());
    }
    gone.crossed = sorted(std::move(gone.crossed), "a chord passes an edge twice");
    gone.faces = sorted(std::move(gone.faces), "a chord crosses itself");
    for (const auto &[vertex, survivor] : merged) {
        if (vertex < 0 || survivor < 0 || std::max(vertex, survivor) >= mesh.n_vertices())
            refuse("a chord has a vertex that is not in the mesh");
        gone.vertices.push_back(vertex);
    }
    gone.vertices = sorted(std::move(gone.vertices), "a vertex of a chord is merged twice");
    return gone;
}

// Glues the rails of one face after the other, in numbers only, and fills in gone.edges.
Rails find_heirs(const Kernel &kernel, std::span<const int> sides, Gone &gone) {
    std::vector<int> edges;
    for (const int side : sides)
        if (!kernel.is_boundary(Halfedge(side)))
            for (const Halfedge rail : rails(kernel, side))
                edges.push_back(rail.idx() / 2);
    Rails heirs(std::move(edges));
    gone.edges = gone.crossed;
    for (const int side : sides) {
        if (kernel.is_boundary(Halfedge(side)))
            continue;
        const auto [at_end, at_start] = rails(kernel, side);
        const int kept = heirs.heir(at_end.idx() / 2), lost = heirs.heir(at_start.idx() / 2);
        if (kept == lost)
            refuse("the borders of a chord close up");
        heirs.glue(lost, kept);
        gone.edges.push_back(lost);
    }
    gone.edges = sorted(std::move(gone.edges), "an edge goes twice with a chord");
    return heirs;
}

// The half-edges out of all vertices that go, then those out of the ones that stay in their place.
std::vector<Out> find_outs(const Kernel &kernel, std::span<const std::array<int, 2>> merged,
                           const std::vector<int> &gone) {
    std::vector<Out> outs;
    const auto collect = [&](int v, int survivor) {
        around(kernel, v, [&](Halfedge h) { outs.push_back({h, survivor}); });
    };
    std::vector<int> survivors;
    for (const auto &[vertex, survivor] : merged) {
        if (contains(gone, survivor))
            refuse("a vertex that stays goes as well");
        collect(vertex, survivor);
        survivors.push_back(survivor);
    }
    std::sort(survivors.begin(), survivors.end());
    survivors.erase(std::unique(survivors.begin(), survivors.end()), survivors.end());
    for (const int v : survivors)
        collect(v, v);
    return outs;
}

// Gives each vertex that stays a half-edge that stays, one on the boundary if there is any.
void surface_triangle(Kernel &kernel, const std::vector<Out> &outs, const std::vector<int> &gone_edges) {
    for (const Out &out : outs)
        if (!contains(gone_edges, out.halfedge.idx() / 2))
            kernel.set_halfedge_handle(Vertex(out.survivor), out.halfedge);
    for (const Out &out : outs)
        if (!contains(gone_edges, out.halfedge.idx() / 2) && kernel.is_boundary(out.halfedge))
            kernel.set_halfedge_handle(Vertex(out.survivor), out.halfedge);
}

} // namespace

QuadMesh::Collapsed QuadMesh::collapse_chord(std::span<const int> sides,
                                             std::span<const std::array<int, 2>> merged) {
    refuse_with_journal();
    check_sizes();
    Gone gone = find_gone(*this, sides, merged);
    const Rails heirs = find_heirs(kernel_, sides, gone);
    const std::vector<Out> outs = find_outs(kernel_, merged, gone.vertices);
    Ids new_faces(gone.faces, 0, kernel_.n_faces()), new_edges(gone.edges, 0, kernel_.n_edges()),
        new_vertices(gone.vertices, 0, kernel_.n_vertices());
    Collapsed result;
    for (const int edge : gone.edges)
        if (!contains(gone.crossed, edge))
            result.glued.push_back({edge, heirs.heir(edge)});

    // From here on nothing throws.
    for (const Out &out : outs) {
        const int v = kernel_.from_vertex_handle(out.halfedge).idx();
        if (v == out.survivor)
            continue;
        kernel_.set_vertex_handle(kernel_.opposite_halfedge_handle(out.halfedge), Vertex(out.survivor));
        if (!kernel_.is_boundary(out.halfedge)) {
            auto &corners = corners_[at(kernel_.face_handle(out.halfedge).idx())];
            std::replace(corners.begin(), corners.end(), v, out.survivor);
        }
    }
    for (const int side : {sides.front() ^ 1, sides.back()})
        if (kernel_.is_boundary(Halfedge(side)))
            bypass(kernel_, Halfedge(side));
    for (const int side : sides)
        if (!kernel_.is_boundary(Halfedge(side))) {
            const auto [kept, lost] = rails(kernel_, side);
            const std::size_t k = at(kept.idx() / 2), l = at(lost.idx() / 2);
            glue(kernel_, kept, lost);
            edge_flags[k] |= edge_flags[l];
            if (!edge_marker.empty() && edge_marker[k] == 0)
                edge_marker[k] = edge_marker[l];
        }
    surface_triangle(kernel_, outs, gone.edges);
    close_gaps(new_faces, new_edges, new_vertices);
    result.moved_faces = std::move(new_faces.moves);
    result.moved_edges = std::move(new_edges.moves);
    result.moved_vertices = std::move(new_vertices.moves);
    return result;
}

} // namespace alphamst::mesh
