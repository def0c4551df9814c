#include "smooth/areas.h"

#include <gtest/gtest.h>

#include <numeric>

#include "adapt/run.h"

namespace alphamst::smooth {
namespace {

using adapt::samples::grid;

TEST(Areas, OfAnEvenGridAreThoseOfItsFaces) {
    for (const double area : local_areas(grid(6, 6)))
        EXPECT_NEAR(area, 1, 1e-12);
}

// One small face among large ones is an accident; a mesh that is fine on one side is not.
TEST(Areas, AreMeansOverTheFacesAround) {
    mesh::QuadMesh mesh = grid(20, 20);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (const auto p = mesh.point(v); p[0] > 10)
            mesh.set_point(v, {10 + (p[0] - 10) / 4, p[1], 0});
    mesh.set_point(21 * 5 + 5, mesh.point(21 * 5 + 5) + OpenMesh::Vec3d(0.9, 0.9, 0));
    const std::vector<double> areas = local_areas(mesh);
    ASSERT_EQ(areas.size(), 400u);
    EXPECT_NEAR(areas[20 * 10 + 2], 1, 1e-9);
    EXPECT_NEAR(areas[20 * 10 + 17], 0.25, 1e-9);
    EXPECT_NEAR(areas[20 * 5 + 5], 1, 0.2); // 0.1 before
    EXPECT_GT(areas[20 * 10 + 10], 0.3);
}

TEST(Areas, WishedOnesAreSquaresOfSizes) {
    const mesh::QuadMesh mesh = grid(3, 3);
    const std::vector<double> sizes(16, 0.5);
    for (const double area : wished_areas(mesh, sizes))
        EXPECT_NEAR(area, 0.25, 1e-12);
}

TEST(Areas, WantedOnesSumUpToTheMesh) {
    mesh::QuadMesh mesh = grid(8, 8);
    reference::Reference reference = reference::reference_of(mesh);
    const auto density = reference::SizingField::of(mesh, reference, 64);
    ASSERT_TRUE(density);
    const std::vector<double> areas = wanted_areas(mesh, *density);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 64, 1e-9);
}

} // namespace
} // namespace alphamst::smooth
