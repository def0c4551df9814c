#include "smooth/settle.h"

#include <gtest/gtest.h>

#include "geometry/square.h"

namespace alphamst::smooth {
namespace {

using geometry::samples::noisy;
using geometry::samples::Square;

// Half of the wanted areas on the left: the columns there get narrower, and the border stays.
TEST(Settle, BringsAreasToWhereTheyAreWanted) {
    const Square square = noisy(12, 0, 1);
    geometry::Points positions = square.points;
    const auto wanted = [&](const geometry::Points &now) {
        std::vector<double> areas;
        for (const auto &q : square.quads)
            areas.push_back(1 + now[static_cast<std::size_t>(q[0])].x() / 6);
        return areas;
    };
    settle(square.quads, square.fixed, positions, wanted, 0.7, 0.5, {});
    const int middle = 13 * 6 + 6;
    EXPECT_LT(positions[middle].x(), square.points[middle].x() - 0.3);
    EXPECT_TRUE(geometry::shapes_of(square.quads, positions).valid);
    EXPECT_GE(geometry::shapes_of(square.quads, positions).min_scaled_jacobian, 0.5);
    for (std::size_t v = 0; v < positions.size(); ++v)
        if (square.fixed[v]) {
            EXPECT_EQ(positions[v], square.points[v]);
        }
}

// What is asked for cannot be had without flat corners: it comes as near as it may.
TEST(Settle, ClosesNoCorner) {
    const Square square = noisy(8, 0.3, 2);
    geometry::Points positions = square.points;
    const auto wanted = [&](const geometry::Points &) {
        std::vector<double> areas(square.quads.size(), 1);
        for (std::size_t q = 0; q < areas.size(); q += 3)
            areas[q] = 30;
        return areas;
    };
    const auto before = [&](std::size_t q) {
        return geometry::shapes_of(geometry::Quads(&square.quads[q], 1), square.points).min_scaled_jacobian;
    };
    settle(square.quads, square.fixed, positions, wanted, 0.9, 0.6, {});
    for (std::size_t q = 0; q < square.quads.size(); ++q)
        EXPECT_GE(geometry::shapes_of(geometry::Quads(&square.quads[q], 1), positions).min_scaled_jacobian,
                  std::min(before(q), 0.6))
            << q;
}

TEST(Settle, LeavesWhatIsInverted) {
    const Square square = noisy(8, 1.5, 2);
    geometry::Points positions = square.points;
    settle(square.quads, square.fixed, positions,
           [&](const geometry::Points &) { return std::vector<double>(square.quads.size(), 1); }, 0.5, 0.5,
           {});
    EXPECT_EQ(positions, square.points);
}

// A step that spoils the quads of one vertex whenever that may move: it stays, and the others go.
TEST(ImproveWithoutSpoiling, HoldsWhatIsSpoiledAndGoesOnWithTheRest) {
    const Square square = noisy(4, 0, 1);
    std::vector<char> fixed = square.fixed;
    constexpr int bad = 6, good = 18; // of 5 by 5 vertices
    int calls = 0;
    const auto improve = [&](std::span<const char> held) {
        ++calls;
        geometry::Points moved = square.points;
        for (const int v : {bad, good})
            if (!held[static_cast<std::size_t>(v)])
                moved[static_cast<std::size_t>(v)].x() += 0.1;
        return moved;
    };
    const auto spoiled = [&](const geometry::Points &now) {
        return now[bad] != square.points[bad] ? std::vector{0} : std::vector<int>();
    };
    const auto improved = improve_without_spoiling(square.quads, fixed, improve, spoiled);
    ASSERT_TRUE(improved);
    EXPECT_EQ(calls, 2);
    EXPECT_EQ((*improved)[bad], square.points[bad]);
    EXPECT_NE((*improved)[good], square.points[good]);
    EXPECT_FALSE(improve_without_spoiling(square.quads, fixed, improve,
                                          [](const geometry::Points &) { return std::vector{0}; }));
}

} // namespace
} // namespace alphamst::smooth
