#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "grids.h"

namespace alphamst::mesh {
namespace {

TEST(QuadMesh, Counts) {
    const QuadMesh mesh = plane(4, 3).build();
    EXPECT_EQ(mesh.dim(), 2);
    EXPECT_EQ(mesh.n_vertices(), 20);
    EXPECT_EQ(mesh.n_edges(), 31);
    EXPECT_EQ(mesh.n_faces(), 12);
    EXPECT_EQ(mesh.vertex_flags.size(), 20u);
    EXPECT_EQ(mesh.edge_flags.size(), 31u);
    EXPECT_EQ(mesh.face_flags.size(), 12u);
    std::vector<std::int32_t> identity(31);
    std::iota(identity.begin(), identity.end(), 0);
    EXPECT_EQ(mesh.edge_origin, identity);
}

TEST(QuadMesh, FacesAreWhatWasGiven) {
    Grid grid = plane(4, 3);
    for (std::size_t f = 0; f < grid.faces.size() / 4; ++f) { // each from another corner
        const auto first = grid.faces.begin() + static_cast<std::ptrdiff_t>(4 * f);
        std::rotate(first, first + static_cast<std::ptrdiff_t>(f % 4), first + 4);
    }
    const QuadMesh mesh = grid.build();
    ASSERT_EQ(mesh.faces().size(), 12u);
    for (std::size_t i = 0; i < grid.faces.size(); ++i) {
        EXPECT_EQ(mesh.faces()[i / 4][i % 4], grid.faces[i]);
        EXPECT_EQ(mesh.corners(static_cast<int>(i / 4))[i % 4], grid.faces[i]);
    }
    EXPECT_TRUE((Grid{{0, 0, 0}, {}}.build().faces().empty()));
}

TEST(QuadMesh, Edges) {
    const QuadMesh mesh = plane(2, 2).build();
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        EXPECT_LT(v, w);
        EXPECT_EQ(mesh.find_edge(v, w), e);
        EXPECT_EQ(mesh.find_edge(w, v), e);
    }
    EXPECT_EQ(mesh.find_edge(0, 4), -1);
    EXPECT_EQ(mesh.edge_faces(mesh.find_edge(1, 4)), (std::array{0, 1}));
    EXPECT_EQ(mesh.edge_faces(mesh.find_edge(4, 3)), (std::array{2, 0}));
    EXPECT_EQ(mesh.edge_faces(mesh.find_edge(0, 1)), (std::array{0, -1}));
    EXPECT_EQ(mesh.edge_faces(mesh.find_edge(0, 3)), (std::array{-1, 0}));
}

TEST(QuadMesh, AroundAnInteriorVertex) {
    const QuadMesh mesh = plane(2, 2).build();
    auto faces = mesh.faces_around(4);
    auto vertices = mesh.vertices_around(4);
    std::rotate(faces.begin(), std::find(faces.begin(), faces.end(), 0), faces.end());
    std::rotate(vertices.begin(), std::find(vertices.begin(), vertices.end(), 1), vertices.end());
    EXPECT_EQ(faces, (std::vector{0, 1, 3, 2}));
    EXPECT_EQ(vertices, (std::vector{1, 5, 7, 3}));
    EXPECT_EQ(mesh.valence(4), 4);
    EXPECT_FALSE(mesh.on_boundary(4));
}

TEST(QuadMesh, AroundABoundaryVertex) {
    const QuadMesh mesh = ell().build();
    EXPECT_EQ(mesh.faces_around(4), (std::vector{2, 0, 1}));
    EXPECT_EQ(mesh.vertices_around(4), (std::vector{7, 3, 1, 5}));
    EXPECT_EQ(mesh.valence(4), 4);
    EXPECT_TRUE(mesh.on_boundary(4));
    EXPECT_EQ(mesh.vertices_around(0), (std::vector{1, 3}));
}

TEST(QuadMesh, IsolatedVertex) {
    const QuadMesh mesh = Grid{{0, 0, 0}, {}}.build();
    EXPECT_TRUE(mesh.isolated(0));
    EXPECT_FALSE(mesh.on_boundary(0));
    EXPECT_FALSE(mesh.singular(0));
    EXPECT_EQ(mesh.valence(0), 0);
    EXPECT_TRUE(mesh.faces_around(0).empty());
    EXPECT_EQ(mesh.find_edge(0, 0), -1);
}

TEST(QuadMesh, NeighboursFollowTheCorners) {
    const QuadMesh mesh = plane(3, 3).build();
    EXPECT_EQ(mesh.neighbours(4), (std::array{1, 5, 7, 3}));
    EXPECT_EQ(mesh.neighbours(0), (std::array{-1, 1, 3, -1}));
}

TEST(QuadMesh, Singularities) {
    EXPECT_TRUE(plane(5, 5).build().singularities().empty());
    EXPECT_TRUE(torus(5, 5).build(3).singularities().empty());
    const Grid cube{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1},
                    {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7}};
    EXPECT_EQ(cube.build(3).singularities(), (std::vector{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(QuadMesh, CopyIsDeep) {
    QuadMesh mesh = plane(2, 2).build();
    const QuadMesh copy = mesh;
    mesh.set_point(0, {5, 5, 5});
    mesh.vertex_flags[3] = fixed;
    mesh.replace_disk(std::vector{0}, std::vector{0, 1, 4, 3}, std::vector{std::array{1, 2, 3, 0}}, {});
    EXPECT_EQ(mesh.corners(0), (std::array{1, 4, 3, 0}));
    EXPECT_EQ(copy.corners(0), (std::array{0, 1, 4, 3}));
    EXPECT_EQ(copy.point(0)[0], 0);
    EXPECT_EQ(copy.vertex_flags[3], 0);
}

TEST(QuadMesh, ResetOrigins) {
    QuadMesh mesh = plane(2, 2).build();
    mesh.vertex_origin[2] = mesh.edge_origin[2] = mesh.face_origin[2] = -1;
    mesh.reset_origins();
    EXPECT_EQ(mesh.vertex_origin[2], 2);
    EXPECT_EQ(mesh.edge_origin[2], 2);
    EXPECT_EQ(mesh.face_origin[2], 2);
}

} // namespace
} // namespace alphamst::mesh
