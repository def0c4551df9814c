#include "reference/reference.h"

#include <algorithm>
#include <numeric>

#include "index.h"
#include "reference/feature_line.h"
#include "reference/locate.h"
#include "reference/statistics.h"
#include "reference/surface_of.h"

namespace alphamst::reference {
namespace {

// The surface was made of the mesh as it is: its points are the vertices.
bool same_points(const mesh::QuadMesh &mesh, const surface::Surface &surface) {
    if (surface.points().size() != at(mesh.n_vertices()))
        return false;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (surface.points()[at(v)] != point_of(mesh, v))
            return false;
    return true;
}

} // namespace

std::vector<double> Reference::scaled_jacobians(const mesh::QuadMesh &mesh) const {
    if (!plane) {
        geometry::SurfacePositions all = on_surface(mesh);
        std::vector<int> vertices(at(mesh.n_vertices()));
        std::iota(vertices.begin(), vertices.end(), 0);
        forget_normals(mesh, vertices, mesh.faces(), all);
        return geometry::scaled_jacobians(mesh.faces(), all);
    }
    const geometry::Points positions = flatten(mesh, *plane);
    std::vector<double> quality;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const auto quad = mesh.faces().subspan(f, 1);
        quality.push_back(geometry::shapes_of(quad, positions).min_scaled_jacobian);
    }
    return quality;
}

geometry::SurfacePositions Reference::on_surface(const mesh::QuadMesh &mesh) const {
    std::vector<int> all(at(mesh.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    return positions_on_surface(mesh, *surface, surface_triangles, all);
}

std::vector<double> Reference::areas(geometry::Quads quads,
                                     const geometry::SurfacePositions &on_surface) const {
    std::vector<double> wanted;
    if (density.empty())
        return wanted;
    double sum = 0, area = 0;
    for (const auto &q : quads) {
        double faces = 0;
        geometry::Quad corners;
        for (std::size_t k = 0; k < 4; ++k) {
            faces += density[at(on_surface.surface_triangles[at(q[k])])] / 4;
            corners[k] = on_surface.points[at(q[k])];
        }
        wanted.push_back(1 / faces);
        sum += 1 / faces;
        area += geometry::area_vector(corners).norm();
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int f : faces)
        normal += geometry::area_vector(quad_of(mesh, f));
    if (mesh.dim() == 2)
        return geometry::Plane::of_coordinates(normal.z() < 0);
    std::vector<Eigen::Vector3d> points;
    for (const int f : faces)
        for (const int v : mesh.corners(f))
            points.push_back(point_of(mesh, v));
    const geometry::Plane plane = geometry::Plane::fit(points, normal);
    if (!plane.holds(points))
        return std::nullopt;
    return plane;
}

std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh) {
    std::vector<int> faces(at(mesh.n_faces()));
    std::iota(faces.begin(), faces.end(), 0);
    return plane_of(mesh, faces);
}

Reference reference_of(mesh::QuadMesh &mesh) {
    Reference reference;
    if (!mesh.surface || mesh.dim() == 2)
        reference.plane = plane_of(mesh);
    if (reference.plane)
        return reference;
    if (!mesh.surface)
        mesh.surface = reference::surface_of(mesh);
    mesh.curves = reference::curves_of(mesh);
    reference.surface = mesh.surface;
    reference.surface_triangles = triangles_under(mesh, *reference.surface);
    return reference;
}

std::vector<int> triangles_under(const mesh::QuadMesh &mesh, const surface::Surface &surface) {
    std::vector<int> triangles;
    const bool same = same_points(mesh, surface);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (same && !surface.triangles_around(v).empty())
            triangles.push_back(surface.triangles_around(v).front());
        else
            triangles.push_back(mesh.isolated(v) ? 0 : spot_of(mesh, surface, v).triangle);
    }
    return triangles;
}

Reference reference_of(const mesh::QuadMesh &mesh, std::span<const Patch> patches) {
    Reference reference;
    reference.surface = mesh.surface;
    if (!reference.surface && mesh.dim() == 3 &&
        std::any_of(patches.begin(), patches.end(),
                    [&](const Patch &patch) { return !patch.faces.empty() && !plane_of(mesh, patch.faces); }))
        reference.surface = reference::surface_of(mesh);
    return reference;
}

geometry::SurfacePositions positions_on_surface(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                                                const std::vector<int> &surface_triangles,
                                                std::span<const int> vertices) {
    geometry::SurfacePositions on_surface;
    for (const int v : vertices) {
        const Eigen::Vector3d point = point_of(mesh, v);
        surface::Spot spot = surface_triangles.empty() ? spot_of(mesh, surface, v)
                                                       : surface.follow(point, surface_triangles[at(v)]);
        spot.point = point; // bit for bit, wherever the surface is
        on_surface.add(spot);
    }
    return on_surface;
}

surface::Spot spot_of(const mesh::QuadMesh &mesh, const surface::Surface &surface, int vertex) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int f : mesh.faces_around(vertex))
        normal += geometry::area_vector(quad_of(mesh, f));
    return surface.nearest(point_of(mesh, vertex), normal);
}

} // namespace alphamst::reference
