#include "patch/patches.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::block;
using testing::grid;
using testing::mark;
using testing::none;

TEST(Select, RingsAreLayersAroundAVertex) {
    const mesh::QuadMesh mesh = grid(6, 6);
    const int centre = 3 * 7 + 3;
    EXPECT_TRUE(rings(mesh, centre, 0, none).empty());
    EXPECT_EQ(rings(mesh, centre, 1, none), block(6, 2, 2, 4, 4));
    EXPECT_EQ(rings(mesh, centre, 2, none), block(6, 1, 1, 5, 5));
    EXPECT_EQ(rings(mesh, 0, 2, none), block(6, 0, 0, 2, 2));
    EXPECT_EQ(rings(mesh, centre, 9, none).size(), 36U);
    EXPECT_EQ(rings(mesh, 0, 6, mark(mesh, block(6, 3, 0, 4, 6))), block(6, 0, 0, 3, 6));
}

TEST(Select, ABallStaysConnected) {
    const mesh::QuadMesh mesh = grid(6, 6);
    EXPECT_EQ(ball(mesh, {3, 3, 0}, 0.8, none), block(6, 2, 2, 4, 4));
    EXPECT_TRUE(ball(mesh, {3, 3, 5}, 0.8, none).empty());
    // A taken column splits what is within the radius; the side of the nearest face stays.
    EXPECT_EQ(ball(mesh, {2.4, 2.5, 0}, 10, mark(mesh, block(6, 3, 0, 4, 6))), block(6, 0, 0, 3, 6));
}

TEST(Select, ABoxIsItsLargestPart) {
    const mesh::QuadMesh mesh = grid(6, 6);
    EXPECT_EQ(box(mesh, {1, 1, -1}, {3, 4, 1}, none), block(6, 1, 1, 3, 4));
    EXPECT_EQ(box(mesh, {0, 0, -1}, {6, 6, 1}, mark(mesh, block(6, 2, 0, 3, 6))), block(6, 3, 0, 6, 6));
    EXPECT_TRUE(box(mesh, {7, 7, -1}, {9, 9, 1}, none).empty());
}

} // namespace
} // namespace alphamst::patch
