#include "reference/indicator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "index.h"
#include "mesh/grids.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

constexpr int side = 40;

// A jump of 1 along the middle column of a square of unit squares, and a little everywhere.
std::vector<double> front(double little = 0) {
    std::vector<double> indicator(side * side, little);
    for (int j = 0; j < side; ++j)
        indicator[at(j * side + side / 2)] = 1;
    return indicator;
}

class Indicator : public testing::Test {
protected:
    const mesh::QuadMesh mesh = mesh::plane(side, side).build();
    SizeRules rules;

    Sizes sizes(const std::vector<double> &indicator, double tolerance, double faces) const {
        return sizes_from_indicator(mesh, indicator, tolerance, faces, rules);
    }
};

TEST_F(Indicator, EvenErrorsGiveEvenSizes) {
    for (const double error : {1e-200, 1e-3, 1.0, 1e200})
        for (const double faces : {100.0, 1600.0, 1e6}) {
            const Sizes found = sizes(std::vector<double>(side * side, error), 0, faces);
            EXPECT_NEAR(found.faces / faces, 1, 1e-3);
            const auto [least, largest] = std::ranges::minmax(found.of_vertex);
            EXPECT_EQ(least, largest);
            EXPECT_NEAR(least, side / std::sqrt(faces), 1e-3 * least);
        }
}

TEST_F(Indicator, TheOrderSaysHowMuchSmaller) {
    for (const double order : {1.0, 2.0, 3.0}) {
        rules.error_order = order;
        const Sizes found = sizes(std::vector<double>(side * side, 8), 1, 0);
        EXPECT_NEAR(found.of_vertex[0], std::pow(8, -1 / order), 1e-14);
    }
}

TEST_F(Indicator, SizesAreWithinTheirBounds) {
    rules.min_edge = 0.25;
    rules.max_edge = 3;
    const auto [least, largest] = std::ranges::minmax(sizes(front(), 1e-3, 0).of_vertex);
    EXPECT_EQ(least, 0.25);
    EXPECT_EQ(largest, 3);
}

TEST_F(Indicator, TheNumberOfFacesIsReached) {
    rules.min_edge = 0.05;
    rules.max_edge = 4;
    for (const double faces : {500.0, 2000.0, 20000.0, 60000.0})
        for (const double little : {0.0, 1e-6, 0.1})
            EXPECT_NEAR(sizes(front(little), 0, faces).faces / faces, 1, 1e-3) << faces << ' ' << little;
}

TEST_F(Indicator, TheNumberOfFacesIsALimit) {
    rules.min_edge = 0.05;
    rules.max_edge = 4;
    const double free = sizes(front(), 0.1, 0).faces;
    EXPECT_EQ(sizes(front(), 0.1, 2 * free).faces, free);
    EXPECT_NEAR(sizes(front(), 0.1, free / 2).faces, free / 2, free / 1000);
    // What the bounds do not allow is not reached, and is found out soon.
    rules.min_edge = 4;
    EXPECT_NEAR(sizes(front(), 0.1, 7).faces, 100, 1e-9);
    EXPECT_NEAR(sizes(front(), 0, 1000).faces, 100, 1e-9);
}

TEST_F(Indicator, LayersAroundTheFrontAreSmall) {
    rules.max_edge = 100;
    for (const int layers : {0, 1, 5}) {
        rules.buffer_layers = layers;
        const Sizes found = sizes(front(), 0.5, 0);
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            const double x = mesh.point(v)[0], away = std::max({side / 2 - x, x - side / 2 - 1, 0.0});
            EXPECT_NEAR(found.of_vertex[at(v)], 0.5 + rules.gradation * std::max(0.0, away - layers), 1e-12);
        }
    }
}

TEST_F(Indicator, SizesGrowSlowly) {
    rules.gradation = 0.3;
    std::vector<double> indicator(side * side, 0);
    indicator[at(7 * side + 9)] = 1000;
    const Sizes found = sizes(indicator, 1, 0);
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        EXPECT_LE(std::abs(found.of_vertex[at(v)] - found.of_vertex[at(w)]), 0.3 + 1e-12);
    }
    for (int v = 0; v < mesh.n_vertices(); ++v) { // nearly as if measured through the air
        const double away = (point_of(mesh, v) - point_of(mesh, 7 * (side + 1) + 9)).norm();
        EXPECT_LE(found.of_vertex[at(v)], 1e-3 + 0.3 * 1.09 * away);
    }
}

TEST_F(Indicator, NothingToSayIsTheLargestSize) {
    EXPECT_EQ(std::ranges::min(sizes(std::vector<double>(side * side, 0), 0, 100).of_vertex),
              side * std::sqrt(2.0)); // the extent of the mesh
}

TEST(IndicatorOfFaces, WithoutAreaDoesNotCount) {
    mesh::Grid grid = mesh::plane(3, 1);
    for (const std::size_t v : {2, 6}) // the middle column has no width
        grid.points[3 * v] = 1;
    const Sizes found = sizes_from_indicator(grid.build(), std::vector<double>{1, 1, 1}, 1, 0, SizeRules());
    EXPECT_EQ(found.of_vertex[0], 1);
    EXPECT_TRUE(std::isfinite(found.faces));
}

} // namespace
} // namespace alphamst::reference
