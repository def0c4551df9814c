#include "adapt/columns.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

#include "../mesh/grids.h"
#include "reference/projection.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

constexpr int n_columns = 20, n_rows = 16;

// Rows along a wall, each 1.5 times as high as the one before; far from it faces are higher than wide. bend:
// the wall rises by so much in its middle.
mesh::QuadMesh layered(double bend = 0) {
    mesh::Grid grid = mesh::plane(n_columns, n_rows);
    for (std::size_t v = 0; v < grid.points.size() / 3; ++v) {
        const double x = grid.points[3 * v] / n_columns, row = grid.points[3 * v + 1];
        const double y = 1e-3 * (std::pow(1.5, row) - 1) / 0.5;
        grid.points[3 * v] = x;
        grid.points[3 * v + 1] = y + bend * std::sin(std::numbers::pi * x) * std::max(0.0, 1 - y);
    }
    return grid.build();
}

// Heights of faces by the height at which they lie, both rounded, of a wall that is straight.
std::map<long, double> heights(const mesh::QuadMesh &mesh) {
    std::map<long, double> found;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        const auto way = mesh.point(w) - mesh.point(v);
        if (std::abs(way[1]) > std::abs(way[0]))
            found[std::lround(1e6 * (mesh.point(v)[1] + mesh.point(w)[1]))] = std::abs(way[1]);
    }
    return found;
}

TEST(Columns, RowsKeepTheirHeights) {
    const auto before = heights(layered());
    ASSERT_EQ(before.size(), std::size_t(n_rows));
    for (const double alpha : {0.25, 0.5, 0.7, 1.5, 2.0, 4.0}) {
        mesh::QuadMesh mesh = layered();
        const auto wanted = std::llround(alpha * mesh.n_faces());
        ASSERT_TRUE(adapt_columns(mesh, wanted, Settings())) << alpha;
        mesh.check();
        EXPECT_EQ(mesh.n_faces(), wanted);
        EXPECT_EQ(mesh.n_faces() % n_rows, 0);
        EXPECT_EQ(heights(mesh), before);
        EXPECT_TRUE(mesh.singularities().empty());
    }
}

// New vertices lie on the curve; the lines above them follow.
TEST(Columns, OnABentWall) {
    for (const double alpha : {0.5, 2.0}) {
        mesh::QuadMesh mesh = layered(0.2);
        reference::keep_boundary(mesh, {}, 0.5);
        ASSERT_TRUE(adapt_columns(mesh, std::llround(alpha * mesh.n_faces()), Settings()));
        mesh.check();
        EXPECT_TRUE(reference::is_on(mesh, *mesh.boundary));
        EXPECT_GT(reference::least_quality(mesh), 0.5);
    }
}

TEST(Columns, CornersAndFlaggedVerticesKeepTheirLines) {
    mesh::QuadMesh mesh = layered();
    mesh.vertex_flags[7] = mesh::corner;
    const auto kept = mesh.point(7);
    ASSERT_TRUE(adapt_columns(mesh, mesh.n_faces() / 4, Settings()));
    int found = 0;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        found += mesh.point(v) == kept && mesh.vertex_flags[std::size_t(v)] == mesh::corner;
    EXPECT_EQ(found, 1);
}

TEST(Columns, OtherMeshesStay) {
    mesh::QuadMesh squares = mesh::plane(20, 16).build();
    EXPECT_FALSE(adapt_columns(squares, 640, Settings()));
    EXPECT_EQ(squares.n_faces(), 320);
    mesh::QuadMesh mesh = layered();
    EXPECT_FALSE(adapt_columns(mesh, mesh.n_faces(), Settings()));
}

} // namespace
} // namespace alphamst::adapt
