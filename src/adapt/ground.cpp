#include "adapt/ground.h"

#include <algorithm>
#include <numeric>

#include "adapt/locate.h"
#include "adapt/rails.h"
#include "adapt/tally.h"
#include "mesh/reference.h"

namespace alphamst::adapt {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

std::vector<double> Ground::scaled_jacobians(const mesh::QuadMesh &mesh) const {
    if (!plane) {
        geometry::Drape all = drape(mesh);
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

geometry::Drape Ground::drape(const mesh::QuadMesh &mesh) const {
    std::vector<int> all(at(mesh.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    return drape_of(mesh, *surface, anchors, all);
}

std::vector<double> Ground::areas(geometry::Quads quads, const geometry::Drape &drape) const {
    std::vector<double> wanted;
    if (density.empty())
        return wanted;
    double sum = 0, area = 0;
    for (const auto &q : quads) {
        double faces = 0;
        Quad corners;
        for (std::size_t k = 0; k < 4; ++k) {
            faces += density[at(drape.anchors[at(q[k])])] / 4;
            corners[k] = drape.points[at(q[k])];
        }
        wanted.push_back(1 / faces);
        sum += 1 / faces;
        area += area_vector(corners).norm();
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int f : faces)
        normal += area_vector(quad_of(mesh, f));
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

Ground ground_of(mesh::QuadMesh &mesh) {
    std::vector<int> faces(at(mesh.n_faces()));
    std::iota(faces.begin(), faces.end(), 0);
    Ground ground;
    if (!mesh.surface || mesh.dim() == 2)
        ground.plane = plane_of(mesh, faces);
    if (ground.plane)
        return ground;
    if (!mesh.surface)
        mesh.surface = mesh::surface_of(mesh);
    mesh.curves = mesh::curves_of(mesh);
    ground.surface = mesh.surface;
    const bool same = same_points(mesh, *ground.surface);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (same && !ground.surface->triangles_around(v).empty())
            ground.anchors.push_back(ground.surface->triangles_around(v).front());
        else
            ground.anchors.push_back(mesh.isolated(v) ? 0 : spot_of(mesh, *ground.surface, v).triangle);
    }
    return ground;
}

Ground ground_of(const mesh::QuadMesh &mesh, std::span<const Region> patches) {
    Ground ground;
    ground.surface = mesh.surface;
    if (!ground.surface && mesh.dim() == 3 &&
        std::any_of(patches.begin(), patches.end(), [&](const Region &patch) {
            return !patch.faces.empty() && !plane_of(mesh, patch.faces);
        }))
        ground.surface = mesh::surface_of(mesh);
    return ground;
}

geometry::Drape drape_of(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                         const std::vector<int> &anchors, std::span<const int> vertices) {
    geometry::Drape drape;
    for (const int v : vertices) {
        const Eigen::Vector3d point = point_of(mesh, v);
        surface::Spot spot =
            anchors.empty() ? spot_of(mesh, surface, v) : surface.follow(point, anchors[at(v)]);
        spot.point = point; // bit for bit, wherever the surface is
        drape.add(spot);
    }
    return drape;
}

surface::Spot spot_of(const mesh::QuadMesh &mesh, const surface::Surface &surface, int vertex) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int f : mesh.faces_around(vertex))
        normal += area_vector(quad_of(mesh, f));
    return surface.nearest(point_of(mesh, vertex), normal);
}

} // namespace alphamst::adapt
