#include "quadrangulate/pillow.h"

#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

QuadArrays one(std::vector<double> points) {
    QuadArrays quads;
    quads.points = std::move(points);
    quads.faces = {0, 1, 2, 3};
    quads.origin = {0};
    return quads;
}

TEST(Pillow, MendsFlatAndConcaveCorners) {
    for (const double x : {0.5, 0.55, 0.6}) { // the third corner is on the diagonal, or beyond
        QuadArrays quads = one({0, 0, 0, 1, 0, 0, 1 - x, 1 - x, 0, 0, 1, 0});
        EXPECT_LT(smallest_sine(quads), 0.01);
        pillow(quads, {false, false, true, false});
        EXPECT_EQ(quads.origin, (std::vector<std::int32_t>{0, 0, 0, 0, 0}));
        EXPECT_GT(smallest_sine(quads), 0.05) << x;
        EXPECT_EQ(quads.points.size(), 24U);
        EXPECT_NO_THROW(mesh::QuadMesh::build(2, quads.points, quads.faces).check());
    }
}

TEST(Pillow, LeavesWhatCanMoveOrIsConvex) {
    QuadArrays quads = one({0, 0, 0, 1, 0, 0, 0.5, 0.5, 0, 0, 1, 0});
    pillow(quads, {true, true, false, true});
    EXPECT_EQ(quads.origin.size(), 1U);
    quads = one({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    pillow(quads, {true, true, true, true});
    EXPECT_EQ(quads.origin.size(), 1U);
}

} // namespace
} // namespace alphamst::quadrangulate
