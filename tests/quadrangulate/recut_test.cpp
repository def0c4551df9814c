#include "quadrangulate/recut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace alphamst::quadrangulate {
namespace {

using Corners = std::array<std::int32_t, 4>;
using Faces = std::set<Corners>; // each from its smallest corner on

// The triangle a b c with the midpoint m of its side a b, and a quad b x y c beyond the side b c.
enum : std::int32_t { a, m, b, x, y, c };

struct Hexagon {
    std::vector<double> points;
    std::vector<std::int32_t> markers;
    std::vector<std::array<std::int32_t, 2>> curves;
    std::vector<bool> on_boundary{false, true, false, false, false, false};

    // With y and c there.
    explicit Hexagon(std::array<double, 2> py = {1, 1}, std::array<double, 2> pc = {0, 1})
        : points{0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, py[0], py[1], 0, pc[0], pc[1], 0} {}

    Faces recut() const {
        QuadArrays quads;
        quads.points = points;
        quads.faces = {a, m, b, c, c, b, x, y};
        quads.origin = {0, 1};
        const Polygons polygons{points, {}, markers, curves};
        quadrangulate::recut(quads, polygons, std::vector<std::array<std::int32_t, 2>>{{a, m}}, on_boundary);
        EXPECT_EQ(quads.origin, (std::vector<std::int32_t>{0, 1}));
        Faces faces;
        for (std::size_t f = 0; f < 2; ++f) {
            Corners face;
            std::copy_n(quads.faces.begin() + static_cast<std::ptrdiff_t>(4 * f), 4, face.begin());
            std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
            faces.insert(face);
        }
        return faces;
    }
};

const Faces as_it_was{{a, m, b, c}, {b, x, y, c}}, from_the_midpoint{{a, m, y, c}, {m, b, x, y}};

TEST(Recut, CutsFromTheMidpointWhereThatIsBetter) { EXPECT_EQ(Hexagon().recut(), from_the_midpoint); }

TEST(Recut, CurvesAndBordersOfRegionsStay) {
    Hexagon hexagon;
    hexagon.curves = {{c, b}};
    EXPECT_EQ(hexagon.recut(), as_it_was);
    hexagon.curves = {{x, b}};
    EXPECT_EQ(hexagon.recut(), from_the_midpoint);
    hexagon.markers = {1, 2};
    EXPECT_EQ(hexagon.recut(), as_it_was);
    hexagon.markers = {2, 2};
    EXPECT_EQ(hexagon.recut(), from_the_midpoint);
}

// The hexagon is concave at c, and so is a quad of it then: worse than a flat corner that can still move.
TEST(Recut, AFlatCornerInsideCountsForBetterThanOneOnTheBoundary) {
    Hexagon hexagon({0.2, 1}, {1, 0.3});
    EXPECT_EQ(hexagon.recut(), from_the_midpoint);
    hexagon.on_boundary[m] = false;
    EXPECT_EQ(hexagon.recut(), as_it_was);
}

} // namespace
} // namespace alphamst::quadrangulate
