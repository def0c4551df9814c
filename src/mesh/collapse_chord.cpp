// Zipping a chord up: everything is found and allocated first, then written without a throw.
#include <algorithm>

#include "mesh/ids.h"
#include "mesh/link.h"

namespace alphamst::mesh {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

} // namespace

QuadMesh::Collapsed QuadMesh::collapse_chord(std::span<const int> sides,
                                             std::span<const std::array<int, 2>> merged) {
    check_sizes();
    std::vector<int> faces, crossed, gone_vertices, rail_edges;
    const auto rails = [&](int side) { // at its end, at its start
        return std::array{kernel_.next_halfedge_handle(Halfedge(side)),
                          kernel_.prev_halfedge_handle(Halfedge(side))};
    };
    for (const int side : sides) {
        if (side < 0 || at(side) >= kernel_.n_halfedges())
            refuse("a chord has an edge that is not in the mesh");
        crossed.push_back(side / 2);
        if (kernel_.is_boundary(Halfedge(side)))
            continue;
        faces.push_back(kernel_.face_handle(Halfedge(side)).idx());
        for (const Halfedge rail : rails(side))
            rail_edges.push_back(rail.idx() / 2);
    }
    crossed = sorted(std::move(crossed), "a chord passes an edge twice");
    faces = sorted(std::move(faces), "a chord crosses itself");
    for (const auto &[gone, survivor] : merged) {
        if (gone < 0 || survivor < 0 || std::max(gone, survivor) >= n_vertices())
            refuse("a chord has a vertex that is not in the mesh");
        gone_vertices.push_back(gone);
    }
    gone_vertices = sorted(std::move(gone_vertices), "a vertex of a chord is merged twice");

    Collapsed result;
    Rails heirs(rail_edges);
    std::vector<int> gone_edges = crossed;
    for (const int side : sides) {
        if (kernel_.is_boundary(Halfedge(side)))
            continue;
        const auto [at_end, at_start] = rails(side);
        const int kept = heirs.heir(at_end.idx() / 2), gone = heirs.heir(at_start.idx() / 2);
        if (kept == gone)
            refuse("the borders of a chord close up");
        heirs.glue(gone, kept);
        gone_edges.push_back(gone);
    }
    gone_edges = sorted(std::move(gone_edges), "an edge goes twice with a chord");
    std::vector<Out> outs;
    const auto collect = [&](int v, int survivor) {
        around(kernel_, v, [&](Halfedge h) { outs.push_back({h, survivor}); });
    };
    for (const auto &[gone, survivor] : merged) {
        if (contains(gone_vertices, survivor))
            refuse("a vertex that stays goes as well");
        collect(gone, survivor);
    }
    std::vector<int> survivors;
    for (const auto &[gone, survivor] : merged)
        survivors.push_back(survivor);
    std::sort(survivors.begin(), survivors.end());
    survivors.erase(std::unique(survivors.begin(), survivors.end()), survivors.end());
    for (const int v : survivors)
        collect(v, v);
    Ids new_faces(faces, 0, kernel_.n_faces()), new_edges(gone_edges, 0, kernel_.n_edges()),
        new_vertices(gone_vertices, 0, kernel_.n_vertices());
    for (const int edge : gone_edges)
        if (!contains(crossed, edge))
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
            const auto [kept, gone] = rails(side);
            const std::size_t k = at(kept.idx() / 2), g = at(gone.idx() / 2);
            glue(kernel_, kept, gone);
            edge_flags[k] |= edge_flags[g];
            if (!edge_marker.empty() && edge_marker[k] == 0)
                edge_marker[k] = edge_marker[g];
        }
    for (const Out &out : outs)
        if (!contains(gone_edges, out.halfedge.idx() / 2))
            kernel_.set_halfedge_handle(Vertex(out.survivor), out.halfedge);
    for (const Out &out : outs)
        if (!contains(gone_edges, out.halfedge.idx() / 2) && kernel_.is_boundary(out.halfedge))
            kernel_.set_halfedge_handle(Vertex(out.survivor), out.halfedge);
    for (const auto &[from, to] : new_faces.moves)
        move_face(from, to);
    for (const auto &[from, to] : new_edges.moves)
        move_edge(from, to);
    for (const auto &[from, to] : new_vertices.moves)
        move_vertex(from, to);
    resize(new_vertices.after, new_edges.after, new_faces.after);
    result.moved_faces = std::move(new_faces.moves);
    result.moved_edges = std::move(new_edges.moves);
    result.moved_vertices = std::move(new_vertices.moves);
    return result;
}

} // namespace alphamst::mesh
