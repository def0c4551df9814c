#include "mesh/reference.h"

#include <array>
#include <utility>
#include <vector>

#include "surface/triangle.h"

namespace alphamst::mesh {
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

} // namespace

std::shared_ptr<const surface::Surface> surface_of(const QuadMesh &mesh) {
    std::vector<Vector3d> points;
    points.reserve(static_cast<std::size_t>(mesh.n_vertices()));
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const OpenMesh::Vec3d &p = mesh.point(v);
        points.emplace_back(p[0], p[1], p[2]);
    }
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

} // namespace alphamst::mesh
