#include "reference/statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "patch/region.h"

namespace alphamst::reference {
namespace {

Eigen::Vector3d vector(const OpenMesh::Vec3d &p) { return {p[0], p[1], p[2]}; }

} // namespace

void count(const mesh::QuadMesh &mesh, std::map<int, std::int64_t> &valences, std::int64_t &singular) {
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (mesh.isolated(v) || mesh.on_boundary(v))
            continue;
        const int valence = mesh.valence(v);
        ++valences[valence];
        singular += valence != 4;
    }
}

geometry::Points flatten(const mesh::QuadMesh &mesh, const geometry::Plane &plane) {
    geometry::Points positions;
    positions.reserve(static_cast<std::size_t>(mesh.n_vertices()));
    for (int v = 0; v < mesh.n_vertices(); ++v)
        positions.push_back(plane.to_plane(vector(mesh.point(v))));
    return positions;
}

int mismatch(const mesh::QuadMesh &mesh, int vertex) {
    double angle = 0;
    int faces = 0;
    const auto &kernel = mesh.kernel();
    const auto start = kernel.halfedge_handle(OpenMesh::VertexHandle(vertex));
    auto h = start;
    do {
        if (patch::left(mesh, h) >= 0) {
            angle += patch::corner_angle(mesh, h);
            ++faces;
        }
        h = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(h));
    } while (h != start);
    return std::max(1, static_cast<int>(std::lround(2 * angle / std::numbers::pi))) - faces;
}

} // namespace alphamst::reference
