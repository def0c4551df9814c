#include "smooth/relax.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "adapt/run.h"
#include "geometry/approximation_error.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/size_error.h"
#include "reference/surface_of.h"

namespace alphamst::smooth {
namespace {

using adapt::samples::all_faces;
using adapt::samples::grid;
using adapt::samples::least_scaled_jacobian;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Eigen::Vector3d bump(double s, double t) {
    return {s, t, 0.3 * std::exp(-12 * ((s - 0.45) * (s - 0.45) + (t - 0.55) * (t - 0.55)))};
}

TEST(Relax, VerticesOnTheBoundaryFixedAndIsolatedOnesAreConstrained) {
    mesh::QuadMesh mesh = grid(3, 3);
    mesh.vertex_flags[5] |= mesh::fixed;
    const std::vector<char> constrained = constrained_vertices(mesh);
    ASSERT_EQ(constrained.size(), 16u);
    for (int v = 0; v < 16; ++v)
        EXPECT_EQ(constrained[at(v)] != 0, mesh.on_boundary(v) || v == 5) << v;
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 5, 5, 0};
    const mesh::QuadMesh isolated = mesh::QuadMesh::build(2, points, std::vector<std::int32_t>{0, 1, 2, 3});
    EXPECT_NE(constrained_vertices(isolated)[4], 0);
}

TEST(Relax, NeverLowersTheWorstCornerInThePlane) {
    mesh::QuadMesh mesh = grid(8, 8);
    std::mt19937 random(3);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.on_boundary(v))
            mesh.set_point(v,
                           mesh.point(v) + OpenMesh::Vec3d(0.5 * adapt::samples::chance(random) - 0.25,
                                                           0.5 * adapt::samples::chance(random) - 0.25, 0));
    const mesh::QuadMesh before = mesh;
    const double worst = least_scaled_jacobian(mesh, all_faces(mesh));
    reference::Reference reference = reference::reference_of(mesh);
    ASSERT_TRUE(reference.plane);
    relax_by_sizes(mesh, reference, std::nullopt, {});
    mesh.check();
    EXPECT_GT(least_scaled_jacobian(mesh, all_faces(mesh)), worst + 0.1);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (mesh.on_boundary(v)) {
            EXPECT_EQ(mesh.point(v), before.point(v));
        }
}

// A grid with boundary points where its rows begin that has to become three times as dense in its middle:
// areas have a long way to go. No corner that was good closes.
TEST(Relax, SettlingBringsAreasFartherThanRelaxing) {
    constexpr int n = 40;
    mesh::QuadMesh mesh = grid(n, n);
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        field.values.push_back(
            1 +
            std::min(1.0, (reference::point_of(mesh, v) - Eigen::Vector3d(n / 2.0, n / 2.0, 0)).norm() / 8));
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
    reference::Reference reference = reference::reference_of(mesh);
    reference::WholeSizes sizes(mesh, reference, mesh.n_faces());
    const auto density = reference::SizingField::of(mesh, reference, mesh.n_faces());
    mesh::QuadMesh relaxed = mesh;
    relax_by_sizes(relaxed, reference, density, {});
    settle_by_sizes(mesh, reference, density, {});
    EXPECT_NO_THROW(mesh.check());
    EXPECT_LT(sizes.error(mesh).rms, 0.8 * sizes.error(relaxed).rms);
    EXPECT_GE(least_scaled_jacobian(mesh, all_faces(mesh)), 0.5);
}

// A coarse mesh of a bump: its vertices stay on the surface, and what is between them comes nearer to it.
TEST(Relax, FittingBringsFacesNearerToTheSurface) {
    const mesh::QuadMesh fine = mesh::grid(48, 48, bump);
    mesh::QuadMesh mesh = mesh::grid(8, 8, bump);
    mesh.surface = reference::surface_of(fine);
    reference::Reference reference = reference::reference_of(mesh);
    const auto error = [&] {
        const geometry::SurfacePositions on_surface = reference.on_surface(mesh);
        geometry::ApproximationError error(*mesh.surface, mesh.faces(), on_surface);
        error.measure(on_surface, {});
        return error.mean_square();
    };
    const double before = error();
    fit_to_surface(mesh, reference, std::nullopt, {});
    mesh.check();
    EXPECT_LT(error(), 0.9 * before);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_LT(mesh.surface->nearest(reference::point_of(mesh, v)).distance, 1e-9);
}

// One vertex goes where its faces stay good, another one where they would invert: it comes back.
TEST(Relax, WhatSpoilsFacesIsRolledBack) {
    mesh::QuadMesh mesh = mesh::grid(12, 12, bump);
    reference::Reference reference = reference::reference_of(mesh);
    const mesh::QuadMesh before = mesh;
    const geometry::SurfacePositions start = reference.on_surface(mesh);
    geometry::SurfacePositions moved = start;
    const int good = 2 * 13 + 2, bad = 9 * 13 + 9;
    for (const auto &[v, step] : {std::pair(good, 0.01), std::pair(bad, 0.13)}) {
        const Eigen::Vector3d p = start.points[at(v)] + Eigen::Vector3d(step, step, 0);
        moved.put(v, reference.surface->nearest(p));
    }
    EXPECT_TRUE(accept_or_roll_back(mesh, reference, start, moved, {}));
    mesh.check();
    EXPECT_NE(mesh.point(good), before.point(good));
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (v != good) {
            EXPECT_EQ(mesh.point(v), before.point(v)) << v;
        }
    EXPECT_EQ(reference.surface_triangles[at(good)], moved.surface_triangles[at(good)]);
}

} // namespace
} // namespace alphamst::smooth
