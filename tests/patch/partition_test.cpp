#include "patch/patches.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::grid;
using testing::Groups;
using testing::none;

// Parts of equal size: what METIS is for, and clusters do not promise.
TEST(Partition, PartsAreOfOneSize) {
    for (const mesh::QuadMesh &mesh : {grid(40, 40), testing::graded(), testing::cube(16)}) {
        const Groups parts = partition(mesh, 100, 1, none);
        EXPECT_EQ(static_cast<double>(parts.size()), std::round(mesh.n_faces() / 100.0));
        for (const auto &part : parts)
            EXPECT_NEAR(static_cast<double>(part.size()), 100, 10);
    }
}

TEST(Partition, OnePartIsTheWhole) {
    const mesh::QuadMesh mesh = grid(12, 9);
    EXPECT_EQ(partition(mesh, 200, 1, none), Groups{testing::block(12, 0, 0, 12, 9)});
}

// Where parts are of a few faces METIS would leave some empty.
TEST(Partition, SmallPartsAreClusters) {
    const mesh::QuadMesh mesh = grid(20, 20);
    EXPECT_EQ(partition(mesh, 6, 4, none), clusters(mesh, 6, 4, none));
    EXPECT_NE(partition(mesh, 50, 4, none), clusters(mesh, 50, 4, none));
}

} // namespace
} // namespace alphamst::patch
