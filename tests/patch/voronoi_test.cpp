#include "patch/patches.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::block;
using testing::graded;
using testing::grid;
using testing::Groups;
using testing::none;

TEST(Voronoi, AsManyFacesWhereTheMeshIsFineAsWhereItIsCoarse) {
    const mesh::QuadMesh mesh = graded();
    const Groups cells = voronoi_cells(mesh, 64, 5, none);
    EXPECT_EQ(cells.size(), 25U);
    for (const auto &cell : cells) {
        EXPECT_GE(cell.size(), 13U);
        EXPECT_LE(cell.size(), 192U);
    }
}

TEST(Voronoi, TheSeedMovesTheCells) {
    const mesh::QuadMesh mesh = grid(30, 30);
    EXPECT_NE(voronoi_cells(mesh, 60, 1, none), voronoi_cells(mesh, 60, 2, none));
}

// Two centres in a strip: the second is at the end that is farther from the first, and the
// border in the middle between them.
TEST(Voronoi, FarthestPointsAndTheirBisector) {
    const mesh::QuadMesh mesh = grid(30, 1);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Groups cells = voronoi_cells(mesh, 15, seed, none);
        ASSERT_EQ(cells.size(), 2U);
        const int first = static_cast<int>(std::mt19937_64(seed)() % 30), second = first < 15 ? 29 : 0;
        const int border = std::abs(first - second) % 2 ? (first + second - 1) / 2 : -1;
        if (border < 0) // a face in the middle, as near to one as to the other
            continue;
        const auto &low = cells[0].front() == 0 ? cells[0] : cells[1];
        EXPECT_EQ(low, block(30, 0, 0, border + 1, 1)) << "seed " << seed;
    }
}

} // namespace
} // namespace alphamst::patch
