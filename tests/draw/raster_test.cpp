#include "draw/raster.h"

#include <gtest/gtest.h>

namespace alphamst::draw {
namespace {

// Two unit squares over the corner of one of side 4, at half its depth and twice.
struct Squares {
    io::Arrays mesh;
    std::vector<Vector3> points{{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}, {0, 0, 1}, {1, 0, 1},
                                {1, 1, 1}, {0, 1, 1}, {2, 2, 4}, {3, 2, 4}, {3, 3, 4}, {2, 3, 4}};
    Squares() { mesh.faces = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}; }
};

TEST(Raster, KnowsWhatIsNearest) {
    const Squares squares;
    const Raster raster(squares.mesh, squares.points, 4, 4, 0.125);
    EXPECT_EQ(raster.nearest(3), (std::vector{true, false, true}));
    EXPECT_EQ(raster.covered(), 33 * 33);
    EXPECT_TRUE(raster.shows({2.5, 2.5, 4}));
    EXPECT_FALSE(raster.shows({2.5, 2.5, 2}));
    EXPECT_TRUE(raster.shows({3.5, 3.5, 2}));
    EXPECT_FALSE(raster.shows({0.5, 0.5, 1}));
}

TEST(Raster, CoversWhatTheMeshCovers) {
    Squares squares;
    squares.points[2] = {0, 0, 2}; // a corner folded onto another: nothing
    const Raster raster(squares.mesh, squares.points, 4, 4, 0.125);
    EXPECT_EQ(raster.nearest(3), (std::vector{false, true, true}));
    EXPECT_EQ(raster.covered(), 2 * 9 * 9);
    EXPECT_TRUE(raster.shows({2, 0.5, -100})); // nothing is there
}

} // namespace
} // namespace alphamst::draw
