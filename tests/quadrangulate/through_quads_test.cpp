#include "quadrangulate/through_quads.h"

#include "quadrangulate/halve.h"
#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

// A strip of nx quads, ny high, with the first and the last one of its lowest row cut in two, of which one
// half each is missing: a triangle is left over at either end.
Input strip(int nx, int ny, bool falling = false) {
    Input input;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            input.points.insert(input.points.end(), {double(i), double(j), 0});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 2, d = a + nx + 1;
            if (j == 0 && i == 0)
                input.add(falling ? d : a, b, c);
            else if (j == 0 && i == nx - 1)
                input.add(a, falling ? b : c, d);
            else
                input.add(a, b, c, d);
        }
    return input;
}

Paired pair_once(const Input &input) {
    Paired paired;
    paired.sides.across = across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points()));
    paired.sides.bars.assign(input.faces.size(), Bar::none);
    paired.pairing = pair_triangles(input.points, input.faces, paired.sides, true);
    return paired;
}

// Each triangle is in a cross, or has a mate that has it, across a side of both, and is in the face that it
// comes from.
void expect_consistent(const Input &input, const Paired &paired) {
    const Cut &cut = paired.cut;
    for (std::size_t t = 0; t < cut.origin.size(); ++t) {
        const Choice &choice = paired.pairing.choices[t];
        if (choice.kind == Choice::Kind::cross) {
            const std::array<std::int32_t, 4> &faces = paired.pairing.crosses[std::size_t(choice.mate)].faces;
            EXPECT_EQ(std::count(faces.begin(), faces.end(), std::int32_t(t)), 1);
            continue;
        }
        ASSERT_EQ(choice.kind, Choice::Kind::merge) << t;
        const std::size_t c = 4 * t + std::size_t(choice.side);
        const std::int32_t beyond = paired.sides.across[c];
        ASSERT_EQ(beyond / 4, choice.mate);
        EXPECT_EQ(paired.sides.across[std::size_t(beyond)], std::int32_t(c));
        EXPECT_EQ(paired.pairing.choices[std::size_t(choice.mate)].mate, std::int32_t(t));
        EXPECT_EQ(cut.faces[c], cut.faces[mesh::next_corner(cut.faces, std::size_t(beyond))]);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(std::count(input.faces.begin() + 4 * cut.origin[t],
                                 input.faces.begin() + 4 * cut.origin[t] + 4, cut.faces[4 * t + k]),
                      1);
    }
}

TEST(ThroughQuads, TrianglesFarApart) {
    for (const auto &[nx, falling] : {std::pair{5, false}, {3, true}, {60, false}}) {
        const Input input = strip(nx, 2, falling);
        Paired paired = pair_once(input);
        ASSERT_EQ(paired.pairing.poor.size(), 2U);
        pair_through_quads(input.polygons(), true, paired);
        EXPECT_TRUE(paired.pairing.poor.empty()) << nx;
        expect_consistent(input, paired);
    }
}

// What is nowhere near stays as it was given.
TEST(ThroughQuads, TheRestStays) {
    const Input input = strip(4, 60);
    Paired paired = pair_once(input);
    pair_through_quads(input.polygons(), true, paired);
    EXPECT_TRUE(paired.pairing.poor.empty());
    const std::size_t far = input.n_faces() - 4;
    for (std::size_t t = 0; t < paired.cut.origin.size(); ++t)
        if (std::size_t(paired.cut.origin[t]) >= far) {
            EXPECT_TRUE(paired.cut.diagonals[4 * t + std::size_t(paired.pairing.choices[t].side)]);
        }
}

// With a third one, one of them gets a vertex on the boundary, if it may and none has one.
TEST(ThroughQuads, OneLeavesOfAnOddNumber) {
    Input input = strip(9, 6);
    const auto n = static_cast<std::int32_t>(input.n_points());
    input.points.insert(input.points.end(), {4.5, 7, 0});
    input.add(6 * 10 + 5, n, 6 * 10 + 4);
    for (const auto &[before, after] : {std::pair{true, true}, {false, true}, {false, false}}) {
        Paired paired = pair_once(input);
        if (!before)
            paired.pairing = pair_triangles(input.points, input.faces, paired.sides, false);
        pair_through_quads(input.polygons(), after, paired);
        std::size_t exits = 0;
        for (const Choice &choice : paired.pairing.choices)
            exits += choice.kind == Choice::Kind::halve && choice.mate < 0;
        EXPECT_EQ(exits, after ? 1U : 0U) << before;
    }
}

} // namespace
} // namespace alphamst::quadrangulate
