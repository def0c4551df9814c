#include "patch/patches.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::grid;
using testing::Groups;
using testing::none;

// Parts of equal size, which clusters do not promise.
TEST(Partition, PartsAreOfOneSize) {
    for (const mesh::QuadMesh &mesh : {grid(40, 40), testing::graded(), testing::cube(16)}) {
        const Groups parts = partition(mesh, 100, 1, none);
        EXPECT_EQ(static_cast<double>(parts.size()), std::round(mesh.n_faces() / 100.0));
        for (const auto &part : parts)
            EXPECT_NEAR(static_cast<double>(part.size()), 100, 10);
    }
}

// On a grid the best parts are squares: 2 * 4 * 40 edges between 25 of them.
TEST(Partition, FewEdgesAreCut) {
    const mesh::QuadMesh mesh = grid(50, 50);
    const Groups parts = partition(mesh, 100, 3, none);
    ASSERT_EQ(parts.size(), 25U);
    std::vector<std::size_t> part(at(mesh.n_faces()));
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (const int face : parts[p])
            part[at(face)] = p;
    int cut = 0;
    for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 50; ++i) {
            const std::size_t here = part[at(50 * j + i)];
            cut += i > 0 && part[at(50 * j + i - 1)] != here;
            cut += j > 0 && part[at(50 * j + i - 50)] != here;
        }
    EXPECT_LE(cut, 400 * 1.15);
}

TEST(Partition, OnePartIsTheWhole) {
    const mesh::QuadMesh mesh = grid(12, 9);
    EXPECT_EQ(partition(mesh, 200, 1, none), Groups{testing::block(12, 0, 0, 12, 9)});
}

// Parts of a few faces could not always be connected and of one size.
TEST(Partition, SmallPartsAreClusters) {
    const mesh::QuadMesh mesh = grid(20, 20);
    EXPECT_EQ(partition(mesh, 6, 4, none), clusters(mesh, 6, 4, none));
    EXPECT_NE(partition(mesh, 50, 4, none), clusters(mesh, 50, 4, none));
}

} // namespace
} // namespace alphamst::patch
