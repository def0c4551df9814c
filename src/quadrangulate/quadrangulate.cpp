#include "quadrangulate/quadrangulate.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "disjoint_sets.h"
#include "failure.h"
#include "index.h"
#include "mesh/components.h"
#include "mesh/defects.h"
#include "quadrangulate/bars.h"
#include "quadrangulate/flat_sides.h"
#include "quadrangulate/halve.h"
#include "quadrangulate/joining.h"
#include "quadrangulate/pairing.h"
#include "quadrangulate/pillow.h"
#include "quadrangulate/recut.h"
#include "quadrangulate/row.h"
#include "quadrangulate/through_quads.h"

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
        split_face(quads, faces, f, static_cast<std::int32_t>(f),
                   [&](std::size_t c) { return first + halfedges.of_corner[c] / 2; });
}

bool has_quads(mesh::Faces faces) {
    for (std::size_t f = 0; f < faces.size() / 4; ++f)
        if (!mesh::is_triangle(faces, f))
            return true;
    return false;
}

// Failure where one component, or several, would get vertices on the boundary.
void require_even(mesh::Faces faces, const std::vector<std::int32_t> &across) {
    DisjointSets components(faces.size() / 4);
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (across[c] > static_cast<std::int32_t>(c))
            components.unite(static_cast<std::int32_t>(c / 4), across[c] / 4);
    std::vector<std::int32_t> triangles(faces.size() / 4);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        if (mesh::is_triangle(faces, f))
            ++triangles[components.find(f)];
    for (std::size_t f = 0; f < triangles.size(); ++f)
        if (const std::int32_t n = triangles[components.find(f)]; n % 2 == 1)
            throw Failure(Fault::argument,
                          "the triangles connected with face {} are " + std::to_string(n) +
                              ", an odd number, of which quads can only be made with a new vertex on the "
                              "boundary: allow it, or make one triangle more or less of them",
                          Entity::face, {static_cast<std::int64_t>(f)});
}

void require_closed(mesh::Faces faces, const std::vector<std::int32_t> &across) {
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0 && across[c] < 0)
            throw Failure(
                Fault::argument,
                "face {} has a side on the boundary, which cannot be split in two where new vertices "
                "on the boundary are forbidden: pair the triangles, or allow it",
                Entity::face, {static_cast<std::int64_t>(c / 4)});
}

// Triangles that have but sides to be halved, each on its own or together a closed surface, are split in
// three: halved once they would have corners of 180 degrees.
void split_bodies(const std::vector<std::int32_t> &across, std::vector<Choice> &choices) {
    const auto is_halved = [&](std::size_t f) { return choices[f].kind == Choice::Kind::halve; };
    for (std::size_t f = 0; f < choices.size(); ++f)
        if (is_halved(f) && across[4 * f] < 0 && across[4 * f + 1] < 0 && across[4 * f + 2] < 0)
            choices[f].kind = Choice::Kind::split;
    std::vector<bool> seen(choices.size());
    for (std::size_t first = 0; first < choices.size(); ++first) {
        if (seen[first] || !is_halved(first))
            continue;
        std::vector<std::size_t> body{first};
        seen[first] = true;
        bool all = true;
        for (std::size_t head = 0; head < body.size(); ++head)
            for (std::size_t c = 4 * body[head]; c < 4 * body[head] + 3; ++c) {
                if (across[c] < 0 || !is_halved(at(across[c]) / 4)) {
                    all = false;
                } else if (!seen[at(across[c]) / 4]) {
                    seen[at(across[c]) / 4] = true;
                    body.push_back(at(across[c]) / 4);
                }
            }
        for (const std::size_t f : body)
            if (all)
                choices[f].kind = Choice::Kind::split;
    }
}

void sort_midpoints(QuadArrays &quads) {
    std::sort(quads.midpoints.begin(), quads.midpoints.end(),
              [](const QuadArrays::Midpoint &a, const QuadArrays::Midpoint &b) { return a.edge < b.edge; });
}

// The vertices on these edges, and on what is left of them in pieces.
std::vector<bool> vertices_on(const QuadArrays &quads, const std::vector<Edge> &edges) {
    std::vector<bool> fixed(quads.points.size() / 3);
    for (const Edge &edge : edges)
        for (const auto &[v, w] : pieces(quads, edge))
            fixed[at(v)] = fixed[at(w)] = true;
    return fixed;
}

std::vector<Edge> boundary_edges(mesh::Faces faces, const std::vector<std::int32_t> &across) {
    std::vector<Edge> edges;
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (faces[c] >= 0 && across[c] < 0)
            edges.push_back({faces[c], faces[mesh::next_corner(faces, c)]});
    return edges;
}

bool in_plane(const QuadArrays &quads) {
    for (std::size_t i = 2; i < quads.points.size(); i += 3)
        if (quads.points[i] != quads.points[2])
            return false;
    return true;
}

void pair(const Polygons &polygons, const mesh::Halfedges &halfedges, const PairingRules &rules,
          QuadArrays &quads) {
    Paired paired;
    TriangleSides &sides = paired.sides;
    sides.across = across_edges(polygons.faces, halfedges);
    sides.bars = bars_of(polygons, polygons.faces, {}, sides.across, rules.sharp_angle);
    if (!polygons.held.empty())
        sides.held.resize(polygons.points.size() / 3);
    for (const std::int32_t v : polygons.held)
        sides.held[at(v)] = true;
    unite_odd_sides(polygons.points, polygons.faces, sides);
    const std::vector<Edge> boundary = boundary_edges(polygons.faces, sides.across);
    std::vector<Edge> barred = barred_edges(polygons.faces, sides.bars);
    if (!rules.new_boundary_vertices)
        require_even(polygons.faces, sides.across);
    paired.pairing = pair_triangles(polygons.points, polygons.faces, sides, rules.new_boundary_vertices);
    if (!paired.pairing.poor.empty() && has_quads(polygons.faces))
        pair_through_quads(polygons, rules.new_boundary_vertices, paired);
    split_bodies(sides.across, paired.pairing.choices);
    const mesh::Faces faces = paired.cut.faces.empty() ? polygons.faces : mesh::Faces(paired.cut.faces);
    std::vector<Edge> flat = join({faces, paired.cut.origin, polygons.faces, sides, paired.pairing}, quads);
    split_rows(quads, flat);
    sort_midpoints(quads);
    if (!flat.empty())
        recut(quads, {polygons.points, polygons.faces, polygons.face_marker, barred}, flat,
              vertices_on(quads, boundary));
    barred.insert(barred.end(), boundary.begin(), boundary.end());
    // In a plane corners of 180 degrees or more are inverted; in space smoothing may open those inside.
    if (in_plane(quads))
        pillow(quads, std::vector<bool>(quads.points.size() / 3, true));
    else if (!barred.empty())
        pillow(quads, vertices_on(quads, barred));
}

} // namespace

QuadArrays quadrangulate(const Polygons &polygons, Quadrangulation how, const PairingRules &rules) {
    mesh::test_lengths(3, polygons.points, polygons.faces);
    test_sizes(polygons);
    mesh::test_arrays(polygons.points, polygons.faces, true);
    const std::size_t n_vertices = polygons.points.size() / 3;
    const mesh::Halfedges halfedges = mesh::pair_sides(polygons.faces, n_vertices);
    // Here rather than when the mesh is built of quads: users know the faces they gave.
    if (std::ranges::count(
            mesh::find_pinched(polygons.faces, mesh::sort_sides(polygons.faces, n_vertices), n_vertices),
            true) > 0)
        throw mesh::find_defects(polygons.points, polygons.faces, n_vertices, true);

    QuadArrays quads;
    quads.points.assign(polygons.points.begin(), polygons.points.end());
    if (how == Quadrangulation::split) {
        if (!rules.new_boundary_vertices)
            require_closed(polygons.faces, across_edges(polygons.faces, halfedges));
        split(polygons, halfedges, quads);
    } else {
        pair(polygons, halfedges, rules, quads);
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
