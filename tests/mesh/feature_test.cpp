#include "mesh/feature.h"

#include <gtest/gtest.h>

#include <numbers>

#include "grids.h"

namespace alphamst::mesh {
namespace {

// A strip of nx * ny unit squares that is folded by `angle` degrees along the line x = fold.
QuadMesh folded(int nx, int ny, int fold, double angle) {
    Grid grid = plane(nx, ny);
    const double a = angle * std::numbers::pi / 180;
    for (std::size_t v = 0; v < grid.points.size(); v += 3)
        if (const double beyond = grid.points[v] - fold; beyond > 0) {
            grid.points[v] = fold + beyond * std::cos(a);
            grid.points[v + 2] = beyond * std::sin(a);
        }
    return grid.build(3);
}

// The surface of n^3 unit cubes; vertices in no order.
QuadMesh cube(int n) {
    Grid grid;
    std::vector<int> number(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
    const auto vertex = [&](std::array<int, 3> p) {
        int &v = number[static_cast<std::size_t>((p[2] * (n + 1) + p[1]) * (n + 1) + p[0])];
        if (v < 0) {
            v = static_cast<int>(grid.points.size() / 3);
            grid.points.insert(grid.points.end(), {double(p[0]), double(p[1]), double(p[2])});
        }
        return v;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto at = [&](int u, int w) {
                        std::array<int, 3> p;
                        p[axis] = side;
                        p[(axis + 1) % 3] = side > 0 ? u : w;
                        p[(axis + 2) % 3] = side > 0 ? w : u;
                        return vertex(p);
                    };
                    const auto [a, b] = side > 0 ? std::pair(i, j) : std::pair(j, i);
                    grid.faces.insert(grid.faces.end(),
                                      {at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)});
                }
    return grid.build(3);
}

std::vector<int> edges_on_line(const QuadMesh &mesh, double x) {
    std::vector<int> found;
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (const auto [v, w] = mesh.edge_vertices(e); mesh.point(v)[0] == x && mesh.point(w)[0] == x)
            found.push_back(e);
    return found;
}

TEST(Feature, AFoldIsACurveFromBoundaryToBoundary) {
    const QuadMesh mesh = folded(6, 4, 2, 35);
    const Features features = find_features(mesh, 30);
    EXPECT_EQ(features.edges, edges_on_line(mesh, 2));
    EXPECT_EQ(features.edges.size(), 4u);
    EXPECT_EQ(features.corners, (std::vector{2, 30}));
}

TEST(Feature, OnlyEdgesAboveTheAngleAreSharp) {
    const QuadMesh mesh = folded(4, 2, 2, 35);
    EXPECT_EQ(find_features(mesh, 34.999).edges.size(), 2u);
    EXPECT_EQ(find_features(mesh, 35.001).edges.size(), 0u);
    EXPECT_EQ(find_features(mesh, 35.001).corners.size(), 0u);
    EXPECT_EQ(find_features(cube(1), 90).edges.size(), 0u); // not above
}

TEST(Feature, APlaneHasNone) {
    const Features features = find_features(plane(5, 5).build(), 0);
    EXPECT_TRUE(features.edges.empty());
    EXPECT_TRUE(features.corners.empty());
}

TEST(Feature, ACubeHasTwelveCurvesAndEightCorners) {
    for (const int n : {1, 3}) {
        const QuadMesh mesh = cube(n);
        const Features features = find_features(mesh, 60);
        EXPECT_EQ(features.edges.size(), 12u * static_cast<unsigned>(n));
        ASSERT_EQ(features.corners.size(), 8u);
        for (const int v : features.corners)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(mesh.point(v)[i] * (n - mesh.point(v)[i]), 0);
    }
}

TEST(Feature, ACurveHasACornerWhereItTurns) {
    QuadMesh mesh = plane(4, 4).build(3);
    // Flags make a closed curve around vertex 12 in the plane.
    for (const auto &[v, w] :
         {std::pair{6, 7}, {7, 8}, {8, 13}, {13, 18}, {18, 17}, {17, 16}, {16, 11}, {11, 6}})
        mesh.edge_flags[static_cast<std::size_t>(mesh.find_edge(v, w))] = feature;
    EXPECT_EQ(find_features(mesh, 30).corners, (std::vector{6, 8, 16, 18}));
    EXPECT_TRUE(find_features(mesh, 30).edges.empty());
    // Now the same curve turns by 45 degrees, twice as often.
    for (const int v : {6, 8, 16, 18}) {
        OpenMesh::Vec3d p = mesh.point(v);
        for (std::size_t i = 0; i < 2; ++i)
            p[i] = 2 + (p[i] - 2) * std::numbers::sqrt2 / 2;
        mesh.set_point(v, p);
    }
    EXPECT_TRUE(find_features(mesh, 30).corners.empty());
}

TEST(Feature, NewCurvesMeetThoseThereAre) {
    QuadMesh mesh = folded(6, 4, 2, 35);
    // A flagged curve from the fold at vertex 16 to vertex 18.
    for (const auto &[v, w] : {std::pair{16, 17}, {17, 18}})
        mesh.edge_flags[static_cast<std::size_t>(mesh.find_edge(v, w))] = feature | fixed;
    EXPECT_EQ(find_features(mesh, 30).corners, (std::vector{2, 16, 18, 30}));
    EXPECT_EQ(find_features(mesh, 30).edges.size(), 4u);
}

TEST(Feature, AFaceWithoutAreaHasNoAngle) {
    // The face in the middle is a line, where the last one goes upwards.
    Grid grid = plane(3, 1);
    grid.points = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 1, 1, 0, 1, 1, 1};
    EXPECT_TRUE(find_features(grid.build(3), 0).edges.empty());
}

} // namespace
} // namespace alphamst::mesh
