#include "reference/boundary.h"

#include <gtest/gtest.h>

#include "../mesh/grids.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

TEST(Boundary, CurvesHaveTheMeshAtTheirLeft) {
    const mesh::QuadMesh mesh = mesh::plane(3, 2).build();
    const auto cycles = boundary_cycles(mesh);
    ASSERT_EQ(cycles.size(), 1u);
    EXPECT_EQ(cycles[0].size(), 10u);
    double area = 0; // twice
    for (std::size_t i = 0; i < cycles[0].size(); ++i) {
        const auto &p = mesh.point(cycles[0][i]), &q = mesh.point(cycles[0][(i + 1) % cycles[0].size()]);
        area += p[0] * q[1] - p[1] * q[0];
    }
    EXPECT_DOUBLE_EQ(area, 12);
}

TEST(Boundary, CornersStayAndStraightPartsMayChange) {
    const mesh::QuadMesh mesh = mesh::plane(4, 3).build();
    const Boundary boundary = boundary_of(mesh, 1);
    for (const int corner : {0, 4, 15, 19})
        EXPECT_FALSE(boundary.may_go(corner));
    for (const int v : {1, 2, 3, 5, 9, 18})
        EXPECT_TRUE(boundary.may_go(v)) << v;
    EXPECT_FALSE(boundary.may_go(6)); // inside
    EXPECT_TRUE(boundary.may_change(mesh, 0, 1));
    EXPECT_FALSE(boundary.may_change(mesh, 1, 6));
}

// By 90 degrees, but back again within an edge.
TEST(Boundary, ATeethIsNoCorner) {
    mesh::Grid grid = mesh::plane(12, 3);
    grid.points[3 * 6 + 1] = -1; // vertex 6 at the lower side
    const mesh::QuadMesh mesh = grid.build();
    EXPECT_FALSE(boundary_of(mesh, 0.1).may_go(6));
    EXPECT_TRUE(boundary_of(mesh, 3).may_go(6));
}

TEST(Boundary, FlagsMarkersAndWhatEndsThereStay) {
    mesh::QuadMesh mesh = mesh::plane(8, 3).build();
    mesh.edge_marker.assign(std::size_t(mesh.n_edges()), 0);
    for (int v = 0; v < 4; ++v)
        mesh.edge_marker[std::size_t(mesh.find_edge(v, v + 1))] = 1; // ends at 4
    mesh.vertex_flags[2] = mesh::corner;
    mesh.edge_flags[std::size_t(mesh.find_edge(6, 7))] = mesh::fixed;
    mesh.edge_flags[std::size_t(mesh.find_edge(28, 19))] = mesh::feature; // inside, from the upper side
    Boundary boundary = boundary_of(mesh, 1);
    for (const int v : {2, 4, 6, 7, 28})
        EXPECT_FALSE(boundary.may_go(v)) << v;
    for (const int v : {1, 3, 5, 29})
        EXPECT_TRUE(boundary.may_go(v)) << v;
    EXPECT_FALSE(boundary.may_change(mesh, 6, 7));
    EXPECT_TRUE(boundary.may_change(mesh, 5, 6));
    mesh.curve_numbers = true; // that nobody gave
    EXPECT_TRUE(boundary_of(mesh, 1).may_go(4));
}

TEST(Boundary, LengthsAreThoseThatEdgesHave) {
    mesh::Grid grid = mesh::plane(20, 2);
    for (std::size_t v = 0; v < grid.points.size() / 3; ++v)
        if (grid.points[3 * v] > 10)
            grid.points[3 * v] = 10 + 3 * (grid.points[3 * v] - 10);
    const Boundary boundary = boundary_of(grid.build(), 1);
    EXPECT_NEAR(boundary.present_length(boundary.places[3]), 1, 0.1);
    EXPECT_NEAR(boundary.present_length(boundary.places[16]), 3, 0.3);
    const double between = boundary.present_length(boundary.places[10]);
    EXPECT_GT(between, 1.3);
    EXPECT_LT(between, 2.3);
}

TEST(Boundary, CurvesThatTheMeshKeepsToAreThoseOfBefore) {
    mesh::QuadMesh mesh = mesh::plane(4, 3).build();
    mesh.boundary = curves_of_boundary(mesh);
    EXPECT_TRUE(is_on(mesh, *mesh.boundary));
    mesh.set_point(2, {2.25, 0, 0}); // along the side
    EXPECT_TRUE(is_on(mesh, *mesh.boundary));
    EXPECT_EQ(boundary_of(mesh, 1).curves, mesh.boundary);
    EXPECT_TRUE(boundary_of(mesh, 1).may_go(2));
    mesh.set_point(2, {2, -0.25, 0});
    EXPECT_FALSE(is_on(mesh, *mesh.boundary));
}

} // namespace
} // namespace alphamst::reference
