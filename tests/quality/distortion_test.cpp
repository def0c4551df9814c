#include <gtest/gtest.h>

#include "quality/element.h"

namespace alphamst::quality {
namespace {

double distortion_of(const Corners &quad) { return distortion(Element(quad)); }

TEST(Distortion, OfParallelogramsIsOne) {
    for (const double shear : {0.0, 0.7, 3.0})
        for (const double height : {0.2, 1.0, 5.0}) {
            const Corners flat = {{{0, 0, 0}, {1, 0, 0}, {1 + shear, height, 0}, {shear, height, 0}}};
            EXPECT_NEAR(distortion_of(flat), 1, 1e-12);
            Corners upright;
            for (std::size_t k = 0; k < 4; ++k)
                upright[k] = {flat[k].y(), 2, flat[k].x()};
            EXPECT_NEAR(distortion_of(upright), 1, 1e-12);
        }
}

// In the plane: four times the smallest determinant, which is at a corner, over the area.
TEST(Distortion, OfFlatConvexQuadsIsThatOfTheSmallestCorner) {
    // Sides of 4 and 2.5, 1.5 apart.
    EXPECT_NEAR(distortion_of({{{0, 0, 0}, {4, 0, 0}, {3, 1.5, 0}, {0.5, 1.5, 0}}}), 2.5 * 1.5 / 4.875,
                1e-12);
    EXPECT_NEAR(distortion_of({{{0, 0, 0}, {1, 0, 0}, {3, 2, 0}, {0, 1, 0}}}), 1 / 2.5, 1e-12);
}

TEST(Distortion, IsNegativeWhereACornerIsConcave) {
    EXPECT_LT(distortion_of({{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}}), 0);
}

TEST(Distortion, OfTrianglesIsTwoAndOfNothingNone) {
    EXPECT_EQ(distortion_of({{{0, 0, 0}, {3, 0, 0}, {1, 2, 0}, {1, 2, 0}}}), 2);
    EXPECT_EQ(distortion_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 0}}}), 0);
    EXPECT_EQ(distortion_of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}}), 0);
}

// Bent up at one corner by and by.
TEST(Distortion, FallsWithTheTwist) {
    double before = 1 + 1e-12;
    for (const double height : {0.0, 0.3, 0.6, 0.9}) {
        const double here = distortion_of({{{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}}});
        EXPECT_LT(here, before);
        EXPECT_GT(here, 0);
        before = here;
    }
}

} // namespace
} // namespace alphamst::quality
