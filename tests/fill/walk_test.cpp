#include "fill/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fill/library.h"
#include "fill/start.h"

namespace {

using namespace alphamst::fill;

struct Place {
    const Layout *type;
    Sides sides;
    Multiplicities x;
};

// Places to walk from, on types that have moves.
std::vector<Place> places() {
    std::vector<Place> all;
    for (const Sides &sides :
         {Sides{12, 15, 10, 9}, {20, 11, 14, 13}, {18, 18, 18, 18}, {12, 13, 12, 11, 12}})
        for (const int singularities : {2, 3, 4})
            for (const Layout &type : types(static_cast<int>(sides.size()), singularities))
                if (const auto x = start(type, sides); x && !type.moves.empty())
                    all.push_back({&type, sides, *x});
    return all;
}

TEST(Walk, WhatItFindsFitsTheSidesAndIsInRange) {
    std::size_t found = 0, exact = 0;
    ASSERT_GT(places().size(), 3U);
    for (const Place &place : places())
        for (const int more : {-6, 0, 9}) {
            const std::int64_t wanted = face_count(*place.type, place.x) + more;
            const WalkQuery query{wanted - 4, wanted + 4, wanted, 40, 3};
            std::set<Multiplicities> seen;
            for (const Found &one : walk(*place.type, place.x, query)) {
                EXPECT_EQ(side_lengths(*place.type, one.x), place.sides);
                EXPECT_GE(*std::min_element(one.x.begin(), one.x.end()), 1);
                EXPECT_EQ(face_count(*place.type, one.x), one.faces);
                EXPECT_GE(one.faces, query.fewest_faces);
                EXPECT_LE(one.faces, query.most_faces);
                EXPECT_TRUE(seen.insert(one.x).second); // each once
                exact += one.faces == wanted;
                ++found;
            }
        }
    EXPECT_GT(found, 20U);
    EXPECT_GT(exact, 5U);
}

TEST(Walk, TheSameSeedWalksTheSameWay) {
    const Place place = places().front();
    const std::int64_t wanted = face_count(*place.type, place.x);
    const WalkQuery query{wanted - 10, wanted + 10, wanted, 40, 7};
    const auto a = walk(*place.type, place.x, query), b = walk(*place.type, place.x, query);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_FALSE(a.empty());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].x, b[i].x);
}

// A grid has one filling for given sides.
TEST(Walk, WithoutMovesThereIsWhereItStands) {
    const Layout &grid = types(4, 0).front();
    ASSERT_TRUE(grid.moves.empty());
    const Multiplicities x = *start(grid, {5, 7, 5, 7});
    const auto here = walk(grid, x, {30, 40, 33, 40, 1});
    ASSERT_EQ(here.size(), 1U);
    EXPECT_EQ(here[0].faces, 35);
    EXPECT_TRUE(walk(grid, x, {36, 40, 36, 40, 1}).empty());
}

TEST(Walk, GoesNowhereFromFarAway) {
    const Place place = places().front();
    Multiplicities x = place.x;
    x[0] = 10001;
    const std::int64_t faces = face_count(*place.type, x);
    EXPECT_TRUE(walk(*place.type, x, {0, 2 * faces, faces, 40, 1}).empty());
    x[0] = 10000;
    const std::int64_t fewer = face_count(*place.type, x);
    EXPECT_FALSE(walk(*place.type, x, {0, 2 * fewer, fewer, 40, 1}).empty());
}

} // namespace
