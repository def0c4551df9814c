#include "geometry/feature_line.h"

#include <gtest/gtest.h>

#include "roof.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(FeatureLine, VerticesOffCentreSlideToTheCentre) {
    for (const double degrees : {0.0, 20.0, 45.0, 70.0})
        for (const double power : {1.5, 3.0}) {
            Roof roof(degrees, power);
            const Roof before = roof;
            const Judgement judgement = roof.improve(200);
            EXPECT_GT(std::abs(before.ridge(4).y() - 4), 1) << degrees;
            for (int j = 0; j <= along; ++j) {
                EXPECT_NEAR(roof.ridge(j).y(), j, 0.1) << degrees << " " << j;
                EXPECT_EQ(roof.ridge(j).x(), 0);
                EXPECT_EQ(roof.ridge(j).z(), 0);
            }
            EXPECT_TRUE(judgement.valid ||
                        degrees == 70); // against the other side's normals it is hard to be
            for (std::size_t v = 0; v < roof.fixed.size(); ++v)
                if (roof.fixed[v]) {
                    EXPECT_EQ(roof.on_surface.points[v], before.on_surface.points[v]);
                }
        }
}

// Whatever the shapes want: with hardly any room, or with a neighbour that is in the way.
TEST(FeatureLine, VerticesNeverPassTheirNeighbours) {
    for (int steps = 1; steps < 30; ++steps) {
        Roof roof(45, 8);
        roof.improve(steps);
        for (int j = 1; j <= along; ++j)
            EXPECT_LT(roof.ridge(j - 1).y(), roof.ridge(j).y());
    }
    Roof roof(30, 1);
    for (int j = 1; j < along; ++j)
        if (j != 4) {
            roof.fixed[at(vertex(2, j))] = 1;
            roof.feature_lines[at(vertex(2, j))] = {};
        }
    // The neighbours, fixed, are where they should not be: the quads there are inverted.
    roof.on_surface.put(vertex(2, 3), roof.surface->nearest({0, 5.5, 0}));
    roof.on_surface.put(vertex(2, 4), roof.surface->nearest({0, 5.6, 0}));
    roof.on_surface.put(vertex(2, 5), roof.surface->nearest({0, 5.7, 0}));
    roof.improve();
    EXPECT_GT(roof.ridge(4).y(), 5.5);
    EXPECT_LT(roof.ridge(4).y(), 5.7);
}

TEST(FeatureLine, HoldsWhatIsStrictlyBetween) {
    const std::vector<Vector3d> points{{2, 0, 0}, {4, 0, 0}};
    const surface::Line line{{0, 0, 0}, {10, 0, 0}};
    for (const FeatureLine &feature_line : {FeatureLine{{line}, {0, 1}}, FeatureLine{{line}, {1, 0}}}) {
        EXPECT_TRUE(feature_line);
        EXPECT_TRUE(feature_line.holds({3, 0, 0}, points));
        EXPECT_FALSE(feature_line.holds({2, 0, 0}, points));
        EXPECT_FALSE(feature_line.holds({4, 0, 0}, points));
        EXPECT_FALSE(feature_line.holds({5, 0, 0}, points));
        EXPECT_FALSE(feature_line.holds({1, 0, 0}, points));
    }
    EXPECT_FALSE(FeatureLine{});
}

TEST(FeatureLine, GoesAroundBendsThatEdgesDoNotMiss) {
    const std::vector<surface::Line> lines{{{0, 0, 0}, {4, 0, 0}}, {{4, 0, 0}, {8, 2, 0}}};
    const std::vector<Vector3d> points{{2, 0, 0}, {6, 1, 0}};
    FeatureLine line{lines, {0, 1}, 0.12};
    EXPECT_EQ(line.place({3, -1, 0}), 0.75);
    EXPECT_EQ(line.at(0.75), Vector3d(3, 0, 0));
    EXPECT_EQ(line.at(1.5), Vector3d(6, 1, 0));
    EXPECT_NEAR(line.place({6, 1, 3}), 1.5, 1e-14);
    EXPECT_TRUE(line.holds({4, 0, 0}, points));
    EXPECT_TRUE(line.holds({3, 0, 0}, points)); // the bend is .1 of the other edge off it
    EXPECT_FALSE(line.holds({6.4, 1.2, 0}, points));
    line.tolerance = 0.05;
    EXPECT_TRUE(line.holds({3.9, 0, 0}, points));
    EXPECT_FALSE(line.holds({3, 0, 0}, points));
}

} // namespace
} // namespace alphamst::geometry
