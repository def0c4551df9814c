#include "quality/element.h"

#include <gtest/gtest.h>

#include <limits>

namespace alphamst::quality {
namespace {

// 3 by 4: the diagonal is 5.
const Corners rectangle = {{{1, 1, 2}, {4, 1, 2}, {4, 5, 2}, {1, 5, 2}}};

TEST(Element, IsInUnitsOfItsBox) {
    const Element e(rectangle);
    EXPECT_DOUBLE_EQ(e.size, 5);
    const double lengths[] = {0.6, 0.8, 0.6, 0.8};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_DOUBLE_EQ(e.length[k], lengths[k]);
        EXPECT_DOUBLE_EQ(e.corner_area[k], 0.48);
        EXPECT_LT((e.normal[k] - Vector(0, 0, 0.48)).norm(), 1e-15);
    }
    EXPECT_LT((e.edge[1] - Vector(0, 0.8, 0)).norm(), 1e-15);
    EXPECT_LT((e.diagonal[0] - Vector(0.6, 0.8, 0)).norm(), 1e-15);
    EXPECT_LT((e.diagonal[1] - Vector(-0.6, 0.8, 0)).norm(), 1e-15);
    EXPECT_LT((e.axis[0] - Vector(1.2, 0, 0)).norm(), 1e-15);
    EXPECT_LT((e.axis[1] - Vector(0, 1.6, 0)).norm(), 1e-15);
    EXPECT_DOUBLE_EQ(e.area(), 0.48);
    EXPECT_DOUBLE_EQ(e.shortest(), 0.6);
    EXPECT_DOUBLE_EQ(e.longest(), 0.8);
    EXPECT_FALSE(e.collapsed());
}

TEST(Element, AConcaveCornerHasNegativeArea) {
    const Element e({{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}});
    EXPECT_GT(e.corner_area[0], 0);
    EXPECT_LT(e.corner_area[2], 0);
    EXPECT_NEAR(e.area() * e.size * e.size, 1, 1e-12);
}

TEST(Element, ScaleDoesNotMatterDownToTheSmallest) {
    for (const double scale : {1e-250, 1e-12, 1e200}) {
        Corners quad = rectangle;
        for (auto &p : quad)
            p *= scale;
        const Element e(quad), unit(rectangle);
        EXPECT_NEAR(e.size / scale, 5, 1e-9);
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(e.length[k], unit.length[k], 1e-12);
    }
    const Corners point = {{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}};
    EXPECT_EQ(Element(point).size, 1); // nothing to divide by
}

TEST(Element, CollapsedIsATriangleOfTheFirstThreeCorners) {
    EXPECT_TRUE(Element({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}}).collapsed());
    EXPECT_FALSE(Element({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}).collapsed());
}

TEST(Element, UndefinedIsZeroOrTheLeast) {
    EXPECT_EQ(direction(Vector(0, tiny, 0)), Vector(0, 0, 0));
    EXPECT_LT((direction(Vector(0, 3, 4)) - Vector(0, 0.6, 0.8)).norm(), 1e-15);
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(bounded(infinite), huge);
    EXPECT_EQ(bounded(-infinite), -huge);
    EXPECT_EQ(bounded(std::numeric_limits<double>::quiet_NaN()), -huge);
    EXPECT_EQ(bounded(-0.5), -0.5);
}

} // namespace
} // namespace alphamst::quality
