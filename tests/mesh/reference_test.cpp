#include "mesh/reference.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "capi/handles.h"
#include "grids.h"

namespace alphamst::mesh {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

Triangles triangles_of(std::vector<double> points) {
    return surface_of(Grid{std::move(points), {0, 1, 2, 3}}.build(3))->triangles();
}

TEST(Reference, HasTheVerticesAndTwoTrianglesAFace) {
    const QuadMesh mesh = torus(24, 16).build(3);
    const auto surface = surface_of(mesh);
    ASSERT_EQ(surface->points().size(), 384u);
    ASSERT_EQ(surface->triangles().size(), 768u);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const auto spot = surface->nearest({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
        EXPECT_EQ(spot.distance, 0);
        const std::vector<int> faces = mesh.faces_around(v);
        EXPECT_EQ(spot.triangle / 2, *std::min_element(faces.begin(), faces.end()));
        // Outwards from the circle of radius 3 in the middle of the tube.
        const Eigen::Vector3d p = spot.point;
        const double ring = std::hypot(p.x(), p.y());
        const Eigen::Vector3d exact = p - Eigen::Vector3d(p.x(), p.y(), 0) * (3 / ring);
        EXPECT_GT(spot.normal.dot(exact), 0.98);
    }
}

TEST(Reference, CutsAlongTheShorterDiagonal) {
    EXPECT_EQ(triangles_of({0, 0, 0, 2, 0, 0, 3, 1, 0, 1, 1, 0}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
    EXPECT_EQ(triangles_of({1, 0, 0, 3, 0, 0, 2, 1, 0, 0, 1, 0}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    // Neither is shorter.
    EXPECT_EQ(triangles_of({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    // Not plane, and still the shorter one.
    EXPECT_EQ(triangles_of({0, 0, 0, 2, 0, 0.3, 3, 1, 0, 1, 1, 0.3}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Reference, CutsAFaceThatIsNotConvexInside) {
    // An arrow with the point inwards at vertex 3 or 2; the shorter diagonal is outside.
    EXPECT_EQ(triangles_of({-1, 0, 0, 0, 3, 0, 1, 0, 0, 0, 2, 0}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
    EXPECT_EQ(triangles_of({0, 2, 0, -1, 0, 0, 0, 3, 0, 1, 0, 0})[0], (std::array{0, 1, 2}));
    // Vertex 1 is in the middle of a side: the shorter diagonal would leave a triangle without area.
    EXPECT_EQ(triangles_of({0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 3, 0}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Reference, CopiesOfAMeshShareTheirSurface) {
    QuadMesh mesh = plane(2, 1).build();
    EXPECT_EQ(mesh.surface, nullptr);
    const std::uint64_t before = mesh.checksum();
    mesh.surface = surface_of(mesh);
    EXPECT_EQ(QuadMesh(mesh).surface, mesh.surface);
    EXPECT_EQ(mesh.checksum(), before);
}

// No call of the C interface gives the surface back, so the handle is opened.
TEST(Reference, IsWhatTheCallerSays) {
    const double corners[8] = {0, 0, 2, 0, 2, 2, 0, 2};
    const std::int32_t face[4] = {1, 2, 3, 4}, bad[3] = {1, 2, 5}, triangles[6] = {3, 1, 2, 1, 3, 4};
    amst_context *context = nullptr;
    amst_mesh *mesh = nullptr;
    ASSERT_EQ(amst_context_create(1, &context), AMST_OK);
    ASSERT_EQ(amst_mesh_create(context, 2, corners, 4, 0, 0, face, 1, 0, 0, 4, nullptr, &mesh), AMST_OK);
    const auto surface = [&] { return mesh->impl->current->surface; };
    EXPECT_EQ(surface(), nullptr);
    ASSERT_EQ(amst_mesh_set_surface(mesh, corners, 4, triangles, 2), AMST_OK);
    const auto given = surface();
    EXPECT_EQ(given->triangles(), (Triangles{{2, 0, 1}, {0, 2, 3}}));
    EXPECT_EQ(given->points()[2], Eigen::Vector3d(2, 2, 0));
    EXPECT_EQ(amst_mesh_set_surface(mesh, corners, 4, bad, 1), AMST_ERR_RANGE);
    EXPECT_EQ(surface(), given); // after a failure
    std::int64_t mark = 0;
    ASSERT_EQ(amst_mesh_mark(mesh, &mark), AMST_OK);
    ASSERT_EQ(amst_mesh_set_surface(mesh, nullptr, 0, nullptr, 0), AMST_OK);
    EXPECT_EQ(surface()->triangles(), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(amst_mesh_rollback(mesh, mark), AMST_OK);
    EXPECT_EQ(surface(), given);
    amst_mesh_destroy(mesh);
    amst_context_destroy(context);
}

} // namespace
} // namespace alphamst::mesh
