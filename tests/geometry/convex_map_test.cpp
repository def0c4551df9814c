#include "geometry/convex_map.h"

#include <gtest/gtest.h>

#include "sheet.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(ConvexMap, MeanValuesGiveARegularPolygonBack) {
    std::mt19937 random(2);
    const auto shift = [&] { return 0.02 * (2.0 * static_cast<double>(random()) / std::mt19937::max() - 1); };
    Sheet sheet(8, 8, [](double, double) { return Vector3d(0, 0, 0); });
    const std::vector<double> equal(at(sheet.boundary), 2 * pi / sheet.boundary); // circle of radius 1
    const Points even =
        embed_on_circle(sheet.quads, sheet.boundary, static_cast<int>(sheet.points.size()), equal);
    for (std::size_t v = 0; v < even.size(); ++v)
        sheet.points[v] = turned(even[v] + (v < equal.size() ? 0 : 1) * Vector2d(shift(), shift()));
    const Points positions = mean_value_on_circle(sheet.disk());
    // A polygon of the length of a circle has a larger one around it.
    expect_distances(positions, sheet.points, sheet.boundary * std::sin(pi / sheet.boundary) / pi);
    EXPECT_TRUE(bijective(sheet, positions));
}

TEST(ConvexMap, LowStretchStretchesLess) {
    for (const auto &[sheet, part] :
         {std::pair(pouch(1), 0.4), {pouch(2), 0.4}, {pouch(2.5), 0.4}, {bowl(12, 0.9), 0.8}}) {
        const Points round = mean_value_on_circle(sheet.disk()), low = low_stretch_on_circle(sheet.disk());
        ASSERT_TRUE(bijective(sheet, round));
        ASSERT_TRUE(bijective(sheet, low));
        for (std::size_t i = 0; i < at(sheet.boundary); ++i)
            EXPECT_EQ(low[i], round[i]);
        EXPECT_GE(stretch(sheet.disk(), low), 1);
        EXPECT_LT(stretch(sheet.disk(), low) - 1, part * (stretch(sheet.disk(), round) - 1));
    }
}

TEST(ConvexMap, LoopIsOnACircleSpacedByLength) {
    const Sheet sheet = bowl(12, 0.7);
    for (const Points &positions :
         {mean_value_on_circle(sheet.disk()), low_stretch_on_circle(sheet.disk())}) {
        ASSERT_EQ(positions.size(), sheet.points.size());
        double length = 0;
        for (std::size_t i = 0; i < at(sheet.boundary); ++i)
            length += (sheet.points[(i + 1) % at(sheet.boundary)] - sheet.points[i]).norm();
        for (std::size_t i = 0; i < at(sheet.boundary); ++i) {
            const Vector2d &p = positions[i], &next = positions[(i + 1) % at(sheet.boundary)];
            EXPECT_NEAR(p.norm(), length / (2 * pi), 1e-12);
            EXPECT_NEAR(std::asin((p.x() * next.y() - p.y() * next.x()) / p.squaredNorm()) * p.norm(),
                        (sheet.points[(i + 1) % at(sheet.boundary)] - sheet.points[i]).norm(), 1e-9);
        }
    }
}

TEST(ConvexMap, NoPositionsWithoutASolution) {
    const Sheet point(4, 4, [](double, double) { return Vector3d(1, 2, 3); });
    EXPECT_TRUE(mean_value_on_circle(point.disk()).empty());
    EXPECT_TRUE(low_stretch_on_circle(point.disk()).empty());
    Sheet pinched = bowl(12, 0.7);
    pinched.points.back() = pinched.points[pinched.points.size() - 2];
    EXPECT_TRUE(mean_value_on_circle(pinched.disk()).empty());
}

// The centre of a square with a neighbour at the middle of each side.
TEST(ConvexMap, AVertexOfLargeShareHasNoSay) {
    const Sheet sheet(2, 2, [](double s, double t) { return turned({s, t}); });
    ConvexMap map(sheet.disk());
    const Points even = map.solve();
    ASSERT_EQ(even.size(), 9U);
    EXPECT_LT(even[8].norm(), 1e-12);
    std::vector<double> share(9, 3.0);
    map.weigh_down(share); // the same for all
    EXPECT_LT(map.solve()[8].norm(), 1e-12);
    share[1] = 1e15;
    map.weigh_down(share);
    const Points uneven = map.solve();
    EXPECT_LT((uneven[8] - (uneven[3] + uneven[5] + uneven[7]) / 3).norm(), 1e-12);
    EXPECT_EQ(uneven[1], even[1]); // on the circle all the same
}

} // namespace
} // namespace alphamst::geometry
