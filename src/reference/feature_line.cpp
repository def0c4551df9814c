#include "reference/feature_line.h"

#include <utility>

#include "index.h"
#include "mesh/feature.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

constexpr double rounding = 1e-9; // of the way between two neighbours: off a line

} // namespace

double bend_tolerance(const Settings &settings) {
    constexpr double part = 0.2; // with all of it rms errors are the same, and curves are missed twice as far
    return settings.edit_boundary ? part * settings.tolerance : 0;
}

geometry::FeatureLine feature_line_of(const mesh::QuadMesh &mesh, int vertex, double tolerance) {
    if (!mesh.curves)
        return {};
    const auto others = patch::slide(mesh, vertex);
    if (!others)
        return {};
    const std::array points{point_of(mesh, vertex), point_of(mesh, (*others)[0]),
                            point_of(mesh, (*others)[1])};
    geometry::FeatureLine local{{}, {1, 2}, tolerance};
    if (const int found = mesh.curves->find(points); found >= 0)
        local.lines.push_back(mesh.curves->lines()[at(found)]);
    else if (tolerance > 0)
        local.lines = mesh.curves->way_through(points[1], points[0], points[2]);
    if (local.lines.empty() || !local.holds(points[0], points))
        return {};
    local.between = *others;
    return local;
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

std::vector<geometry::FeatureLine> feature_lines_of(const mesh::QuadMesh &mesh, double tolerance) {
    std::vector<geometry::FeatureLine> feature_lines;
    for (int v = 0; mesh.curves && v < mesh.n_vertices(); ++v)
        if (geometry::FeatureLine feature_line = feature_line_of(mesh, v, tolerance)) {
            feature_lines.resize(at(mesh.n_vertices()));
            feature_lines[at(v)] = std::move(feature_line);
        }
    return feature_lines;
}

namespace {

bool on_curves(const mesh::QuadMesh &mesh, int vertex) {
    return mesh.curves->find(std::array{point_of(mesh, vertex)}) >= 0;
}

// Along the feature from a vertex off its curve, the first that is on it; -1 if there is none.
int first_on_curve(const mesh::QuadMesh &mesh, int vertex, int next) {
    const int start = vertex;
    while (next != start && !on_curves(mesh, next)) {
        const auto others = patch::slide(mesh, next);
        if (!others)
            return -1;
        const int before = std::exchange(vertex, next);
        next = (*others)[(*others)[0] == before ? 1 : 0];
    }
    return next == start ? -1 : next;
}

} // namespace

void keep_to_curves(mesh::QuadMesh &mesh) {
    std::vector<std::pair<int, Eigen::Vector3d>> moved;
    for (int v = 0; mesh.curves && v < mesh.n_vertices(); ++v) {
        const auto others = patch::slide(mesh, v);
        if (!others || on_curves(mesh, v))
            continue;
        const int from = first_on_curve(mesh, v, (*others)[0]), to = first_on_curve(mesh, v, (*others)[1]);
        if (from < 0 || to < 0 || from == to)
            continue;
        const geometry::FeatureLine line{mesh.curves->way(point_of(mesh, from), point_of(mesh, to)), {}, 0};
        if (!line.lines.empty())
            moved.emplace_back(v, line.at(line.place(point_of(mesh, v))));
    }
    for (const auto &[v, p] : moved)
        mesh.set_point(v, {p.x(), p.y(), p.z()});
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
