#include "reference/projection.h"

#include <cmath>
#include <string>

#include "index.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;

// Points of a curve between two vertices: an arc is missed by 1/256 of what its chord misses it by.
constexpr int points_per_edge = 16;

std::int32_t marker_of(const mesh::QuadMesh &mesh, int edge) {
    return mesh.edge_marker.empty() ? 0 : mesh.edge_marker[at(edge)];
}

// The projection of points near an edge, or near a vertex at it.
std::vector<Vector3d> projected(const Project &project, const std::vector<std::int32_t> &markers,
                                const std::vector<Vector3d> &points, const std::vector<double> &most) {
    const std::vector<Vector3d> result = project(markers, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double away = (result[i] - points[i]).norm();
        if (!(away <= most[i]))
            throw Failure(Fault::projection, "the projection takes a point of the boundary with marker " +
                                                 std::to_string(markers[i]) + " by " + std::to_string(away) +
                                                 ", farther than AMST_OPT_TOLERANCE, which is " +
                                                 std::to_string(most[i]) + " there");
    }
    return result;
}

} // namespace

void keep_boundary(mesh::QuadMesh &mesh, const Project &project, double tolerance) {
    if (!project) {
        if (!mesh.boundary || !is_on(mesh, *mesh.boundary))
            mesh.boundary = curves_of_boundary(mesh);
        return;
    }
    const std::vector<std::vector<int>> all = boundary_cycles(mesh);
    std::vector<std::int32_t> markers;
    std::vector<Vector3d> points;
    std::vector<double> most;
    for (const std::vector<int> &cycle : all)
        for (std::size_t i = 0; i < cycle.size(); ++i) {
            const int v = cycle[i], w = cycle[(i + 1) % cycle.size()];
            const Vector3d start = point_of(mesh, v), way = point_of(mesh, w) - start;
            for (int k = 1; k < points_per_edge; ++k) {
                markers.push_back(marker_of(mesh, mesh.find_edge(v, w)));
                points.push_back(start + static_cast<double>(k) / points_per_edge * way);
                most.push_back(tolerance * way.norm());
            }
        }
    const std::vector<Vector3d> finer = projected(project, markers, points, most);
    std::vector<std::vector<Vector3d>> curves;
    auto next = finer.begin();
    for (const std::vector<int> &cycle : all) {
        curves.emplace_back();
        for (const int v : cycle) {
            curves.back().push_back(point_of(mesh, v));
            curves.back().insert(curves.back().end(), next, next + points_per_edge - 1);
            next += points_per_edge - 1;
        }
    }
    mesh.boundary = std::make_shared<const surface::BoundaryCurves>(std::move(curves));
}

void project_new_vertices(mesh::QuadMesh &mesh, const Project &project, double tolerance) {
    std::vector<int> vertices;
    std::vector<std::int32_t> markers;
    std::vector<Vector3d> points;
    std::vector<double> most;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (mesh.vertex_origin[at(v)] >= 0 || mesh.isolated(v) || !mesh.on_boundary(v))
            continue;
        const int next = mesh.vertices_around(v).front();
        vertices.push_back(v);
        markers.push_back(marker_of(mesh, mesh.find_edge(v, next)));
        points.push_back(point_of(mesh, v));
        most.push_back(tolerance * (point_of(mesh, next) - points.back()).norm());
    }
    if (vertices.empty())
        return;
    const std::vector<Vector3d> there = projected(project, markers, points, most);
    const auto inverted = [&](int v) {
        const std::vector<int> faces = mesh.faces_around(v);
        return std::ranges::count_if(faces, [&](int f) {
            return quality::measure(quality::Metric::scaled_jacobian, quad_of(mesh, f), 0) <= 0;
        });
    };
    std::vector<std::int64_t> before;
    for (const int v : vertices)
        before.push_back(inverted(v));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        mesh.set_point(vertices[i], {there[i].x(), there[i].y(), mesh.dim() == 2 ? 0.0 : there[i].z()});
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (inverted(vertices[i]) > before[i])
            throw Failure(Fault::projection,
                          "the projection turns a face over at the new vertex at " +
                              std::to_string(points[i].x()) + ", " + std::to_string(points[i].y()) +
                              " on the boundary with marker " + std::to_string(markers[i]) +
                              "; it must take points near the boundary to points near them");
}

} // namespace alphamst::reference
