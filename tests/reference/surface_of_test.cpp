#include "reference/surface_of.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "capi/handles.h"
#include "mesh/grids.h"

namespace alphamst::reference {
namespace {

using namespace mesh;

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

void set_feature(QuadMesh &mesh, int v, int w) {
    mesh.edge_flags.resize(static_cast<std::size_t>(mesh.n_edges()));
    mesh.edge_flags[static_cast<std::size_t>(mesh.find_edge(v, w))] = feature;
}

// The lengths of the curves that the mesh would have, ascending.
std::vector<double> lengths(const QuadMesh &mesh) {
    std::vector<double> result;
    if (const auto curves = curves_of(mesh))
        for (const surface::Line &line : curves->lines())
            result.push_back((line.end - line.start).norm());
    std::sort(result.begin(), result.end());
    return result;
}

TEST(Curves, AreFeaturesNumbersAndBordersInside) {
    QuadMesh mesh = plane(4, 4).build(3); // vertex (i, j) is 5 j + i
    EXPECT_TRUE(lengths(mesh).empty());
    set_feature(mesh, 6, 7);
    set_feature(mesh, 7, 8);
    set_feature(mesh, 1, 2); // on the boundary, where nothing moves
    EXPECT_EQ(lengths(mesh), std::vector<double>{2});
    mesh.edge_flags.clear();
    mesh.edge_marker.assign(static_cast<std::size_t>(mesh.n_edges()), 0);
    mesh.edge_marker[static_cast<std::size_t>(mesh.find_edge(6, 11))] = 3;
    EXPECT_EQ(lengths(mesh), std::vector<double>{1});
    mesh.edge_marker.clear();
    mesh.face_marker.assign(16, 1);
    mesh.face_marker[5] = mesh.face_marker[6] = 2;
    EXPECT_EQ(lengths(mesh), (std::vector<double>{1, 1, 2, 2}));
}

TEST(Curves, StayWhatTheyWereUntilFeaturesLieElsewhere) {
    QuadMesh mesh = plane(4, 4).build(3);
    const std::uint64_t before = mesh.checksum();
    for (const int v : {10, 11, 12, 13})
        set_feature(mesh, v, v + 1);
    mesh.curves = curves_of(mesh);
    const auto first = mesh.curves;
    EXPECT_EQ(QuadMesh(mesh).curves, first);
    EXPECT_EQ(curves_of(mesh), first);
    // Along the line, also to where rounding leaves it.
    mesh.set_point(12, {2.7, 2 + 1e-13, 0});
    EXPECT_EQ(curves_of(mesh), first);
    mesh.edge_flags.assign(mesh.edge_flags.size(), 0);
    EXPECT_EQ(curves_of(mesh), first); // they may be flagged again
    EXPECT_NE(mesh.checksum(), before);
    // New features do not change the old ones: the vertex that was moved is not on the line to the last bit.
    for (const int v : {10, 11, 12, 13})
        set_feature(mesh, v, v + 1);
    set_feature(mesh, 2, 7);
    mesh.curves = curves_of(mesh);
    ASSERT_EQ(mesh.curves->lines().size(), 2u);
    EXPECT_EQ(mesh.curves->lines()[0].start, first->lines()[0].start);
    EXPECT_EQ(mesh.curves->lines()[0].end, first->lines()[0].end);
    // Two of four edges are put elsewhere; later all are.
    mesh.set_point(12, {2, 2.5, 0});
    mesh.curves = curves_of(mesh);
    EXPECT_EQ(mesh.curves->lines().size(), 4u);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        mesh.set_point(v, mesh.point(v) + OpenMesh::Vec3d(0, 0, 1));
    mesh.curves = curves_of(mesh);
    EXPECT_EQ(mesh.curves->lines().size(), 5u); // of before there are none left
}

} // namespace
} // namespace alphamst::reference
