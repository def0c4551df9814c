#include "chord/judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "chord/step.h"
#include "index.h"
#include "mesh/link.h"

namespace alphamst::chord {
namespace {

template <class T> T value(const std::vector<T> &property, int id) {
    return property.empty() ? T{0} : property[at(id)];
}

constexpr double corner = std::numeric_limits<double>::infinity();
constexpr int least_valence = 3, most_valence = 6;

int start_of(const mesh::Kernel &kernel, int side) {
    return kernel.to_vertex_handle(Halfedge(side ^ 1)).idx();
}
int end_of(const mesh::Kernel &kernel, int side) { return kernel.to_vertex_handle(Halfedge(side)).idx(); }

bool outer(const mesh::Kernel &kernel, int edge) {
    return kernel.is_boundary(Halfedge(2 * edge)) || kernel.is_boundary(Halfedge(2 * edge + 1));
}

// On the mesh boundary, flagged, numbered or between two regions.
bool on_curve(const mesh::QuadMesh &mesh, int edge) {
    if (value(mesh.edge_flags, edge) != 0 || value(mesh.edge_marker, edge) != 0)
        return true;
    const int left = mesh.kernel().face_handle(Halfedge(2 * edge)).idx();
    const int right = mesh.kernel().face_handle(Halfedge(2 * edge + 1)).idx();
    return left < 0 || right < 0 || value(mesh.face_marker, left) != value(mesh.face_marker, right);
}

OpenMesh::Vec3d direction(const mesh::QuadMesh &mesh, int from, int to) {
    return mesh.point(to) - mesh.point(from);
}

// Whether a vertex may not move, and by how many degrees the curve through it turns there: 0 if there
// is none, infinite at an end, a crossing or a flag that holds it.
struct Hold {
    bool held = false;
    double turn = 0;
};
Hold hold_of(const mesh::QuadMesh &mesh, int v, const Rules &rules) {
    const std::uint8_t flags = value(mesh.vertex_flags, v);
    std::vector<int> curve; // the other ends of its edges
    bool fixed = (flags & (mesh::fixed | mesh::corner)) != 0;
    mesh::around(mesh.kernel(), v, [&](Halfedge h) {
        if (on_curve(mesh, h.idx() / 2))
            curve.push_back(mesh.kernel().to_vertex_handle(h).idx());
        const int face = mesh.kernel().face_handle(h).idx();
        fixed |= face >= 0 && (value(mesh.face_flags, face) & mesh::fixed) != 0;
    });
    if (fixed || (curve.empty() && flags != 0) || (!curve.empty() && curve.size() != 2))
        return {true, corner};
    if (curve.empty())
        return {};
    if (rules.spared)
        return {true, rules.spared(mesh, v) ? 0 : corner};
    const OpenMesh::Vec3d a = direction(mesh, curve[0], v), b = direction(mesh, v, curve[1]);
    return {true, std::atan2(OpenMesh::cross(a, b).norm(), OpenMesh::dot(a, b)) * 180 / std::numbers::pi};
}

void test_fixed(const mesh::QuadMesh &mesh, const Chord &chord, Verdict &result) {
    for (const int side : chord.sides)
        if ((value(mesh.edge_flags, side / 2) & mesh::fixed) != 0)
            result.refuse(is_fixed, Entity::edge, side / 2);
    for (const int face : chord.faces)
        if ((value(mesh.face_flags, face) & mesh::fixed) != 0)
            result.refuse(is_fixed, Entity::face, face);
}

} // namespace

std::string Verdict::text() const {
    const std::string place = std::string(entity == Entity::vertex ? "vertex"
                                          : entity == Entity::edge ? "edge"
                                                                   : "face") +
                              " {}";
    switch (first) {
    case crosses_itself:
        return "it crosses itself at " + place + ", which would be crushed to a point";
    case closes_up:
        return "its two borders join at " + place + ", and no surface would be left between them";
    case at_boundary:
        return "at " + place + " it would change the mesh boundary or join two parts of it";
    case is_fixed:
        return place + " is FIXED and would go or move";
    case at_feature:
        return "at " + place + " two features, or two corners of one, would be merged";
    case bad_valence:
        return place + " would get a valence below 3 or above 6";
    case doubles_edge:
        break;
    }
    return "at " + place + " two edges would join the same vertices, or a face would have one twice";
}

Verdict judge_split(const mesh::QuadMesh &mesh, const Chord &chord, const Rules &rules) {
    Verdict result;
    test_fixed(mesh, chord, result);
    if (!chord.closed && !rules.boundary)
        result.refuse(at_boundary, Entity::edge, chord.sides.front() / 2);
    return result;
}

std::int64_t faces_added(const Chord &chord, int copies) {
    const std::int64_t n = copies;
    return n * static_cast<std::int64_t>(chord.length()) + n * n * chord.crossings;
}

Judge::Judge(const mesh::QuadMesh &mesh, const Rules &rules)
    : mesh_(mesh), rules_(rules), vertices_(at(mesh.n_vertices())), edges_(at(mesh.n_edges())),
      group_(at(mesh.n_vertices()), -1), crossed_(at(mesh.n_edges()), 0), passed_(at(mesh.n_faces()), 0),
      outside_(at(mesh.n_edges()), 0) {}

Collapse Judge::operator()(const Chord &chord) {
    Collapse result;
    if (chord.crossings > 0) {
        std::vector<int> faces = chord.faces;
        std::sort(faces.begin(), faces.end());
        result.refuse(crosses_itself, Entity::face, *std::adjacent_find(faces.begin(), faces.end()));
        return result;
    }
    for (const int side : chord.sides)
        crossed_[at(side / 2)] = 1;
    for (const int face : chord.faces)
        passed_[at(face)] = 1;
    merge(chord, result);
    glue(chord, result);
    if (result.reasons == 0) {
        test_fixed(mesh_, chord, result);
        const std::vector<Count> counts = gather(chord, result);
        for (std::size_t g = 0; g < result.groups.size(); ++g) {
            accept_or_roll_back(result.groups[g], counts[g], result);
            test_surroundings(result.groups[g], result);
        }
    }
    clear(chord);
    return result;
}

// The ends of each edge become one vertex. Where they are one already, a ring of edges would be
// drawn together: the surface would be torn or pinched.
void Judge::merge(const Chord &chord, Collapse &result) {
    for (const int side : chord.sides) {
        const int a = vertices_.find(start_of(mesh_.kernel(), side)),
                  b = vertices_.find(end_of(mesh_.kernel(), side));
        if (a == b)
            result.refuse(closes_up, Entity::edge, side / 2);
        vertices_.unite(a, b);
    }
}

// The two rails of each face become one edge, which needs a face at one of its sides.
void Judge::glue(const Chord &chord, Collapse &result) {
    const mesh::Kernel &kernel = mesh_.kernel();
    for (std::size_t i = 0; i < chord.length(); ++i)
        edges_.unite(rail_at_start(kernel, chord.sides[i]) / 2, rail_at_end(kernel, chord.sides[i]) / 2);
    const auto rails = [&](std::size_t i) {
        return std::array{rail_at_end(kernel, chord.sides[i]), rail_at_start(kernel, chord.sides[i])};
    };
    for (std::size_t i = 0; i < chord.length(); ++i)
        for (const int rail : rails(i)) {
            const int face = kernel.face_handle(Halfedge(rail ^ 1)).idx();
            if (face >= 0 && !passed_[at(face)])
                outside_[at(edges_.find(rail / 2))] = 1;
        }
    for (std::size_t i = 0; i < chord.length(); ++i)
        if (const int edge = edges_.find(rails(i)[0] / 2); !outside_[at(edge)])
            result.refuse(closes_up, Entity::edge, edge);
}

std::vector<Judge::Count> Judge::gather(const Chord &chord, Collapse &result) {
    const mesh::Kernel &kernel = mesh_.kernel();
    std::vector<Count> counts;
    std::vector<int> seen;
    for (const int side : chord.sides) {
        int &group = group_[at(vertices_.find(start_of(kernel, side)))];
        if (group < 0) {
            group = static_cast<int>(result.groups.size());
            result.groups.emplace_back();
            counts.emplace_back();
        }
        Count &count = counts[at(group)];
        ++count.edges;
        count.boundary_edges += outer(kernel, side / 2);
        count.curve_edges += on_curve(mesh_, side / 2);
        for (const int v : {start_of(kernel, side), end_of(kernel, side)})
            result.groups[at(group)].others.push_back(v);
        if (outer(kernel, side / 2) && !rules_.boundary)
            result.refuse(at_boundary, Entity::edge, side / 2);
        else if (on_curve(mesh_, side / 2) && !rules_.boundary && !rules_.spared)
            result.refuse(at_feature, Entity::vertex, start_of(kernel, side));
    }
    for (Group &group : result.groups) {
        std::sort(group.others.begin(), group.others.end());
        group.others.erase(std::unique(group.others.begin(), group.others.end()), group.others.end());
    }
    return counts;
}

// Chooses the survivor; judges its valence and counts singular vertices.
void Judge::accept_or_roll_back(Group &group, const Count &count, Collapse &result) const {
    test_curves(group, count, result);
    int valence = -4 * (count.edges - count.boundary_edges) - 3 * count.boundary_edges, boundary = 0;
    for (const int v : group.others) {
        valence += mesh_.valence(v);
        boundary += mesh_.on_boundary(v);
        result.singular_change -= mesh_.singular(v);
    }
    if (boundary - count.boundary_edges > 1)
        result.refuse(at_boundary, Entity::vertex, group.survivor);
    if (valence > most_valence || (boundary == 0 && valence < least_valence))
        result.refuse(bad_valence, Entity::vertex, group.survivor);
    result.singular_change += boundary == 0 && valence != 4;
    std::erase(group.others, group.survivor);
}

// At most one vertex that may not move, or several in a row on one curve of which one alone is a
// corner. The sharpest stays.
void Judge::test_curves(Group &group, const Count &count, Collapse &result) const {
    int held = 0, corners = 0, boundary = 0, fixed = 0;
    double sharpest = -1;
    for (const int v : group.others) {
        const Hold hold = hold_of(mesh_, v, rules_);
        held += hold.held;
        boundary += mesh_.on_boundary(v);
        fixed += (value(mesh_.vertex_flags, v) & mesh::fixed) != 0;
        corners += hold.held && hold.turn > rules_.straight;
        const double rank = hold.held ? hold.turn : -1;
        if (group.survivor < 0 || rank > sharpest) {
            group.survivor = v;
            sharpest = rank;
        }
    }
    group.held = held > 0;
    if (held - count.curve_edges > 1 || corners > 1)
        result.refuse(fixed > 1          ? is_fixed
                      : boundary == held ? at_boundary
                                         : at_feature,
                      Entity::vertex, group.survivor);
}

// Nothing beside the chord may be doubled by the merger.
void Judge::test_surroundings(const Group &group, Collapse &result) {
    const mesh::Kernel &kernel = mesh_.kernel();
    const int self = vertices_.find(group.survivor);
    neighbours_.clear();
    bool doubled = false;
    const auto visit = [&](int v) {
        mesh::around(kernel, v, [&](Halfedge h) {
            const int face = kernel.face_handle(h).idx();
            const int across = kernel.to_vertex_handle(kernel.next_halfedge_handle(h)).idx();
            doubled |= face >= 0 && !passed_[at(face)] && vertices_.find(across) == self;
            if (crossed_[at(h.idx() / 2)])
                return;
            const int neighbour = vertices_.find(kernel.to_vertex_handle(h).idx());
            doubled |= neighbour == self;
            neighbours_.push_back({neighbour, edges_.find(h.idx() / 2)});
        });
    };
    visit(group.survivor);
    for (const int v : group.others)
        visit(v);
    std::sort(neighbours_.begin(), neighbours_.end());
    for (std::size_t i = 1; i < neighbours_.size(); ++i)
        doubled |= neighbours_[i][0] == neighbours_[i - 1][0] && neighbours_[i][1] != neighbours_[i - 1][1];
    if (doubled)
        result.refuse(doubles_edge, Entity::vertex, group.survivor);
}

void Judge::clear(const Chord &chord) {
    const mesh::Kernel &kernel = mesh_.kernel();
    for (std::size_t i = 0; i < chord.sides.size(); ++i) {
        const int side = chord.sides[i];
        crossed_[at(side / 2)] = 0;
        for (const int v : {start_of(kernel, side), end_of(kernel, side)}) {
            vertices_.separate(v);
            group_[at(v)] = -1;
        }
        if (i >= chord.length())
            continue;
        passed_[at(chord.faces[i])] = 0;
        for (const int rail : {rail_at_end(kernel, side), rail_at_start(kernel, side)}) {
            edges_.separate(rail / 2);
            outside_[at(rail / 2)] = 0;
        }
    }
}

} // namespace alphamst::chord
