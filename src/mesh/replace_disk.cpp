// Surgery in three steps: look at the disk and at the new quads, refuse what does not
// fit; accept_or_roll_back every id and allocate; write. Only the last step changes the mesh, and
// nothing in it can throw.
#include <algorithm>
#include <cmath>

#include "index.h"
#include "mesh/ids.h"
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

// The boundary loop: vertices in ascending order, with their places.
class Loop {
public:
    Loop(std::span<const int> loop, int n_vertices) : loop_(loop), places_(loop.size()) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (loop[i] < 0 || loop[i] >= n_vertices)
                refuse("the loop of a disk names a vertex that is not in the mesh");
            places_[i] = {loop[i], static_cast<int>(i)};
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
    std::size_t size() const { return loop_.size(); }

private:
    std::span<const int> loop_;
    std::vector<std::array<int, 2>> places_;
};

// What goes, ascending, and the half-edges of the loop that stay.
struct Disk {
    std::vector<int> faces, edges, vertices;
    std::vector<int> sides; // [loop] from here to the next vertex, the disk at the left
};

void test_points(std::span<const OpenMesh::Vec3d> points) {
    for (const auto &point : points)
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
            refuse("a new vertex has a coordinate that is infinite or not a number");
}

Disk find_disk(const Kernel &kernel, std::span<const int> faces, const Loop &loop) {
    Disk disk{{faces.begin(), faces.end()}, {}, {}, std::vector<int>(loop.size(), -1)};
    std::sort(disk.faces.begin(), disk.faces.end());
    if (faces.empty() || disk.faces.front() < 0 || at(disk.faces.back()) >= kernel.n_faces())
        refuse("a disk needs faces of the mesh");
    if (repeats(disk.faces))
        refuse("a disk names a face twice");

    Sides across(faces.size());
    std::size_t rim = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Halfedge h = kernel.halfedge_handle(Face(disk.faces[f]));
        for (int &neighbour : across[f]) {
            const int from = kernel.from_vertex_handle(h).idx();
            const int corner = loop.place(from);
            neighbour = place(disk.faces, kernel.face_handle(kernel.opposite_halfedge_handle(h)).idx());
            if (neighbour < 0) {
                if (corner < 0 || loop.next(corner) != kernel.to_vertex_handle(h).idx())
                    refuse("the loop is not the boundary of the disk at face {}", Entity::face,
                           {disk.faces[f]});
                disk.sides[at(corner)] = h.idx();
                ++rim;
            } else if (h.idx() % 2 == 0) {
                disk.edges.push_back(h.idx() / 2);
            }
            if (corner < 0)
                disk.vertices.push_back(from);
            h = kernel.next_halfedge_handle(h);
        }
    }
    if (rim != loop.size())
        refuse("the loop is longer than the boundary of the disk");
    std::sort(disk.edges.begin(), disk.edges.end());
    std::sort(disk.vertices.begin(), disk.vertices.end());
    disk.vertices.erase(std::unique(disk.vertices.begin(), disk.vertices.end()), disk.vertices.end());
    if (disk.vertices.size() + disk.faces.size() != disk.edges.size() + 1 || !connected(across))
        refuse("the faces are not a disk");
    return disk;
}

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

// An edge inside between two vertices of the loop must not be in the mesh already.
void test_chords(const QuadMesh &mesh, const Disk &disk, std::span<const int> loop, Quads quads,
                 const std::vector<int> &twins) {
    const int n_loop = static_cast<int>(loop.size());
    for (int c = 0; c < static_cast<int>(twins.size()); ++c) {
        const auto &quad = quads[at(c / 4)];
        const int from = quad[at(c % 4)], to = quad[at((c + 1) % 4)];
        if (twins[at(c)] < c || from >= n_loop || to >= n_loop)
            continue;
        const int edge = mesh.find_edge(loop[at(from)], loop[at(to)]);
        if (edge >= 0 && place(disk.edges, edge) < 0)
            refuse("a new edge would double edge {}, which is outside the disk", Entity::edge, {edge});
    }
}

// The half-edge at each corner of the quads: those of the loop stay, new edges are numbered in the order
// in which the quads come to them.
std::vector<int> number_sides(Quads quads, const std::vector<int> &twins, const Disk &disk,
                              const Ids &new_edges) {
    std::vector<int> sides(twins.size());
    for (std::size_t c = 0, edge = 0; c < twins.size(); ++c) {
        if (twins[c] < 0)
            sides[c] = disk.sides[at(quads[c / 4][c % 4])];
        else
            sides[c] = at(twins[c]) < c ? sides[at(twins[c])] ^ 1 : 2 * new_edges.ids[edge++];
    }
    return sides;
}

std::int32_t most_frequent_marker(const std::vector<std::int32_t> &markers, const std::vector<int> &faces) {
    if (markers.empty())
        return 0;
    std::vector<std::int32_t> sorted;
    for (const int f : faces)
        sorted.push_back(markers[at(f)]);
    std::sort(sorted.begin(), sorted.end());
    std::ptrdiff_t most = 0;
    std::int32_t result = 0;
    for (auto i = sorted.begin(); i != sorted.end();) {
        const auto end = std::upper_bound(i, sorted.end(), *i);
        if (end - i > most) {
            most = end - i;
            result = *i;
        }
        i = end;
    }
    return result;
}

} // namespace

void QuadMesh::move_vertex(int from, int to) {
    around(kernel_, from, [&](Halfedge h) {
        kernel_.set_vertex_handle(kernel_.opposite_halfedge_handle(h), Vertex(to));
        if (!kernel_.is_boundary(h)) {
            auto &corners = corners_[at(kernel_.face_handle(h).idx())];
            std::replace(corners.begin(), corners.end(), from, to);
        }
    });
    kernel_.set_halfedge_handle(Vertex(to), kernel_.halfedge_handle(Vertex(from)));
    kernel_.set_point(Vertex(to), kernel_.point(Vertex(from)));
    vertex_flags[at(to)] = vertex_flags[at(from)];
    vertex_origin[at(to)] = vertex_origin[at(from)];
}

void QuadMesh::move_edge(int from, int to) {
    for (int side = 0; side < 2; ++side) {
        const Halfedge old(2 * from + side), moved(2 * to + side);
        const Vertex start = kernel_.from_vertex_handle(old);
        const Face face = kernel_.face_handle(old);
        kernel_.set_vertex_handle(moved, kernel_.to_vertex_handle(old));
        kernel_.set_face_handle(moved, face);
        kernel_.set_next_halfedge_handle(kernel_.prev_halfedge_handle(old), moved);
        kernel_.set_next_halfedge_handle(moved, kernel_.next_halfedge_handle(old));
        if (kernel_.halfedge_handle(start) == old)
            kernel_.set_halfedge_handle(start, moved);
        if (face.is_valid() && kernel_.halfedge_handle(face) == old)
            kernel_.set_halfedge_handle(face, moved);
    }
    edge_flags[at(to)] = edge_flags[at(from)];
    edge_origin[at(to)] = edge_origin[at(from)];
    if (!edge_marker.empty())
        edge_marker[at(to)] = edge_marker[at(from)];
}

void QuadMesh::move_face(int from, int to) {
    const Halfedge first = kernel_.halfedge_handle(Face(from));
    kernel_.set_halfedge_handle(Face(to), first);
    Halfedge h = first;
    do {
        kernel_.set_face_handle(h, Face(to));
        h = kernel_.next_halfedge_handle(h);
    } while (h != first);
    corners_[at(to)] = corners_[at(from)];
    face_flags[at(to)] = face_flags[at(from)];
    face_origin[at(to)] = face_origin[at(from)];
    if (!face_marker.empty())
        face_marker[at(to)] = face_marker[at(from)];
}

void QuadMesh::close_gaps(const Ids &faces, const Ids &edges, const Ids &vertices) {
    for (const auto &[from, to] : faces.moves)
        move_face(from, to);
    for (const auto &[from, to] : edges.moves)
        move_edge(from, to);
    for (const auto &[from, to] : vertices.moves)
        move_vertex(from, to);
    resize(vertices.after, edges.after, faces.after);
}

QuadMesh::Replaced QuadMesh::replace_disk(std::span<const int> faces, std::span<const int> loop,
                                          std::span<const std::array<int, 4>> quads,
                                          std::span<const OpenMesh::Vec3d> points) {
    check_sizes();
    const int n_loop = static_cast<int>(loop.size());
    const int n_local = n_loop + static_cast<int>(points.size());
    test_points(points);
    const Disk disk = find_disk(kernel_, faces, Loop(loop, n_vertices()));
    const std::vector<int> twins = match(quads, n_loop, n_local);
    test_filling(quads, twins, n_loop, n_local);
    test_chords(*this, disk, loop, quads, twins);

    // Every id, and all memory.
    Ids new_faces(disk.faces, quads.size(), kernel_.n_faces());
    Ids new_vertices(disk.vertices, points.size(), kernel_.n_vertices());
    const Ids new_edges(disk.edges, (twins.size() - loop.size()) / 2, kernel_.n_edges());
    const std::int32_t marker = most_frequent_marker(face_marker, disk.faces);
    std::vector<int> vertices(loop.begin(), loop.end());
    vertices.insert(vertices.end(), new_vertices.ids.begin(), new_vertices.ids.end());
    const std::vector<int> sides = number_sides(quads, twins, disk, new_edges);
    reserve(new_vertices.during, new_edges.during, new_faces.during);

    // From here on nothing throws.
    resize(new_vertices.during, new_edges.during, new_faces.during);
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const int face = new_faces.ids[q];
        std::array<int, 4> own;
        std::array<int, 4> &corners = corners_[at(face)];
        for (std::size_t i = 0; i < 4; ++i) {
            own[i] = sides[4 * q + i];
            corners[i] = vertices[at(quads[q][i])];
            if (quads[q][i] >= n_loop)
                kernel_.set_halfedge_handle(Vertex(corners[i]), Halfedge(own[i]));
        }
        link_face(kernel_, face, own, corners);
        face_flags[at(face)] = 0;
        face_origin[at(face)] = -1;
        if (!face_marker.empty())
            face_marker[at(face)] = marker;
    }
    for (const int edge : new_edges.ids) {
        edge_flags[at(edge)] = 0;
        edge_origin[at(edge)] = -1;
        if (!edge_marker.empty())
            edge_marker[at(edge)] = 0;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int v = new_vertices.ids[i];
        kernel_.set_point(Vertex(v), points[i]);
        vertex_flags[at(v)] = 0;
        vertex_origin[at(v)] = -1;
    }
    // A vertex on the boundary keeps its half-edge: that one has no face, so it stays.
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (!on_boundary(loop[i]))
            kernel_.set_halfedge_handle(Vertex(loop[i]), Halfedge(disk.sides[i]));
    close_gaps(new_faces, new_edges, new_vertices);
    return {std::move(new_faces.ids), std::move(new_vertices.ids), std::move(new_faces.moves),
            std::move(new_vertices.moves)};
}

} // namespace alphamst::mesh
