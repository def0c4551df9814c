#include "reference/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "adapt/meshes.h"
#include "mesh/grids.h"

namespace alphamst::reference {
namespace {

TEST(Statistics, InteriorVerticesAreCountedByValence) {
    std::map<int, std::int64_t> valences;
    std::int64_t singular = 0;
    count(adapt::samples::star(5, 3), valences, singular); // 2 * 2 in each of 5 sectors, 2 on each spoke
    EXPECT_EQ(valences, (std::map<int, std::int64_t>{{4, 30}, {5, 1}}));
    EXPECT_EQ(singular, 1);
    mesh::Grid grid = mesh::plane(2, 2);
    grid.points.insert(grid.points.end(), {9, 9, 0}); // of no face
    count(grid.build(), valences, singular);          // anew
    EXPECT_EQ(valences, (std::map<int, std::int64_t>{{4, 1}}));
    EXPECT_EQ(singular, 0);
}

TEST(Statistics, VerticesOfSomeFacesAreCountedOnce) {
    const mesh::QuadMesh mesh = adapt::samples::star(5, 2);
    std::map<int, std::int64_t> all, some;
    std::int64_t singular = 7;
    count(mesh, all, singular);
    EXPECT_EQ(singular, 1);
    count(mesh, std::vector<int>{0}, some, singular); // at the middle
    EXPECT_EQ(singular, 1);
    EXPECT_EQ(some, (std::map<int, std::int64_t>{{4, 3}, {5, 1}}));
    count(mesh, adapt::samples::all_faces(mesh), some, singular);
    EXPECT_EQ(some, all);
}

TEST(Statistics, TheTimeStepIsThatOfTheSmallestFace) {
    mesh::Grid grid = mesh::plane(3, 2);
    const mesh::QuadMesh even = grid.build();
    EXPECT_NEAR(time_step(even), 0.25, 1e-12);
    grid.points[3] = 0.5; // vertex 1: face 0 becomes narrower below, face 1 wider
    const mesh::QuadMesh mesh = grid.build();
    const double slanted = std::sqrt(1.25);
    EXPECT_NEAR(time_step(mesh), 0.75 / (2.5 + slanted), 1e-12);
    EXPECT_NEAR(time_step(mesh, std::vector{1}), 1.25 / (3.5 + slanted), 1e-12);
    EXPECT_NEAR(time_step(mesh, std::vector{2, 3}), 0.25, 1e-12);
    // Two quads in the place of face 2: its vertices 2, 3, 7, 6 and a new one on either side.
    const std::vector<std::array<int, 4>> quads{{0, 1, 4, 5}, {5, 4, 2, 3}};
    const std::vector<OpenMesh::Vec3d> points{{2, 0, 0}, {3, 0, 0},    {3, 1, 0},
                                              {2, 1, 0}, {3, 0.25, 0}, {2, 0.25, 0}};
    EXPECT_NEAR(time_step(quads, points), 0.25 / 2.5, 1e-12);
    EXPECT_EQ(time_step(mesh, std::vector<int>{}), 0);
}

TEST(Statistics, TheAspectRatioIsTheLargest) {
    mesh::Grid grid = mesh::plane(3, 2);
    EXPECT_NEAR(largest_aspect_ratio(grid.build()), 1, 1e-12);
    grid.points[3] = 0.5; // vertex 1, as above: face 1 has the longest edges
    const mesh::QuadMesh mesh = grid.build();
    const double slanted = std::sqrt(1.25);
    EXPECT_NEAR(largest_aspect_ratio(mesh, std::vector{0, 2}), slanted * (2.5 + slanted) / 3, 1e-12);
    const double wide = 1.5 * (3.5 + slanted) / 5;
    EXPECT_NEAR(largest_aspect_ratio(mesh, std::vector{1, 2}), wide, 1e-12);
    EXPECT_NEAR(largest_aspect_ratio(mesh), wide, 1e-12);
    const std::vector<std::array<int, 4>> quads{{0, 1, 4, 5}, {5, 4, 2, 3}};
    const std::vector<OpenMesh::Vec3d> points{{2, 0, 0}, {3, 0, 0},    {3, 1, 0},
                                              {2, 1, 0}, {3, 0.25, 0}, {2, 0.25, 0}};
    EXPECT_NEAR(largest_aspect_ratio(quads, points), 2.5, 1e-12);
    EXPECT_EQ(largest_aspect_ratio(mesh, std::vector<int>{}), 0);
    EXPECT_FALSE(std::signbit(largest_aspect_ratio(mesh, std::vector<int>{})));
}

TEST(Statistics, AFaceThatIsAPointHasNoTimeStep) {
    const mesh::QuadMesh point = mesh::Grid{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 2, 3}}.build();
    EXPECT_EQ(time_step(point), 0);
    EXPECT_EQ(time_step_ratio(0, 0), 1); // nothing has changed
    EXPECT_EQ(time_step_ratio(2, 1), 0.5);
    EXPECT_EQ(time_step_ratio(0, 1), std::numeric_limits<double>::infinity());
}

TEST(Statistics, AMeshIsFlattenedIntoItsPlane) {
    const mesh::QuadMesh mesh = mesh::plane(3, 2).build();
    const geometry::Points above = flatten(mesh, geometry::Plane::of_coordinates(false));
    const geometry::Points below = flatten(mesh, geometry::Plane::of_coordinates(true));
    ASSERT_EQ(above.size(), 12u);
    ASSERT_EQ(below.size(), 12u);
    for (int v = 0; v < 12; ++v) {
        const auto i = static_cast<std::size_t>(v);
        EXPECT_EQ(above[i], Eigen::Vector2d(mesh.point(v)[0], mesh.point(v)[1]));
        EXPECT_EQ(below[i].y(), -mesh.point(v)[1]);
    }
}

TEST(Statistics, BoundaryVerticesWantAFaceForEachRightAngle) {
    const mesh::QuadMesh ell = mesh::ell().build();
    for (int v = 0; v < ell.n_vertices(); ++v)
        EXPECT_EQ(mismatch(ell, v), 0) << v;
    // Vertex 1 is straight with one face, vertex 0 of the second mesh square with two.
    const mesh::QuadMesh flat = mesh::Grid{{0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0}, {0, 1, 2, 3}}.build();
    EXPECT_EQ(mismatch(flat, 1), 1);
    EXPECT_EQ(mismatch(flat, 0), 0); // 45 degrees, which are worth a face at least
    const mesh::QuadMesh split = mesh::Grid{
        {0, 0, 0, 1, 0, 0, 1.5, 0.5, 0, 1, 1, 0, 0.5, 1.5, 0, 0, 1, 0},
        {0, 1, 2, 3, 0, 3, 4, 5}}.build();
    EXPECT_EQ(mismatch(split, 0), -1);
}

TEST(Statistics, FewestSingularVerticesAreAllOfOneKind) {
    EXPECT_TRUE(fewest_singular({{4, 100}}));
    EXPECT_TRUE(fewest_singular({{3, 8}, {4, 10}})); // a cube
    EXPECT_FALSE(fewest_singular({{3, 9}, {4, 10}, {5, 1}}));
    EXPECT_TRUE(fewest_singular({{4, 10}, {6, 1}}));
}

} // namespace
} // namespace alphamst::reference
