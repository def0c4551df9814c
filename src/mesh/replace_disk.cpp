// Surgery in three steps: look at the disk and at the new quads, refuse what does not fit (disk.cpp);
// settle every id and allocate; write. Only the last step changes the mesh, and nothing in it can throw.
#include <algorithm>
#include <cmath>

#include "index.h"
#include "mesh/disk.h"
#include "mesh/ids.h"
#include "mesh/link.h"

namespace alphamst::mesh {

namespace {

using Quads = std::span<const std::array<int, 4>>;

void test_points(std::span<const OpenMesh::Vec3d> points) {
    for (const auto &point : points)
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
            throw Failure(Fault::internal, "a new vertex has a coordinate that is infinite or not a number");
}

// The half-edge at each corner of the quads: those of the loop stay, new edges are numbered in the order
// in which the quads come to them; those on the loop are noted there, too.
std::vector<int> number_sides(Quads quads, const std::vector<int> &twins, const Ids &new_edges,
                              std::vector<int> &loop_sides) {
    std::vector<int> sides(twins.size());
    for (std::size_t c = 0, edge = 0; c < twins.size(); ++c) {
        if (twins[c] >= 0) {
            sides[c] = at(twins[c]) < c ? sides[at(twins[c])] ^ 1 : 2 * new_edges.ids[edge++];
            continue;
        }
        int &side = loop_sides[at(quads[c / 4][c % 4])];
        if (side < 0)
            side = 2 * new_edges.ids[edge++];
        sides[c] = side;
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

// [loop] Whether the edge from here is new.
std::vector<char> new_edges_of(const OldDisk &disk) {
    std::vector<char> is_new;
    for (const int side : disk.sides)
        is_new.push_back(side < 0);
    return is_new;
}

} // namespace

// New edges on the boundary of the mesh: half-edges beyond them, and what they get from their parents.
class QuadMesh::Rim {
public:
    Rim(const QuadMesh &mesh, const OldDisk &disk, std::span<const int> loop, std::span<const int> parents)
        : is_new_(new_edges_of(disk)) {
        const Kernel &kernel = mesh.kernel_;
        for (std::size_t i = 0; !disk.rim.empty() && i < loop.size(); ++i) {
            if (!is_new_[i])
                continue;
            const std::size_t parent = at(disk.rim_side(kernel, parents[i]) / 2);
            edges_.push_back({i, -1, -1, mesh.edge_flags[parent], mesh.edge_origin[parent],
                              mesh.edge_marker.empty() ? 0 : mesh.edge_marker[parent]});
            for (const int side : disk.rim) {
                const Halfedge beyond = kernel.opposite_halfedge_handle(Halfedge(side));
                if (loop[i] >= 0 && kernel.to_vertex_handle(beyond).idx() == loop[i])
                    edges_.back().next = kernel.next_halfedge_handle(beyond).idx();
                if (const int end = loop[(i + 1) % loop.size()];
                    end >= 0 && kernel.from_vertex_handle(beyond).idx() == end)
                    edges_.back().previous = kernel.prev_halfedge_handle(beyond).idx();
            }
        }
    }

    bool is_new(std::size_t i) const { return is_new_[i % is_new_.size()] != 0; }

    // sides: [loop] all of them; vertices: [loop] in the mesh.
    void link(QuadMesh &mesh, const std::vector<int> &sides, const std::vector<int> &vertices) const {
        Kernel &kernel = mesh.kernel_;
        const std::size_t n = sides.size();
        const auto beyond = [&](std::size_t i) { return Halfedge(sides[i % n] ^ 1); };
        for (const Edge &edge : edges_) {
            const std::size_t i = edge.place;
            const int e = sides[i] / 2;
            kernel.set_boundary(beyond(i));
            kernel.set_next_halfedge_handle(beyond(i),
                                            is_new(i + n - 1) ? beyond(i + n - 1) : Halfedge(edge.next));
            if (!is_new(i + 1))
                kernel.set_next_halfedge_handle(Halfedge(edge.previous), beyond(i));
            kernel.set_halfedge_handle(Vertex(vertices[(i + 1) % n]), beyond(i));
            mesh.edge_flags[at(e)] = edge.flags;
            mesh.edge_origin[at(e)] = edge.origin;
            if (!mesh.edge_marker.empty())
                mesh.edge_marker[at(e)] = edge.marker;
        }
    }

private:
    struct Edge {
        std::size_t place;  // in the loop
        int next, previous; // half-edges beyond the boundary that stay, at its ends
        std::uint8_t flags;
        std::int32_t origin, marker;
    };

    std::vector<char> is_new_;
    std::vector<Edge> edges_;
};

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
    if (!vertex_marker.empty())
        vertex_marker[at(to)] = vertex_marker[at(from)];
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

// ids: of the new faces; vertices: of the mesh; sides: [corner of a quad] its half-edge.
void QuadMesh::write_quads(std::span<const std::array<int, 4>> quads, int n_loop, const std::vector<int> &ids,
                           const std::vector<int> &vertices, const std::vector<int> &sides,
                           std::int32_t marker) {
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const int face = ids[q];
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
}

namespace {

// Vertices as quads count them: those of the loop, where the first new ones may be, and then the other new
// ones.
std::vector<int> as_quads_count(std::span<const int> loop, const std::vector<int> &come) {
    std::vector<int> vertices(loop.begin(), loop.end());
    auto next = come.begin();
    for (int &v : vertices)
        v = v < 0 ? *next++ : v;
    vertices.insert(vertices.end(), next, come.end());
    return vertices;
}

} // namespace

QuadMesh::Replaced QuadMesh::replace_disk(std::span<const int> faces, std::span<const int> loop,
                                          std::span<const std::array<int, 4>> quads,
                                          std::span<const OpenMesh::Vec3d> points,
                                          std::span<const int> parents) {
    if (!journal)
        return replace(faces, loop, quads, points, parents);
    const auto list = [](auto ids) { return std::vector(ids.begin(), ids.end()); };
    auto entry = std::make_shared<Replacement>(
        Replacement{list(faces), list(loop), list(parents), list(quads), list(points), {}});
    journal->reserve(journal->size() + 1);
    entry->replaced = replace(faces, loop, quads, points, parents);
    journal->push_back(std::move(entry));
    return journal->back()->replaced;
}

QuadMesh::Replaced QuadMesh::replace(std::span<const int> faces, std::span<const int> loop,
                                     std::span<const std::array<int, 4>> quads,
                                     std::span<const OpenMesh::Vec3d> points, std::span<const int> parents) {
    check_sizes();
    const int n_loop = static_cast<int>(loop.size());
    const auto on_rim = std::count_if(loop.begin(), loop.end(), [](int v) { return v < 0; });
    const int n_local = n_loop + static_cast<int>(points.size()) - static_cast<int>(on_rim);
    test_points(points);
    OldDisk disk = find_disk(kernel_, faces, loop, parents);
    if (static_cast<std::size_t>(on_rim) > points.size())
        throw Failure(Fault::internal, "a new vertex on the loop of a disk has no point");
    const std::vector<int> twins = fit_quads(*this, disk, loop, quads, n_local);
    const Rim rim(*this, disk, loop, parents);

    // Every id, and all memory.
    Ids new_faces(disk.faces, quads.size(), kernel_.n_faces());
    Ids new_vertices(disk.vertices, points.size(), kernel_.n_vertices());
    const auto at_rim = static_cast<std::size_t>(std::count(disk.sides.begin(), disk.sides.end(), -1));
    const Ids new_edges(disk.edges, (twins.size() - loop.size()) / 2 + at_rim, kernel_.n_edges());
    const std::int32_t marker = most_frequent_marker(face_marker, disk.faces);
    const std::vector<int> vertices = as_quads_count(loop, new_vertices.ids);
    const std::vector<int> sides = number_sides(quads, twins, new_edges, disk.sides);
    reserve(new_vertices.during, new_edges.during, new_faces.during);

    // A vertex on the boundary keeps its half-edge, unless that is new: it has no face, so it stays.
    std::vector<char> inside;
    for (const int v : loop)
        inside.push_back(v >= 0 && !on_boundary(v));

    // From here on nothing throws.
    resize(new_vertices.during, new_edges.during, new_faces.during);
    write_quads(quads, n_loop, new_faces.ids, vertices, sides, marker);
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
        if (!vertex_marker.empty())
            vertex_marker[at(v)] = 0;
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (inside[i])
            kernel_.set_halfedge_handle(Vertex(vertices[i]), Halfedge(disk.sides[i]));
    rim.link(*this, disk.sides, vertices);
    close_gaps(new_faces, new_edges, new_vertices);
    return {std::move(new_faces.ids),
            std::move(new_vertices.ids),
            std::move(new_faces.moves),
            std::move(new_vertices.moves),
            n_faces(),
            n_vertices()};
}

} // namespace alphamst::mesh
