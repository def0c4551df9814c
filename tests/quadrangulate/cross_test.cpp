#include "quadrangulate/cross.h"

#include "bodies.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

TriangleSides open_sides(const Input &input) {
    TriangleSides sides{across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points())), {}, {}};
    sides.bars.assign(input.faces.size(), Bar::none);
    return sides;
}

TEST(Cross, AroundItsVertexOnly) {
    const Input body = box(1, 1, 1, true);
    const TriangleSides sides = open_sides(body);
    const Surroundings mesh{body.points, body.faces, sides};
    for (std::int32_t face = 0; face < std::int32_t(body.n_faces()); ++face) {
        EXPECT_FALSE(cross_around(mesh, 4 * face));
        const std::optional<Cross> cross = cross_around(mesh, 4 * face + 2);
        ASSERT_TRUE(cross);
        EXPECT_EQ(cross->faces[0], face / 4 * 4);
        EXPECT_GT(least_sine(body.points, cross->corners), 0.99);
    }
}

TEST(Cross, NotOverBarsNorWhereItIsBent) {
    Input body = box(1, 1, 1, true);
    TriangleSides sides = open_sides(body);
    sides.bars[1] = sides.bars[std::size_t(sides.across[1])] = Bar::sharp;
    EXPECT_FALSE(cross_around({body.points, body.faces, sides}, 2));
    EXPECT_TRUE(cross_around({body.points, body.faces, sides}, 4 * 4 + 2));
    const auto centre = std::size_t(body.faces[4 * 4 + 2]);
    for (std::size_t k = 0; k < 3; ++k)
        body.points[3 * centre + k] += 0.1;
    EXPECT_FALSE(cross_around({body.points, body.faces, sides}, 4 * 4 + 2));
}

TEST(Cross, OneLeadsToTheNext) {
    const Input body = box(2, 3, 4, true);
    const TriangleSides sides = open_sides(body);
    std::vector<bool> taken(body.n_faces());
    EXPECT_EQ(crosses_from({body.points, body.faces, sides}, {2}, taken).size(), body.n_faces() / 4);
    EXPECT_EQ(std::count(taken.begin(), taken.end(), false), 0);
    EXPECT_TRUE(crosses_from({body.points, body.faces, sides}, {2}, taken).empty());
}

} // namespace
} // namespace alphamst::quadrangulate
