// Looks at disks step by step and refuses what does not fit, before anything changes.
#include "mesh/disk.h"

#include <algorithm>

#include "index.h"
#include "mesh/link.h"

namespace alphamst::mesh {
namespace {

using Quads = std::span<const std::array<int, 4>>;
using Sides = std::vector<std::array<int, 4>>; // [quad][side]

[[noreturn]] void refuse(const char *text, Entity entity = Entity::none, std::vector<std::int64_t> ids = {}) {
    throw Failure(Fault::internal, text, entity, std::move(ids));
}

// Place of a number in an ascending list, -1 if it is not there.
int place(const std::vector<int> &ascending, int number) {
    const auto found = std::lower_bound(ascending.begin(), ascending.end(), number);
    return found != ascending.end() && *found == number ? static_cast<int>(found - ascending.begin()) : -1;
}

bool repeats(const std::vector<int> &ascending) {
    return std::adjacent_find(ascending.begin(), ascending.end()) != ascending.end();
}

// Whether quads hang together through their sides; across: the quad there or -1.
bool connected(const Sides &across) {
    std::vector<char> reached(across.size());
    std::vector<int> stack{0};
    std::size_t count = 0;
    reached[0] = 1;
    while (!stack.empty()) {
        const int quad = stack.back();
        stack.pop_back();
        ++count;
        for (const int next : across[at(quad)])
            if (next >= 0 && !reached[at(next)]) {
                reached[at(next)] = 1;
                stack.push_back(next);
            }
    }
    return count == across.size();
}

// The boundary loop: vertices in ascending order, with their places. New ones are negative.
class Loop {
public:
    Loop(std::span<const int> loop, std::size_t n_vertices) : loop_(loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (loop[i] < 0)
                continue;
            if (at(loop[i]) >= n_vertices)
                refuse("the loop of a disk names a vertex that is not in the mesh");
            places_.push_back({loop[i], static_cast<int>(i)});
        }
        std::sort(places_.begin(), places_.end());
        for (std::size_t i = 1; i < places_.size(); ++i)
            if (places_[i - 1][0] == places_[i][0])
                refuse("the loop of a disk passes vertex {} twice", Entity::vertex, {places_[i][0]});
    }
    int place(int v) const { // -1 if v is not on the loop
        const auto found = std::lower_bound(places_.begin(), places_.end(), std::array<int, 2>{v, 0});
        return found != places_.end() && (*found)[0] == v ? (*found)[1] : -1;
    }
    int next(int place) const { return loop_[(at(place) + 1) % loop_.size()]; }

private:
    std::span<const int> loop_;
    std::vector<std::array<int, 2>> places_;
};

// Where vertices of the loop come or go, the old rim must lead from each vertex that stays to the next one
// that does.
void test_rim(const Kernel &kernel, const OldDisk &disk, const Loop &loop, std::span<const int> vertices) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i] < 0 || disk.sides[i] >= 0)
            continue;
        std::size_t end = i + 1;
        while (vertices[end % vertices.size()] < 0)
            ++end;
        int v = vertices[i];
        do {
            const int side = disk.rim_side(kernel, v);
            if (side < 0)
                refuse("the loop leaves the boundary of the disk at vertex {}", Entity::vertex, {v});
            v = kernel.to_vertex_handle(Halfedge(side)).idx();
            ++seen;
        } while (loop.place(v) < 0);
        if (v != vertices[end % vertices.size()])
            refuse("the loop leaves the boundary of the disk at vertex {}", Entity::vertex, {v});
    }
    const bool none_stays = std::all_of(vertices.begin(), vertices.end(), [](int v) { return v < 0; });
    if (!none_stays && seen != disk.rim.size())
        refuse("the loop is shorter than the boundary of the disk");
}

// Edges of the loop that are new have a parent among those of the rim; without parents nothing is new.
void test_parents(const Kernel &kernel, const OldDisk &disk, std::span<const int> parents) {
    const bool any = std::any_of(disk.sides.begin(), disk.sides.end(), [](int side) { return side < 0; });
    if (parents.empty() && any)
        refuse("the loop is longer than the boundary of the disk");
    if (!parents.empty() && parents.size() != disk.sides.size())
        refuse("each edge of the loop of a disk needs a parent, or none does");
    for (std::size_t i = 0; any && i < parents.size(); ++i)
        if (disk.sides[i] < 0 && disk.rim_side(kernel, parents[i]) < 0)
            refuse("a new edge of the loop of a disk has a parent that is not at its rim");
}

} // namespace

int OldDisk::rim_side(const Kernel &kernel, int vertex) const {
    const auto side = std::find_if(rim.begin(), rim.end(), [&](int h) {
        return kernel.from_vertex_handle(Halfedge(h)).idx() == vertex;
    });
    return side == rim.end() ? -1 : *side;
}

OldDisk find_disk(const Kernel &kernel, std::span<const int> faces, std::span<const int> vertices,
                  std::span<const int> parents) {
    const Loop loop(vertices, kernel.n_vertices());
    OldDisk disk{{faces.begin(), faces.end()}, {}, {}, std::vector<int>(vertices.size(), -1), {}};
    std::sort(disk.faces.begin(), disk.faces.end());
    if (faces.empty() || disk.faces.front() < 0 || at(disk.faces.back()) >= kernel.n_faces())
        refuse("a disk needs faces of the mesh");
    if (repeats(disk.faces))
        refuse("a disk names a face twice");

    Sides across(faces.size());
    std::size_t gone = 0; // vertices at the rim
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Halfedge h = kernel.halfedge_handle(Face(disk.faces[f]));
        for (int &neighbour : across[f]) {
            const Halfedge opposite = kernel.opposite_halfedge_handle(h);
            const int from = kernel.from_vertex_handle(h).idx();
            const int corner = loop.place(from);
            neighbour = place(disk.faces, kernel.face_handle(opposite).idx());
            if (neighbour >= 0) {
                if (h.idx() % 2 == 0)
                    disk.edges.push_back(h.idx() / 2);
            } else if (corner >= 0 && loop.next(corner) == kernel.to_vertex_handle(h).idx()) {
                disk.sides[at(corner)] = h.idx();
            } else if (!parents.empty() && kernel.is_boundary(opposite)) {
                disk.rim.push_back(h.idx());
                disk.edges.push_back(h.idx() / 2);
                gone += corner < 0 ? 1 : 0;
            } else {
                refuse("the loop is not the boundary of the disk at face {}", Entity::face, {disk.faces[f]});
            }
            if (corner < 0)
                disk.vertices.push_back(from);
            h = kernel.next_halfedge_handle(h);
        }
    }
    test_parents(kernel, disk, parents);
    if (!disk.rim.empty())
        test_rim(kernel, disk, loop, vertices);
    std::sort(disk.edges.begin(), disk.edges.end());
    std::sort(disk.vertices.begin(), disk.vertices.end());
    disk.vertices.erase(std::unique(disk.vertices.begin(), disk.vertices.end()), disk.vertices.end());
    if (disk.vertices.size() - gone + disk.faces.size() != disk.edges.size() - disk.rim.size() + 1 ||
        !connected(across))
        refuse("the faces are not a disk");
    return disk;
}

namespace {

// For each corner of the quads (4 * quad + i) the one whose side is the same edge from
// the other end, -1 on the loop.
std::vector<int> match(Quads quads, int n_loop, int n_vertices) {
    struct Side {
        int from, to, corner;
        bool operator<(const Side &other) const {
            return from != other.from ? from < other.from : to < other.to;
        }
    };
    std::vector<Side> sides;
    sides.reserve(4 * quads.size());
    for (const auto &quad : quads)
        for (std::size_t i = 0; i < 4; ++i) {
            if (quad[i] < 0 || quad[i] >= n_vertices)
                refuse("a new quad has a corner that is neither on the loop nor new");
            if (quad[i] == quad[(i + 1) % 4] || quad[i] == quad[(i + 2) % 4])
                refuse("a new quad has a corner twice");
            sides.push_back({quad[i], quad[(i + 1) % 4], static_cast<int>(sides.size())});
        }
    std::sort(sides.begin(), sides.end());
    std::vector<int> twins(sides.size(), -1);
    int rim = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side &side = sides[i];
        if (i > 0 && !(sides[i - 1] < side))
            refuse("two new quads run along an edge in the same direction");
        const auto twin = std::lower_bound(sides.begin(), sides.end(), Side{side.to, side.from, 0});
        const bool found = twin != sides.end() && twin->from == side.to && twin->to == side.from;
        const bool on_loop = side.from < n_loop && side.to == (side.from + 1) % n_loop;
        if (found == on_loop || (on_loop && twins[at(side.corner)] >= 0))
            refuse(on_loop ? "an edge of the loop has new quads at both sides"
                           : "an edge inside has one new quad only");
        if (found)
            twins[at(side.corner)] = twin->corner;
        rim += on_loop ? 1 : 0;
    }
    if (rim != n_loop)
        refuse("an edge of the loop has no new quad");
    return twins;
}

// The quads must be one fan at each vertex, hang together and have Euler number 1.
void test_filling(Quads quads, const std::vector<int> &twins, int n_loop, int n_vertices) {
    std::vector<int> start(at(n_vertices), -1); // where a fan begins: on the loop with its edge
    Sides across(quads.size());
    for (int c = 0; c < static_cast<int>(twins.size()); ++c) {
        const int twin = twins[at(c)];
        across[at(c / 4)][at(c % 4)] = twin < 0 ? -1 : twin / 4;
        const int v = quads[at(c / 4)][at(c % 4)];
        if (twin < 0 || v >= n_loop)
            start[at(v)] = c;
    }
    std::size_t reached = 0;
    for (const int first : start) {
        if (first < 0)
            refuse("a new vertex is in no new quad");
        int c = first;
        do {
            ++reached;
            c = twins[at(c % 4 == 0 ? c + 3 : c - 1)];
        } while (c >= 0 && c != first);
    }
    if (reached != twins.size())
        refuse("the new quads are not one fan at some vertex");
    if (2 * quads.size() + 2 != 2 * at(n_vertices) - at(n_loop) || !connected(across))
        refuse("the new quads are not a disk");
}

// An edge between two vertices of the loop that is new must not be in the mesh already.
void test_chords(const QuadMesh &mesh, const OldDisk &disk, std::span<const int> loop, Quads quads,
                 const std::vector<int> &twins) {
    const int n_loop = static_cast<int>(loop.size());
    for (int c = 0; c < static_cast<int>(twins.size()); ++c) {
        const auto &quad = quads[at(c / 4)];
        const int from = quad[at(c % 4)], to = quad[at((c + 1) % 4)];
        const bool stays = twins[at(c)] < 0 && disk.sides[at(from)] >= 0;
        if ((twins[at(c)] >= 0 && twins[at(c)] < c) || from >= n_loop || to >= n_loop || stays ||
            loop[at(from)] < 0 || loop[at(to)] < 0)
            continue;
        const int edge = mesh.find_edge(loop[at(from)], loop[at(to)]);
        if (edge >= 0 && place(disk.edges, edge) < 0)
            refuse("a new edge would double edge {}, which is outside the disk", Entity::edge, {edge});
    }
}

} // namespace

std::vector<int> fit_quads(const QuadMesh &mesh, const OldDisk &disk, std::span<const int> loop, Quads quads,
                           int n_vertices) {
    const int n_loop = static_cast<int>(loop.size());
    const std::vector<int> twins = match(quads, n_loop, n_vertices);
    test_filling(quads, twins, n_loop, n_vertices);
    test_chords(mesh, disk, loop, quads, twins);
    return twins;
}

} // namespace alphamst::mesh
