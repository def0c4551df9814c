#include "patch/window.h"

#include <gtest/gtest.h>

#include "grid.h"

namespace alphamst::patch {
namespace {

using testing::block;
using testing::grid;

TEST(Convexity, DoesNotDependOnThePlane) {
    mesh::QuadMesh mesh = grid(4, 4);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const OpenMesh::Vec3d p = mesh.point(v);
        mesh.set_point(v, {p[1], 0.6 * p[0], 0.8 * p[0]});
    }
    EXPECT_NEAR(convexity(mesh, make_window(mesh, {std::vector<int>{5, 6, 9}})), 3 / 3.5, 1e-12);
    EXPECT_NEAR(convexity(mesh, make_window(mesh, block(4, 0, 0, 4, 4))), 1, 1e-12);
}

TEST(Convexity, IsThePartOfTheHull) {
    const mesh::QuadMesh mesh = grid(5, 5);
    const std::vector<int> cross{7, 11, 12, 13, 17}; // hull: 3 x 3 less four half squares
    EXPECT_NEAR(convexity(mesh, make_window(mesh, cross)), 5.0 / 7, 1e-12);
    EXPECT_NEAR(convexity(mesh, make_window(mesh, std::vector<int>{12})), 1, 1e-12);
}

TEST(Convexity, IsNoneWithoutArea) {
    mesh::QuadMesh mesh = grid(2, 1);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        mesh.set_point(v, {1, 1, 0});
    EXPECT_EQ(convexity(mesh, make_window(mesh, block(2, 0, 0, 2, 1))), 0);
}

} // namespace
} // namespace alphamst::patch
