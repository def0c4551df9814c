#include "surface/angle.h"
#include "surface/boundary_curve.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// A rectangle of 4 x 2, and a triangle far away.
BoundaryCurves rectangle_and_triangle() {
    return BoundaryCurves(
        {{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}}, {{10, 0, 0}, {13, 0, 0}, {10, 4, 0}}});
}

TEST(BoundaryCurve, PlacesAreLengths) {
    const BoundaryCurves curves = rectangle_and_triangle();
    EXPECT_EQ(curves.count(), 2);
    EXPECT_DOUBLE_EQ(curves.length(0), 12);
    EXPECT_DOUBLE_EQ(curves.length(1), 12);
    EXPECT_DOUBLE_EQ(curves.extent(), 12);
    EXPECT_EQ(curves.at({0, 5}), Vector3d(4, 1, 0));
    EXPECT_EQ(curves.at({0, 11.5}), Vector3d(0, 0.5, 0));
    EXPECT_EQ(curves.at({1, 3}), Vector3d(13, 0, 0));
}

TEST(BoundaryCurve, PointsAreFoundWhereTheyAre) {
    const BoundaryCurves curves = rectangle_and_triangle();
    for (const CurvePlace place :
         {CurvePlace{0, 0}, CurvePlace{0, 4}, CurvePlace{0, 7.25}, CurvePlace{1, 11.5}}) {
        const CurvePlace found = curves.find(curves.at(place), 1e-9);
        EXPECT_EQ(found.curve, place.curve);
        EXPECT_NEAR(found.along, place.along, 1e-12);
    }
    EXPECT_LT(curves.find({2, 0.1, 0}, 1e-9).curve, 0);
    EXPECT_EQ(curves.find({2, 0.1, 0}, 0.2).curve, 0);
}

// Both sides of a slit are as near.
TEST(BoundaryCurve, WhatIsNotOnePlaceIsNone) {
    const BoundaryCurves slit(
        {{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {2, 1, 0}, {4, 1, 0}, {4, 2, 0}, {0, 2, 0}}});
    EXPECT_LT(slit.find({3, 1, 0}, 1e-9).curve, 0);
    EXPECT_EQ(slit.find({1, 0, 0}, 1e-9).curve, 0);
}

TEST(BoundaryCurve, WaysGoAround) {
    const BoundaryCurves curves = rectangle_and_triangle();
    EXPECT_DOUBLE_EQ(curves.way({0, 1}, {0, 3}), 2);
    EXPECT_DOUBLE_EQ(curves.way({0, 11}, {0, 1}), 2);
    EXPECT_DOUBLE_EQ(curves.way({0, 3}, {0, 3}), 12);
    EXPECT_NEAR(curves.advance({0, 11}, 2).along, 1, 1e-12);
    const auto bends = curves.between({0, 3}, 10);
    ASSERT_EQ(bends.size(), 4u); // three corners and the first point again
    EXPECT_EQ(bends[0].point, Vector3d(4, 0, 0));
    EXPECT_EQ(bends[3].point, Vector3d(0, 0, 0));
    for (const auto &bend : bends)
        EXPECT_NEAR(bend.turn, 90, 1e-9);
    EXPECT_NEAR(bends[3].along, 9, 1e-12);
    EXPECT_TRUE(curves.between({0, 1}, 2).empty());
}

// A thin spit: the line that cuts a piece off one side comes near the other.
TEST(BoundaryCurve, OtherPartsAreNearAcrossASpit) {
    const BoundaryCurves spit({{{0, 0, 0}, {10, 0, 0}, {10, 0.1, 0}, {0, 0.1, 0}}});
    EXPECT_TRUE(spit.others_near({0, 3}, 1, 0.2));
    EXPECT_FALSE(spit.others_near({0, 3}, 1, 0.05));
}

TEST(BoundaryCurve, AnglesBetweenDirections) {
    EXPECT_NEAR(degrees_between({1, 0, 0}, {0, 2, 0}), 90, 1e-12);
    EXPECT_NEAR(degrees_between({1, 0, 0}, {-3, 0, 0}), 180, 1e-12);
    EXPECT_EQ(degrees_between({0, 0, 0}, {1, 0, 0}), 0);
}

} // namespace
} // namespace alphamst::surface
