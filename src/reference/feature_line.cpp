#include "reference/feature_line.h"

#include "mesh/feature.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

constexpr double rounding = 1e-9; // of the way between two neighbours: off a line

} // namespace

geometry::FeatureLine feature_line_of(const mesh::QuadMesh &mesh, int vertex) {
    if (!mesh.curves)
        return {};
    const auto others = patch::slide(mesh, vertex);
    if (!others)
        return {};
    const std::array points{point_of(mesh, vertex), point_of(mesh, (*others)[0]),
                            point_of(mesh, (*others)[1])};
    const int found = mesh.curves->find(points);
    if (found < 0)
        return {};
    const surface::Line &line = mesh.curves->lines()[static_cast<std::size_t>(found)];
    const geometry::FeatureLine local{line, {1, 2}};
    return local.holds(points[0], points) ? geometry::FeatureLine{line, *others} : geometry::FeatureLine{};
}

void straighten(mesh::QuadMesh &mesh) {
    for (int v = 0; mesh.dim() == 3 && v < mesh.n_vertices(); ++v) {
        const auto others = patch::slide(mesh, v);
        if (!others)
            continue;
        const surface::Line line{point_of(mesh, (*others)[0]), point_of(mesh, (*others)[1])};
        const Eigen::Vector3d p = point_of(mesh, v);
        const double place = line.place(p), length = (line.end - line.start).norm();
        if (length == 0 || (place > 0 && place < 1) || (line.at(place) - p).norm() > rounding * length)
            continue;
        const Eigen::Vector3d middle = line.at(0.5);
        mesh.set_point(v, {middle.x(), middle.y(), middle.z()});
    }
}

std::vector<geometry::FeatureLine> feature_lines_of(const mesh::QuadMesh &mesh) {
    std::vector<geometry::FeatureLine> feature_lines;
    for (int v = 0; mesh.curves && v < mesh.n_vertices(); ++v)
        if (const geometry::FeatureLine feature_line = feature_line_of(mesh, v)) {
            feature_lines.resize(static_cast<std::size_t>(mesh.n_vertices()));
            feature_lines[static_cast<std::size_t>(v)] = feature_line;
        }
    return feature_lines;
}

void forget_normals(const mesh::QuadMesh &mesh, std::span<const int> vertices, geometry::Quads quads,
                    geometry::SurfacePositions &on_surface) {
    if (!mesh.curves)
        return;
    for (const auto &quad : quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const auto v = static_cast<std::size_t>(quad[k]), w = static_cast<std::size_t>(quad[(k + 1) % 4]);
            const int edge = mesh.find_edge(vertices[v], vertices[w]);
            const auto [left, right] = mesh.edge_faces(edge);
            if (left >= 0 && right >= 0 && mesh::on_curve(mesh, edge))
                on_surface.normals[v] = on_surface.normals[w] = Eigen::Vector3d::Zero();
        }
}

} // namespace alphamst::reference
