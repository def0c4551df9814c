#include "quadrangulate/flat_sides.h"

#include "bodies.h"
#include "quadrangulate/bars.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

TriangleSides sides_of(const Input &input) {
    TriangleSides sides{across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points())), {}, {}};
    sides.bars = bars_of(input.polygons(), input.faces, {}, sides.across, 40);
    return sides;
}

TEST(FlatSides, EvenOnesStay) {
    const Input body = box(1, 2, 3, false);
    TriangleSides sides = sides_of(body);
    const std::vector<Bar> before = sides.bars;
    unite_odd_sides(body.points, body.faces, sides);
    EXPECT_EQ(sides.bars, before);
}

// Each side of an octahedron is one triangle.
TEST(FlatSides, OddOnesAreUnited) {
    const Input body = octahedron();
    TriangleSides sides = sides_of(body);
    EXPECT_EQ(std::count(sides.bars.begin(), sides.bars.end(), Bar::sharp), 24);
    unite_odd_sides(body.points, body.faces, sides);
    EXPECT_EQ(std::count(sides.bars.begin(), sides.bars.end(), Bar::crease), 8);
}

// The edges of a tetrahedron are too sharp for quads.
TEST(FlatSides, NotOverEdgesTooSharp) {
    Input body;
    body.points = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    body.add(0, 1, 3);
    body.add(0, 2, 1);
    body.add(0, 3, 2);
    body.add(1, 2, 3);
    TriangleSides sides = sides_of(body);
    unite_odd_sides(body.points, body.faces, sides);
    EXPECT_EQ(std::count(sides.bars.begin(), sides.bars.end(), Bar::sharp), 12);
}

// An open box without its top, one side with a triangle less: the vertex on the boundary is for that side.
TEST(FlatSides, OneAtTheBoundaryIsExcused) {
    Input body = box(1, 1, 1, false);
    body.faces.resize(body.faces.size() - 4);
    TriangleSides sides = sides_of(body);
    unite_odd_sides(body.points, body.faces, sides);
    EXPECT_EQ(std::count(sides.bars.begin(), sides.bars.end(), Bar::crease), 0);
}

} // namespace
} // namespace alphamst::quadrangulate
