#include "mesh/sides.h"

#include <gtest/gtest.h>

#include <limits>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Ids = std::vector<std::int32_t>;

// A square and a triangle on its right.
const Ids mixed{0, 1, 2, 3, 1, 4, 2, -1};

TEST(Sides, ATriangleHasThree) {
    EXPECT_FALSE(is_triangle(mixed, 0));
    EXPECT_TRUE(is_triangle(mixed, 1));
    EXPECT_TRUE(any_triangle(mixed));
    EXPECT_FALSE(any_triangle(Ids{0, 1, 2, 3}));
    const std::vector<std::size_t> next{1, 2, 3, 0, 5, 6, 4};
    for (std::size_t c = 0; c < next.size(); ++c)
        EXPECT_EQ(next_corner(mixed, c), next[c]);
}

TEST(Sides, ArraysHaveWholeRows) {
    const std::vector<double> points(12);
    EXPECT_NO_THROW(test_lengths(2, points, mixed));
    EXPECT_NO_THROW(test_lengths(3, {}, {}));
    EXPECT_EQ(failure_of([&] { test_lengths(4, points, mixed); }).fault, Fault::argument);
    EXPECT_EQ(failure_of([&] { test_lengths(3, std::vector<double>(13), mixed); }).fault, Fault::argument);
    EXPECT_EQ(failure_of([&] { test_lengths(3, points, Ids{0, 1, 2}); }).fault, Fault::argument);
}

TEST(Sides, CoordinatesAreFinite) {
    std::vector<double> points(12);
    EXPECT_NO_THROW(test_arrays(points, {}, true));
    for (const double bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        points[7] = bad;
        const Failure failure = failure_of([&] { test_arrays(points, {}, true); });
        EXPECT_EQ(failure.fault, Fault::not_finite);
        EXPECT_EQ(failure.entity, Entity::vertex);
        EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{2}));
    }
}

TEST(Sides, CoordinatesAreWithinReach) {
    std::vector<double> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const auto scaled = [&](double factor) {
        std::vector<double> result = points;
        for (double &x : result)
            x *= factor;
        return result;
    };
    for (const double factor : {1e-30, 1e-12, 1e12, 1e30, 0.0})
        EXPECT_NO_THROW(test_points(scaled(factor)));
    EXPECT_EQ(failure_of([&] { test_points(scaled(1e-31)); }).fault, Fault::range);
    const Failure failure = failure_of([&] { test_points(scaled(-1e31)); });
    EXPECT_EQ(failure.fault, Fault::range);
    EXPECT_EQ(failure.entity, Entity::vertex);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{1}));
}

TEST(Sides, CornersAreDifferentVerticesOfTheMesh) {
    const std::vector<double> points(15);
    EXPECT_NO_THROW(test_arrays(points, mixed, true));
    const auto fault = [&](const Ids &faces, bool triangles) {
        return failure_of([&] { test_arrays(points, faces, triangles); }).fault;
    };
    EXPECT_EQ(fault(mixed, false), Fault::range); // -1 is a corner then
    EXPECT_EQ(fault({0, 1, 2, 5}, true), Fault::range);
    EXPECT_EQ(fault({0, -1, 2, 3}, true), Fault::range);
    EXPECT_EQ(fault({0, 1, 2, 1}, true), Fault::not_quad);
    EXPECT_EQ(fault({0, 1, 0, -1}, true), Fault::not_quad);
}

// Edges in ascending order: 01 03 12 14 23 24.
TEST(Sides, PairedOnesAreOneEdge) {
    const Halfedges halfedges = pair_sides(mixed, 5);
    EXPECT_EQ(halfedges.n_edges, 6u);
    EXPECT_EQ(halfedges.of_corner, (Ids{0, 4, 8, 3, 6, 11, 5, -1}));
}

TEST(Sides, AnEdgeHasTwoFacesThatRunItBothWays) {
    const Failure third = failure_of([] { pair_sides(Ids{0, 1, 2, 3, 1, 0, 4, 5, 0, 1, 6, 7}, 8); });
    EXPECT_EQ(third.fault, Fault::not_manifold);
    EXPECT_EQ(third.ids, (std::vector<std::int64_t>{2, 0, 1}));
    const Failure turned = failure_of([] { pair_sides(Ids{0, 1, 2, 3, 0, 1, 4, 5}, 6); });
    EXPECT_EQ(turned.fault, Fault::not_manifold);
    EXPECT_EQ(turned.ids, (std::vector<std::int64_t>{1, 0, 0, 1}));
}

} // namespace
} // namespace alphamst::mesh
