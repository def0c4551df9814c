#include "reference/surface_of.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "mesh/feature.h"
#include "surface/triangle.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;
using Quad = std::array<Vector3d, 4>;

// Of the two triangles beside the diagonal from corner i, 0 or 1: the cosine of the angle between
// their normals, 0 if one has no area.
double agreement(const Quad &quad, std::size_t i) {
    const Vector3d &from = quad[i], &to = quad[i + 2];
    return surface::unit_normal(from, quad[i + 1], to).dot(surface::unit_normal(from, to, quad[(i + 3) % 4]));
}

// The corner, 0 or 1, where the diagonal begins that cuts the quad.
std::size_t cut(const Quad &quad) {
    const std::size_t shorter = (quad[3] - quad[1]).squaredNorm() < (quad[2] - quad[0]).squaredNorm();
    const double agreed = agreement(quad, shorter);
    return agreed <= 0 && agreement(quad, 1 - shorter) > agreed ? 1 - shorter : shorter;
}

Vector3d point_of(const mesh::QuadMesh &mesh, int vertex) {
    const OpenMesh::Vec3d &p = mesh.point(vertex);
    return {p[0], p[1], p[2]};
}

std::vector<Vector3d> points_of(const mesh::QuadMesh &mesh) {
    std::vector<Vector3d> points;
    points.reserve(static_cast<std::size_t>(mesh.n_vertices()));
    for (int v = 0; v < mesh.n_vertices(); ++v)
        points.push_back(point_of(mesh, v));
    return points;
}

// Of coordinates, for what is on one line but for rounding: a part of the diagonal of the box around all.
double rounding_of(const std::vector<Vector3d> &points) {
    constexpr double part = 1e-12;
    Vector3d low = points.front(), high = low;
    for (const Vector3d &p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    return part * (high - low).stableNorm();
}

} // namespace

std::shared_ptr<const surface::Surface> surface_of(const mesh::QuadMesh &mesh) {
    std::vector<Vector3d> points = points_of(mesh);
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(2 * mesh.faces().size());
    for (const std::array<int, 4> &face : mesh.faces()) {
        Quad quad;
        for (std::size_t i = 0; i < 4; ++i)
            quad[i] = points[static_cast<std::size_t>(face[i])];
        const std::size_t i = cut(quad);
        triangles.push_back({face[i], face[i + 1], face[i + 2]});
        triangles.push_back({face[i], face[i + 2], face[(i + 3) % 4]});
    }
    return std::make_shared<const surface::Surface>(std::move(points), std::move(triangles));
}

std::shared_ptr<const surface::Curves> curves_of(const mesh::QuadMesh &mesh) {
    std::vector<std::array<int, 2>> fresh; // edges that are on no line yet
    std::vector<int> used;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [left, right] = mesh.edge_faces(e);
        if (left < 0 || right < 0 || !on_curve(mesh, e))
            continue;
        const std::array<int, 2> edge = mesh.edge_vertices(e);
        const std::array ends{point_of(mesh, edge[0]), point_of(mesh, edge[1])};
        const std::vector<int> lines =
            mesh.curves ? mesh.curves->lines_between(ends[0], ends[1]) : std::vector<int>();
        used.insert(used.end(), lines.begin(), lines.end());
        if (lines.empty())
            fresh.push_back(edge);
    }
    if (fresh.empty())
        return mesh.curves;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<surface::Line> lines;
    for (const int line : used)
        lines.push_back(mesh.curves->lines()[static_cast<std::size_t>(line)]);
    const std::vector<Vector3d> points = points_of(mesh);
    return std::make_shared<const surface::Curves>(points, fresh, rounding_of(points), std::move(lines));
}

} // namespace alphamst::reference
