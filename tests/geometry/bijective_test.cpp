#include "geometry/parametrise.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sheet.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(Bijective, WhatLiesOnItselfIsFound) {
    const Sheet half = ramp(0.5), twice = ramp(1.5);
    EXPECT_TRUE(bijective(half, conformal(half.disk())));
    const Points folded = conformal(twice.disk());
    EXPECT_TRUE(shapes_of(twice.quads, folded).valid); // no quad alone tells
    EXPECT_FALSE(bijective(twice, folded));
    EXPECT_TRUE(bijective(twice, mean_value_on_circle(twice.disk())));
    EXPECT_TRUE(bijective(twice, low_stretch_on_circle(twice.disk())));
    // And a quad that is inverted, in a loop that is as it was.
    const Sheet sheet = flat(1);
    Points turned_over = conformal(sheet.disk());
    turned_over.back() = turned_over.front();
    EXPECT_FALSE(bijective(sheet, turned_over));
}

TEST(Bijective, SimpleLoops) {
    const auto simple = [](Points loop) {
        bool same = is_simple(loop);
        for (std::size_t i = 0; i < loop.size(); ++i) { // wherever it begins
            std::rotate(loop.begin(), loop.begin() + 1, loop.end());
            EXPECT_EQ(is_simple(loop), same);
        }
        return same;
    };
    EXPECT_TRUE(simple({{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_TRUE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}));
    EXPECT_TRUE(simple({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}})); // in line
    EXPECT_TRUE(simple({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {2, 3}, {0, 1}}));                 // likewise
    EXPECT_FALSE(simple({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));                                // crosses
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));                        // touches an edge
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));                // at a vertex
    EXPECT_FALSE(simple({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));                                // back on itself
    EXPECT_FALSE(simple({{0, 0}, {1, 0}}));
}

} // namespace
} // namespace alphamst::geometry
