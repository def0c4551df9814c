#include "quadrangulate/joining.h"

#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

// A square in two triangles.
struct Square {
    std::vector<std::int32_t> faces{0, 1, 2, -1, 2, 3, 0, -1};
    TriangleSides sides{{-1, -1, 6, -1, -1, -1, 2, -1}, std::vector<Bar>(8, Bar::none), {}};
    Pairing pairing;
    QuadArrays quads;

    Square() { quads.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}; }
    std::vector<Edge> run(std::vector<std::int32_t> given = {}) {
        pairing.choices.resize(2);
        return join({faces, {}, given, sides, pairing}, quads);
    }
};

TEST(Joining, Merges) {
    Square square;
    square.pairing.choices = {{Choice::Kind::merge, 2, 1}, {Choice::Kind::merge, 2, 0}};
    EXPECT_TRUE(square.run().empty());
    EXPECT_EQ(square.quads.faces, (std::vector<std::int32_t>{2, 3, 0, 1}));
    EXPECT_TRUE(square.quads.crossed.empty());
}

TEST(Joining, SaysWhatItCrossed) {
    Square square;
    square.sides.bars[2] = square.sides.bars[6] = Bar::crease;
    square.pairing.choices = {{Choice::Kind::merge, 2, 1}, {Choice::Kind::merge, 2, 0}};
    square.run();
    EXPECT_EQ(square.quads.crossed, (std::vector<Edge>{{2, 0}}));
}

TEST(Joining, AQuadThatWasCutIsAsItWas) {
    Square square;
    square.sides.diagonals = {false, false, true, false, false, false, true, false};
    square.pairing.choices = {{Choice::Kind::merge, 2, 1}, {Choice::Kind::merge, 2, 0}};
    square.run({1, 2, 3, 0});
    EXPECT_EQ(square.quads.faces, (std::vector<std::int32_t>{1, 2, 3, 0}));
}

TEST(Joining, HalvesACommonSideOnce) {
    Square square;
    square.pairing.choices = {{Choice::Kind::halve, 2, 1}, {Choice::Kind::halve, 2, 0}};
    EXPECT_EQ(square.run().size(), 2U);
    EXPECT_EQ(square.quads.midpoints.size(), 1U);
    EXPECT_EQ(square.quads.origin.size(), 2U);
}

TEST(Joining, Splits) {
    Square square;
    square.pairing.choices = {{Choice::Kind::split, 0, -1}, {Choice::Kind::split, 0, -1}};
    square.run();
    EXPECT_EQ(square.quads.midpoints.size(), 5U);
    EXPECT_EQ(square.quads.origin, (std::vector<std::int32_t>{0, 0, 0, 1, 1, 1}));
}

} // namespace
} // namespace alphamst::quadrangulate
