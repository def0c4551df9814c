#include "patch/region.h"

#include <cmath>
#include <numbers>

#include "stop.h"

namespace alphamst::patch {
namespace {

template <class T> T at(const std::vector<T> &property, int id) {
    return property.empty() ? T{0} : property[static_cast<std::size_t>(id)];
}

constexpr std::uint8_t any_flag = mesh::fixed | mesh::feature | mesh::corner;

} // namespace

std::vector<int> sorted_unique(std::span<const int> ids) {
    std::vector<int> sorted(ids.begin(), ids.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

std::array<Halfedge, 4> halfedges_of(const mesh::QuadMesh &mesh, int face) {
    std::array<Halfedge, 4> result;
    Halfedge h = mesh.kernel().halfedge_handle(Kernel::FaceHandle(face)); // from corner 3 to corner 0
    for (Halfedge &out : result)
        out = h = mesh.kernel().next_halfedge_handle(h);
    return result;
}

bool barrier(const mesh::QuadMesh &mesh, Halfedge h) {
    const int edge = mesh.kernel().edge_handle(h).idx();
    if ((at(mesh.edge_flags, edge) & any_flag) || at(mesh.edge_marker, edge) != 0)
        return true;
    const int a = left(mesh, h), b = right(mesh, h);
    return a >= 0 && b >= 0 && at(mesh.face_marker, a) != at(mesh.face_marker, b);
}

bool held(const mesh::QuadMesh &mesh, int vertex) { return at(mesh.vertex_flags, vertex) & any_flag; }

bool constrained(const mesh::QuadMesh &mesh, int v) {
    if (mesh.on_boundary(v) || at(mesh.vertex_flags, v) != 0)
        return true;
    const Kernel &kernel = mesh.kernel();
    const Halfedge start = kernel.halfedge_handle(Kernel::VertexHandle(v));
    const std::int32_t marker = at(mesh.face_marker, left(mesh, start));
    Halfedge h = start;
    do {
        const int edge = kernel.edge_handle(h).idx(), face = left(mesh, h);
        if (at(mesh.edge_flags, edge) != 0 || at(mesh.edge_marker, edge) != 0 ||
            (at(mesh.face_flags, face) & mesh::fixed) != 0 || at(mesh.face_marker, face) != marker)
            return true;
        h = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(h));
    } while (h != start);
    return false;
}

std::optional<std::array<int, 2>> slide(const mesh::QuadMesh &mesh, int v) {
    if (mesh.isolated(v) || mesh.on_boundary(v) || (at(mesh.vertex_flags, v) & ~mesh::feature) != 0)
        return std::nullopt;
    const Kernel &kernel = mesh.kernel();
    const Halfedge start = kernel.halfedge_handle(Kernel::VertexHandle(v));
    std::array<int, 2> others{-1, -1}, edges{-1, -1};
    std::size_t n = 0;
    Halfedge h = start;
    do {
        if ((at(mesh.face_flags, left(mesh, h)) & mesh::fixed) != 0)
            return std::nullopt;
        if (barrier(mesh, h)) {
            if (n == 2)
                return std::nullopt;
            edges[n] = kernel.edge_handle(h).idx();
            others[n++] = to(mesh, h);
        }
        h = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(h));
    } while (h != start);
    if (n != 2 || (at(mesh.edge_flags, edges[0]) & ~mesh::feature) != 0 ||
        at(mesh.edge_flags, edges[0]) != at(mesh.edge_flags, edges[1]) ||
        at(mesh.edge_marker, edges[0]) != at(mesh.edge_marker, edges[1]))
        return std::nullopt;
    return others;
}

Region::Region(const mesh::QuadMesh &mesh, std::span<const int> given) : faces(sorted_unique(given)) {
    std::vector<int> corners, rim;
    corners.reserve(4 * faces.size());
    for (const int face : faces)
        for (const Halfedge h : halfedges_of(mesh, face)) {
            corners.push_back(from(mesh, h));
            const int across = right(mesh, h);
            if (!contains(faces, across)) {
                boundary.push_back(h);
            } else if (face < across) {
                inner.push_back(h);
            }
        }
    std::sort(boundary.begin(), boundary.end(), [&](Halfedge a, Halfedge b) {
        return std::pair(from(mesh, a), a.idx()) < std::pair(from(mesh, b), b.idx());
    });
    rim.reserve(boundary.size());
    for (const Halfedge h : boundary)
        rim.push_back(from(mesh, h));
    corners = sorted_unique(corners);
    std::set_difference(corners.begin(), corners.end(), rim.begin(), rim.end(), std::back_inserter(interior));
}

bool Region::pinched(const mesh::QuadMesh &mesh) const {
    return std::adjacent_find(boundary.begin(), boundary.end(), [&](Halfedge a, Halfedge b) {
               return from(mesh, a) == from(mesh, b);
           }) != boundary.end();
}

std::vector<std::vector<int>> parts(const mesh::QuadMesh &mesh, std::span<const int> faces, bool across) {
    std::vector<std::vector<int>> result;
    std::vector<char> seen(faces.size(), 0);
    const auto visit = [&](int face, std::vector<int> &part) {
        const auto it = std::lower_bound(faces.begin(), faces.end(), face);
        if (it == faces.end() || *it != face || seen[static_cast<std::size_t>(it - faces.begin())])
            return;
        seen[static_cast<std::size_t>(it - faces.begin())] = 1;
        part.push_back(face);
    };
    for (const int start : faces) {
        std::vector<int> part;
        visit(start, part);
        for (std::size_t i = 0; i < part.size(); ++i) {
            Stop::point();
            for (const Halfedge h : halfedges_of(mesh, part[i]))
                if (across || !barrier(mesh, h))
                    visit(right(mesh, h), part);
        }
        if (part.empty())
            continue;
        std::sort(part.begin(), part.end());
        result.push_back(std::move(part));
    }
    return result;
}

std::vector<int> largest_part(const mesh::QuadMesh &mesh, std::span<const int> faces, bool across) {
    const auto all = parts(mesh, faces, across);
    if (all.empty())
        return {};
    return *std::max_element(all.begin(), all.end(),
                             [](const auto &a, const auto &b) { return a.size() < b.size(); });
}

// Reflex where the corner turns against the face's normal, taken from its diagonals.
double corner_angle(const mesh::QuadMesh &mesh, Halfedge h) {
    const Kernel &kernel = mesh.kernel();
    const Halfedge next = kernel.next_halfedge_handle(h), previous = kernel.prev_halfedge_handle(h);
    const OpenMesh::Vec3d &p = mesh.point(from(mesh, h)), &q = mesh.point(to(mesh, h));
    const OpenMesh::Vec3d &r = mesh.point(to(mesh, next)), &s = mesh.point(from(mesh, previous));
    const OpenMesh::Vec3d normal = (r - p) % (s - q), turn = (q - p) % (s - p);
    const double angle = std::atan2(turn.norm(), (q - p) | (s - p));
    return (turn | normal) < 0 ? 2 * std::numbers::pi - angle : angle;
}

OpenMesh::Vec3d centroid(const mesh::QuadMesh &mesh, int face) {
    OpenMesh::Vec3d sum(0, 0, 0);
    for (const Halfedge h : halfedges_of(mesh, face))
        sum += mesh.point(from(mesh, h));
    return sum / 4.0;
}

} // namespace alphamst::patch
