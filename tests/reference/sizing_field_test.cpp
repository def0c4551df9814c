#include "reference/sizing_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "adapt/meshes.h"
#include "mesh/curved.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vector3d centre(const mesh::QuadMesh &mesh, int face) {
    Vector3d sum = Vector3d::Zero();
    for (const int v : mesh.corners(face))
        sum += point_of(mesh, v) / 4;
    return sum;
}

template <class Size> void set_size(mesh::QuadMesh &mesh, const Size &size) {
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        field.values.push_back(size(point_of(mesh, v)));
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
}

// Two spheres of as many faces.
mesh::QuadMesh two_spheres(int n, double radius, double other_radius) {
    const mesh::QuadMesh sphere = mesh::sphere(n);
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (const bool second : {false, true}) {
        for (int v = 0; v < sphere.n_vertices(); ++v) {
            const Vector3d p = point_of(sphere, v) * (second ? other_radius : radius);
            points.insert(points.end(), {p.x() + (second ? 100 : 0), p.y(), p.z()});
        }
        for (const auto &quad : sphere.faces())
            for (const int v : quad)
                faces.push_back(v + (second ? sphere.n_vertices() : 0));
    }
    return mesh::QuadMesh::build(3, points, faces);
}

// Two squares of side 2 that a quarter of a tube joins.
mesh::QuadMesh bent(double radius) {
    const double arc = radius * std::numbers::pi / 2;
    return mesh::grid(120, 10, [&](double s, double t) {
        const double way = (4 + arc) * s - 2, angle = std::clamp(way / radius, 0.0, std::numbers::pi / 2);
        const double before = std::min(way, 0.0), after = std::max(way - arc, 0.0);
        return Vector3d(before + radius * std::sin(angle), 2 * t, radius * (1 - std::cos(angle)) + after);
    });
}

TEST(SizingField, OfASphereIsEven) {
    mesh::QuadMesh sphere = mesh::sphere(16);
    Reference reference = reference_of(sphere);
    const auto density = SizingField::of(sphere, reference, sphere.n_faces());
    ASSERT_TRUE(density);
    EXPECT_FALSE(density->wished());
    ASSERT_EQ(reference.density.size(), reference.surface->triangles().size());
    std::vector<double> all;
    for (int f = 0; f < sphere.n_faces(); ++f)
        all.push_back(density->of_face(sphere, f));
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    EXPECT_GT(*least, 0);
    EXPECT_LT(*most, 1.2 * *least);
}

TEST(SizingField, OfACurvedSurfaceIsMoreWhereItBends) {
    mesh::QuadMesh mesh = bent(0.2);
    Reference reference = reference_of(mesh);
    const auto density = SizingField::of(mesh, reference, mesh.n_faces());
    ASSERT_TRUE(density);
    const auto at_column = [&](int i) { return density->of_face(mesh, 5 * 120 + i); };
    const double sharp = at_column(60), flat = at_column(5);
    EXPECT_GT(sharp, 10 * flat);
    EXPECT_LT(sharp, std::pow(81, 2.0 / 3) * 1.0001 * flat); // at most 8.1 times the mean over 0.1 times
    for (int i = 1; i < 55; ++i)
        EXPECT_GE(at_column(i) * 1.0001, at_column(i - 1)) << i;
    EXPECT_NEAR(at_column(114) / flat, 1, 1e-6);
}

// A tenth of the mean curvature added, to the power of two thirds.
TEST(SizingField, GoesWithThePowerOfTwoThirdsOfCurvature) {
    mesh::QuadMesh mesh = two_spheres(16, 1, 4);
    Reference reference = reference_of(mesh);
    const auto density = SizingField::of(mesh, reference, mesh.n_faces());
    ASSERT_TRUE(density);
    const int n = mesh.n_faces() / 2;
    double ratio = 0;
    for (int f = 0; f < n; ++f)
        ratio += density->of_face(mesh, f) / density->of_face(mesh, n + f) / n;
    const double mean = (1 + 0.25) / 2;
    EXPECT_NEAR(ratio, std::pow((0.1 * mean + 1) / (0.1 * mean + 0.25), 2.0 / 3), 0.01);
}

TEST(SizingField, InAPlaneIsOfTheSizesOfTheMeshAsItWas) {
    const auto size = [](const Vector3d &p) { return 0.3 + 0.2 * p.x() + 0.1 * p.y(); };
    for (const int dim : {2, 3}) {
        mesh::QuadMesh mesh = adapt::samples::grid(8, 6, dim);
        Reference reference = reference_of(mesh);
        const auto present = SizingField::of(mesh, reference, 48); // nothing is wished: as it is
        ASSERT_TRUE(present);
        EXPECT_FALSE(present->wished());
        EXPECT_NEAR(present->of_face(mesh, 14), 1, 1e-9);
        set_size(mesh, size);
        const auto density = SizingField::of(mesh, reference, 48);
        ASSERT_TRUE(density);
        EXPECT_TRUE(density->wished());
        // Of another mesh, and when the field is gone.
        mesh = mesh::grid(
            5, 3, [](double s, double t) { return Vector3d(8 * s, 6 * t * (0.7 + 0.3 * s), 0); }, false,
            false, dim);
        const std::vector<int> faces{14, 3, 7};
        const std::vector<double> weights = density->weights(mesh, faces);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const double wanted = size(centre(mesh, faces[i]));
            EXPECT_NEAR(density->of_face(mesh, faces[i]) * wanted * wanted, 1, 1e-9);
            const double area = geometry::area_vector(quad_of(mesh, faces[i])).norm();
            EXPECT_NEAR(weights[i] * wanted * wanted, area, 1e-9);
        }
    }
}

TEST(SizingField, OnASurfaceIsOfTheSizesThere) {
    const auto size = [](const Vector3d &p) { return 0.5 + 0.3 * p.z(); };
    mesh::QuadMesh mesh = mesh::sphere(24);
    set_size(mesh, size);
    Reference reference = reference_of(mesh);
    const auto density = SizingField::of(mesh, reference, mesh.n_faces());
    ASSERT_TRUE(density);
    EXPECT_TRUE(density->wished());
    ASSERT_EQ(reference.density.size(), reference.surface->triangles().size());
    for (std::size_t t = 0; t < reference.density.size(); ++t) {
        Vector3d middle = Vector3d::Zero();
        for (const int i : reference.surface->triangles()[t])
            middle += reference.surface->points()[at(i)] / 3;
        EXPECT_NEAR(reference.density[t] * std::pow(size(middle), 2), 1, 1e-9);
    }
    for (int f = 0; f < mesh.n_faces(); ++f)
        EXPECT_NEAR(density->of_face(mesh, f) * std::pow(size(centre(mesh, f)), 2), 1, 0.25);
    const double bottom = density->of_face(mesh, mesh.faces_around(0).front());
    EXPECT_NEAR(bottom * std::pow(size(point_of(mesh, 0)), 2), 1, 0.25);
}

// While an operation is under way, values of the field are still those of the mesh that it began with.
TEST(SizingField, OfAChangedMeshIsWhatWasWishedBefore) {
    const auto size = [](const Vector3d &p) { return 0.5 + 0.25 * p.x(); };
    mesh::QuadMesh mesh = mesh::grid(8, 8, [](double s, double t) { return Vector3d(s, t, 0); });
    set_size(mesh, size);
    mesh.begun = std::make_shared<const mesh::QuadMesh>(mesh);
    const auto corners = mesh.corners(0); // one face becomes five
    const std::vector<OpenMesh::Vec3d> points = {
        {0.04, 0.04, 0}, {0.08, 0.04, 0}, {0.08, 0.08, 0}, {0.04, 0.08, 0}};
    mesh.replace_disk(
        std::vector{0}, corners,
        std::vector<std::array<int, 4>>{{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}},
        points);
    Reference reference = reference_of(mesh);
    const auto density = SizingField::of(mesh, reference, mesh.n_faces());
    ASSERT_TRUE(density);
    for (int f = 0; f < mesh.n_faces(); ++f)
        EXPECT_NEAR(density->of_face(mesh, f) * std::pow(size(centre(mesh, f)), 2), 1, 1e-9);
    mesh.begun.reset();
    EXPECT_THROW(SizingField::of(mesh, reference, mesh.n_faces()), Failure);
}

TEST(SizingField, OfNoFacesIsNone) {
    mesh::QuadMesh mesh = mesh::QuadMesh::build(3, std::vector<double>{0, 0, 0}, {});
    set_size(mesh, [](const Vector3d &) { return 1.0; });
    Reference reference;
    EXPECT_FALSE(SizingField::of(mesh, reference, 10));
}

TEST(SizingField, WantedAreasAreOneOverIt) {
    mesh::QuadMesh mesh = bent(0.3);
    Reference reference = reference_of(mesh);
    const geometry::SurfacePositions on_surface = reference.on_surface(mesh);
    EXPECT_TRUE(reference.areas(mesh.faces(), on_surface).empty()); // all equal
    const auto density = SizingField::of(mesh, reference, mesh.n_faces());
    ASSERT_TRUE(density);
    const auto quads = mesh.faces().subspan(100, 700);
    const std::vector<double> areas = reference.areas(quads, on_surface);
    ASSERT_EQ(areas.size(), quads.size());
    double wanted = 0, total = 0;
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const int face = static_cast<int>(100 + q);
        wanted += areas[q];
        total += geometry::area_vector(quad_of(mesh, face)).norm();
        EXPECT_NEAR(areas[q] * density->of_face(mesh, face), areas[0] * density->of_face(mesh, 100), 1e-9);
    }
    EXPECT_NEAR(wanted, total, 1e-9);
    const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
    EXPECT_GT(*most, 5 * *least);
}

} // namespace
} // namespace alphamst::reference
