#include "draw/tint.h"

#include <gtest/gtest.h>

#include <limits>

namespace alphamst::draw {
namespace {

TEST(Tint, IsNearlyWhiteWhereSizesAreRight) {
    EXPECT_EQ(text_of(tint(0)), "#f7f7f7");
    EXPECT_EQ(tint(0.01), tint(0));
    EXPECT_EQ(tint(std::numeric_limits<double>::quiet_NaN()), tint(0));
}

TEST(Tint, IsTheStrongerTheFartherFromZero) {
    for (const double error : {0.5, 1.0, 1.5, 2.0}) {
        EXPECT_LT(tint(error)[1], tint(error - 0.5)[1]);
        EXPECT_LT(tint(-error)[1], tint(0.5 - error)[1]);
        EXPECT_GT(tint(error)[0], tint(error)[2]);   // red is too large
        EXPECT_LT(tint(-error)[0], tint(-error)[2]); // blue too small
    }
    EXPECT_EQ(tint(1e300), tint(strongest_error));
    EXPECT_EQ(tint(-std::numeric_limits<double>::infinity()), tint(-strongest_error));
}

TEST(Tint, MixesAndWritesColours) {
    EXPECT_EQ(text_of({0, 15, 255}), "#000fff");
    EXPECT_EQ(mix({0, 100, 200}, {100, 0, 200}, 0.25), (Colour{25, 75, 200}));
}

} // namespace
} // namespace alphamst::draw
