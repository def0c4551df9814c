#include "reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

#include "adapt/meshes.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/surface_of.h"

namespace alphamst::reference {
namespace {

using adapt::samples::all_faces;
using Eigen::Vector3d;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The roof of a house: the left half rises, the right half falls.
mesh::QuadMesh roof() {
    return mesh::grid(8, 4,
                      [](double s, double t) { return Vector3d(8 * s, 4 * t, 2 - std::abs(8 * s - 4) / 2); });
}

// Two squares of side 1, one 0.01 above the other, that look up and down; the first half of the vertices is
// the lower one.
mesh::QuadMesh wall(int n) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (const bool above : {false, true}) {
        const mesh::QuadMesh side = mesh::grid(
            n, n, [&](double s, double t) { return above ? Vector3d(s, t, 0.01) : Vector3d(t, s, 0); });
        for (int v = 0; v < side.n_vertices(); ++v)
            points.insert(points.end(), side.point(v).begin(), side.point(v).end());
        for (const auto &quad : side.faces())
            for (const int v : quad)
                faces.push_back(v + (above ? side.n_vertices() : 0));
    }
    return mesh::QuadMesh::build(3, points, faces);
}

TEST(Reference, ThePlaneOfPlanarFacesLooksTheirWay) {
    const mesh::QuadMesh mesh = roof();
    for (const bool right : {false, true}) {
        const int i = right ? 4 : 0;
        const auto plane = plane_of(mesh, adapt::samples::block(8, i, 0, i + 4, 4));
        ASSERT_TRUE(plane);
        EXPECT_LT((plane->normal() - Vector3d(right ? 0.5 : -0.5, 0, 1).normalized()).norm(), 1e-12);
        EXPECT_NEAR(plane->height(point_of(mesh, right ? 44 : 0)), 0, 1e-12);
    }
    EXPECT_FALSE(plane_of(mesh, all_faces(mesh)));
    EXPECT_FALSE(plane_of(mesh, adapt::samples::block(8, 3, 1, 5, 2)));
    EXPECT_FALSE(plane_of(mesh::sphere(6), std::vector{0, 1, 2}));
}

TEST(Reference, TwoCoordinatesAreAlwaysAPlane) {
    const auto place = [](double s, double t) { return Vector3d(3 * s, 2 * t, 0); };
    const auto clockwise = [&](double s, double t) { return place(t, s); };
    const mesh::QuadMesh above = mesh::grid(3, 2, place, false, false, 2);
    const mesh::QuadMesh below = mesh::grid(2, 3, clockwise, false, false, 2);
    for (const mesh::QuadMesh *mesh : {&above, &below}) {
        const auto plane = plane_of(*mesh, all_faces(*mesh));
        ASSERT_TRUE(plane);
        EXPECT_EQ(plane->normal(), Vector3d(0, 0, mesh == &above ? 1 : -1));
        geometry::Points points;
        for (int v = 0; v < mesh->n_vertices(); ++v)
            points.push_back(plane->to_plane(point_of(*mesh, v)));
        EXPECT_EQ(points[0], Eigen::Vector2d(0, 0));
        EXPECT_TRUE(geometry::shapes_of(mesh->faces(), points).valid);
    }
}

TEST(Reference, OfAFlatMeshIsAPlaneAndOfACurvedOneItself) {
    for (const int dim : {2, 3}) {
        mesh::QuadMesh flat = adapt::samples::grid(4, 3, dim);
        const Reference reference = reference_of(flat);
        EXPECT_TRUE(reference.plane);
        EXPECT_FALSE(reference.surface);
        EXPECT_FALSE(flat.surface);
    }
    mesh::QuadMesh curved = mesh::sphere(6);
    const Reference reference = reference_of(curved);
    EXPECT_FALSE(reference.plane);
    ASSERT_TRUE(curved.surface);
    EXPECT_EQ(reference.surface, curved.surface);
    ASSERT_EQ(reference.surface_triangles.size(), at(curved.n_vertices()));
    for (int v = 0; v < curved.n_vertices(); ++v) {
        const auto &triangle = curved.surface->triangles()[at(reference.surface_triangles[at(v)])];
        EXPECT_NE(std::find(triangle.begin(), triangle.end(), v), triangle.end());
    }
    // A flat mesh that has a surface keeps to it, unless it has no third coordinate.
    mesh::QuadMesh flat = adapt::samples::grid(4, 3, 3);
    flat.surface = reference::surface_of(flat);
    EXPECT_FALSE(reference_of(flat).plane);
    EXPECT_EQ(reference_of(flat).surface, flat.surface);
    mesh::QuadMesh two = adapt::samples::grid(4, 3, 2);
    two.surface = flat.surface;
    EXPECT_TRUE(reference_of(two).plane);
}

TEST(Reference, AnchorsOfVerticesThatHaveMovedAreUnderThem) {
    mesh::QuadMesh mesh = wall(6);
    mesh.surface = reference::surface_of(mesh);
    for (int v = 0; v < mesh.n_vertices(); ++v) // through the wall
        mesh.set_point(v,
                       mesh.point(v) + OpenMesh::Vec3d(0.03, 0.01, 2 * v < mesh.n_vertices() ? 0.02 : -0.02));
    const Reference reference = reference_of(mesh);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const bool lower = 2 * v < mesh.n_vertices();
        EXPECT_EQ(mesh.surface->normal(reference.surface_triangles[at(v)]).z(), lower ? -1 : 1);
        const auto spot = mesh.surface->follow(point_of(mesh, v), reference.surface_triangles[at(v)]);
        EXPECT_EQ(spot.triangle, reference.surface_triangles[at(v)]);
    }
}

TEST(Reference, VerticesWithoutAFaceAreHarmless) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const mesh::QuadMesh sphere = mesh::sphere(4);
    for (int v = 0; v < sphere.n_vertices(); ++v)
        points.insert(points.end(), sphere.point(v).begin(), sphere.point(v).end());
    points.insert(points.end(), {9, 9, 9});
    for (const auto &quad : sphere.faces())
        faces.insert(faces.end(), quad.begin(), quad.end());
    mesh::QuadMesh mesh = mesh::QuadMesh::build(3, points, faces);
    const Reference reference = reference_of(mesh);
    EXPECT_EQ(reference.surface_triangles.back(), 0);
    EXPECT_GT(reference.scaled_jacobians(mesh).front(), 0.7);
}

TEST(Reference, OfPatchesIsASurfaceIfOneIsCurvedOrTheMeshHasOne) {
    mesh::QuadMesh mesh = roof();
    const auto regions = [](const std::vector<std::vector<int>> &sets) {
        std::vector<Patch> all(sets.size());
        for (std::size_t i = 0; i < sets.size(); ++i)
            all[i].faces = sets[i];
        return all;
    };
    const std::vector<int> left = adapt::samples::block(8, 0, 0, 4, 4),
                           ridge = adapt::samples::block(8, 3, 0, 5, 2);
    EXPECT_FALSE(reference_of(mesh, regions({left})).surface);
    EXPECT_FALSE(reference_of(mesh, regions({left, {}})).surface);
    EXPECT_TRUE(reference_of(mesh, regions({left, ridge})).surface);
    EXPECT_FALSE(mesh.surface); // that is for the operation to say
    mesh.surface = reference::surface_of(mesh);
    EXPECT_EQ(reference_of(mesh, regions({left})).surface, mesh.surface);
}

TEST(Reference, ADrapeKeepsPointsToTheLastBit) {
    mesh::QuadMesh mesh = mesh::sphere(8);
    const auto surface = reference::surface_of(mesh);
    for (int v = 0; v < mesh.n_vertices(); ++v) // off the surface
        mesh.set_point(v, mesh.point(v) * (1 + 0.01 * (v % 7) / 3));
    std::vector<int> vertices{200, 3, 77, 5}, surface_triangles;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        surface_triangles.push_back(surface->triangles_around(v).back());
    for (const std::vector<int> &known : {std::vector<int>(), surface_triangles}) {
        const geometry::SurfacePositions on_surface = positions_on_surface(mesh, *surface, known, vertices);
        ASSERT_EQ(on_surface.points.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            const OpenMesh::Vec3d &p = mesh.point(vertices[i]);
            EXPECT_EQ(std::memcmp(on_surface.points[i].data(), p.data(), 3 * sizeof(double)), 0);
            EXPECT_GT(on_surface.normals[i].dot(on_surface.points[i].normalized()), 0.999);
            EXPECT_NEAR(on_surface.normals[i].norm(), 1, 1e-14);
            const auto spot = surface->nearest(on_surface.points[i]);
            const auto own = surface->follow(on_surface.points[i], on_surface.surface_triangles[i]);
            EXPECT_NEAR(own.distance, spot.distance, 1e-12);
        }
    }
}

TEST(Reference, ASpotIsOnTheSideOfTheWallThatTheFacesLookTo) {
    const mesh::QuadMesh plain = wall(5);
    const auto surface = reference::surface_of(plain);
    const int n = plain.n_vertices() / 2;
    for (const double off : {-0.05, 0.001, 0.009, 0.05}) {
        mesh::QuadMesh mesh = plain; // both sides at one height
        for (int v = 0; v < mesh.n_vertices(); ++v)
            mesh.set_point(v, {mesh.point(v)[0], mesh.point(v)[1], off});
        for (const int v : {0, 14, n - 1, n, n + 14, 2 * n - 1}) {
            const surface::Spot spot = spot_of(mesh, *surface, v);
            EXPECT_EQ(spot.point.z(), v < n ? 0 : 0.01) << off;
            EXPECT_EQ(spot.normal, Vector3d(0, 0, v < n ? -1 : 1)) << off;
        }
    }
}

TEST(Reference, ScaledJacobiansAreThoseOfThePlaneOrTheSurface) {
    mesh::QuadMesh flat = adapt::samples::grid(3, 2, 2);
    flat.set_point(5, {1.4, 1.2, 0});
    const Reference plane = reference_of(flat);
    const std::vector<double> in_plane = plane.scaled_jacobians(flat);
    flat.surface = nullptr;
    mesh::QuadMesh lifted = adapt::samples::grid(3, 2, 3);
    lifted.surface = reference::surface_of(lifted);
    lifted.set_point(5, {1.4, 1.2, 0});
    const std::vector<double> on_surface = reference_of(lifted).scaled_jacobians(lifted);
    ASSERT_EQ(in_plane.size(), 6u);
    ASSERT_EQ(on_surface.size(), 6u);
    for (std::size_t f = 0; f < 6; ++f)
        EXPECT_NEAR(on_surface[f], in_plane[f], 1e-12);
    EXPECT_LT(in_plane[0], 0.99);
    EXPECT_NEAR(in_plane[2], 1, 1e-15);
}

} // namespace
} // namespace alphamst::reference
