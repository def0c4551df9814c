#include "quadrangulate/quadrangulate.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>

#include "failure.h"
#include "index.h"
#include "quadrangulate/halve.h"
#include "quadrangulate/pairing.h"
#include "quadrangulate/recut.h"
#include "quadrangulate/row.h"

namespace alphamst::quadrangulate {
namespace {

using Edge = std::array<std::int32_t, 2>;

Edge sorted(Edge edge) {
    if (edge[0] > edge[1])
        std::swap(edge[0], edge[1]);
    return edge;
}

void test_sizes(const Polygons &polygons) {
    // Splitting makes four quads and at most five vertices of a face.
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max() / 8;
    const std::size_t n_faces = polygons.faces.size() / 4, n_vertices = polygons.points.size() / 3;
    if (n_faces > most / 4 || n_vertices > 8 * most - 5 * n_faces)
        throw Failure(Fault::range, std::to_string(n_faces) + " faces and " + std::to_string(n_vertices) +
                                        " vertices are too many to be made quads: ids are 32 bits wide");
}

// Three quads of a triangle, four of a quad; midpoint(c) is that of the side at corner c.
template <class Midpoint>
void split_face(QuadArrays &quads, mesh::Faces faces, std::size_t face, Midpoint midpoint) {
    const std::size_t n = mesh::is_triangle(faces, face) ? 3 : 4, first = 4 * face;
    const std::int32_t centre =
        n == 3 ? append_vertex(quads, {faces[first], faces[first + 1], faces[first + 2]})
               : append_vertex(quads, {faces[first], faces[first + 1], faces[first + 2], faces[first + 3]});
    for (std::size_t k = 0; k < n; ++k)
        add_face(quads, static_cast<std::int32_t>(face),
                 {faces[first + k], midpoint(first + k), centre, midpoint(first + (k + n - 1) % n)});
}

void split(const Polygons &polygons, const mesh::Halfedges &halfedges, QuadArrays &quads) {
    const mesh::Faces faces = polygons.faces;
    std::vector<Edge> edges(halfedges.n_edges);
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0)
            edges[at(halfedges.of_corner[c] / 2)] = sorted({faces[c], faces[mesh::next_corner(faces, c)]});
    const auto first = static_cast<std::int32_t>(quads.points.size() / 3);
    for (const auto &[v, w] : edges)
        halve(quads, v, w);
    for (std::size_t f = 0; f < faces.size() / 4; ++f)
        split_face(quads, faces, f, [&](std::size_t c) { return first + halfedges.of_corner[c] / 2; });
}

// Whether the side at each corner must not go: it is on a curve or between two regions.
std::vector<bool> barred_sides(const Polygons &polygons, const std::vector<std::int32_t> &across) {
    const mesh::Faces faces = polygons.faces;
    const auto marker = [&](std::int64_t corner) { return polygons.face_marker[at(corner / 4)]; };
    std::vector<bool> barred(faces.size());
    if (!polygons.face_marker.empty())
        for (std::size_t c = 0; c < faces.size(); ++c)
            barred[c] = across[c] >= 0 && marker(static_cast<std::int64_t>(c)) != marker(across[c]);
    std::vector<Edge> curves;
    for (const Edge &curve : polygons.curves)
        curves.push_back(sorted(curve));
    if (curves.empty())
        return barred;
    std::sort(curves.begin(), curves.end());
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0 && across[c] >= 0)
            barred[c] =
                barred[c] || std::binary_search(curves.begin(), curves.end(),
                                                sorted({faces[c], faces[mesh::next_corner(faces, c)]}));
    return barred;
}

// Makes one face of each two that are merged, at the place of the first, and quads of those that have
// a side halved; a triangle without neighbours is split in three. Returns the sides that lead
// to midpoints.
class Joining {
public:
    Joining(mesh::Faces faces, const std::vector<std::int32_t> &across, const std::vector<Choice> &choices,
            QuadArrays &quads)
        : faces_(faces), across_(across), choices_(choices), quads_(quads) {}

    std::vector<Edge> run() {
        for (std::size_t f = 0; f < choices_.size(); ++f)
            switch (choices_[f].kind) {
            case Choice::Kind::none:
                add_face(quads_, static_cast<std::int32_t>(f),
                         {faces_[4 * f], faces_[4 * f + 1], faces_[4 * f + 2], faces_[4 * f + 3]});
                break;
            case Choice::Kind::merge:
                merge(f);
                break;
            case Choice::Kind::halve:
                if (across_[4 * f] < 0 && across_[4 * f + 1] < 0 && across_[4 * f + 2] < 0)
                    split_face(quads_, faces_, f, [&](std::size_t c) { return midpoint(c); });
                else
                    halve_side(f);
                break;
            }
        return std::move(flat_);
    }

private:
    void merge(std::size_t f) {
        if (choices_[f].mate < static_cast<std::int32_t>(f))
            return;
        const std::size_t c = 4 * f + at(choices_[f].side), next = mesh::next_corner(faces_, c);
        const std::size_t other = mesh::next_corner(faces_, mesh::next_corner(faces_, at(across_[c])));
        add_face(quads_, static_cast<std::int32_t>(f),
                 {faces_[c], faces_[other], faces_[next], faces_[mesh::next_corner(faces_, next)]});
    }

    void halve_side(std::size_t f) {
        const std::size_t c = 4 * f + at(choices_[f].side), next = mesh::next_corner(faces_, c);
        const std::int32_t vertex = midpoint(c);
        add_face(quads_, static_cast<std::int32_t>(f),
                 {faces_[c], vertex, faces_[next], faces_[mesh::next_corner(faces_, next)]});
        flat_.push_back({faces_[c], vertex});
    }

    std::int32_t midpoint(std::size_t corner) {
        const std::size_t key = across_[corner] < 0 ? corner : std::min(corner, at(across_[corner]));
        const auto [place, is_new] = midpoints_.try_emplace(key);
        if (is_new)
            place->second = halve(quads_, faces_[corner], faces_[mesh::next_corner(faces_, corner)]);
        return place->second;
    }

    mesh::Faces faces_;
    const std::vector<std::int32_t> &across_;
    const std::vector<Choice> &choices_;
    QuadArrays &quads_;
    std::vector<Edge> flat_;
    std::unordered_map<std::size_t, std::int32_t> midpoints_; // at the first corner of their sides
};

void sort_midpoints(QuadArrays &quads) {
    std::sort(quads.midpoints.begin(), quads.midpoints.end(),
              [](const QuadArrays::Midpoint &a, const QuadArrays::Midpoint &b) { return a.edge < b.edge; });
}

void pair(const Polygons &polygons, const mesh::Halfedges &halfedges, QuadArrays &quads) {
    const mesh::Faces faces = polygons.faces;
    const std::vector<std::int32_t> across = across_edges(faces, halfedges);
    const std::vector<Choice> choices =
        pair_triangles(polygons.points, faces, across, barred_sides(polygons, across));
    std::vector<Edge> flat = Joining(faces, across, choices, quads).run();
    split_rows(quads, flat);
    sort_midpoints(quads);
    if (flat.empty())
        return;
    std::vector<bool> on_boundary(quads.points.size() / 3);
    const auto note = [&](std::int32_t v, std::int32_t w) {
        for (const auto &[first, last] : pieces(quads, {v, w}))
            on_boundary[at(first)] = on_boundary[at(last)] = true;
    };
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0 && across[c] < 0)
            note(faces[c], faces[mesh::next_corner(faces, c)]);
    recut(quads, polygons, flat, on_boundary);
}

} // namespace

QuadArrays quadrangulate(const Polygons &polygons, Quadrangulation how) {
    mesh::test_lengths(3, polygons.points, polygons.faces);
    test_sizes(polygons);
    mesh::test_points(polygons.points);
    const std::size_t n_vertices = polygons.points.size() / 3;
    mesh::test_corners(polygons.faces, n_vertices, true);
    const mesh::Halfedges halfedges = mesh::pair_sides(polygons.faces, n_vertices);

    QuadArrays quads;
    quads.points.assign(polygons.points.begin(), polygons.points.end());
    if (how == Quadrangulation::split) {
        split(polygons, halfedges, quads);
    } else {
        pair(polygons, halfedges, quads);
    }
    return quads;
}

std::vector<Edge> pieces(const QuadArrays &quads, Edge edge) {
    const auto found = std::lower_bound(
        quads.midpoints.begin(), quads.midpoints.end(), sorted(edge),
        [](const QuadArrays::Midpoint &midpoint, const Edge &e) { return midpoint.edge < e; });
    if (found == quads.midpoints.end() || found->edge != sorted(edge))
        return {edge};
    std::vector<Edge> result = pieces(quads, {edge[0], found->vertex});
    for (const Edge &piece : pieces(quads, {found->vertex, edge[1]}))
        result.push_back(piece);
    return result;
}

} // namespace alphamst::quadrangulate
