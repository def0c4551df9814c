#include "mesh/orient.h"

#include <gtest/gtest.h>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Ids = std::vector<std::int32_t>;

void turn(Grid &grid, std::size_t face) { std::swap(grid.faces[4 * face + 1], grid.faces[4 * face + 3]); }

TEST(Orient, WhatRunsOneWayStays) {
    const Grid grid = plane(4, 3), closed = torus(6, 5);
    EXPECT_TRUE(orient(2, grid.points, grid.faces).faces.empty());
    EXPECT_TRUE(orient(3, closed.points, closed.faces).faces.empty());
    EXPECT_EQ(orient(3, closed.points, closed.faces).n_turned, 0);
    EXPECT_TRUE(orient(2, {}, {}).faces.empty());
    Grid below = plane(4, 3); // in space nobody knows where above is
    for (std::size_t f = 0; f < 12; ++f)
        turn(below, f);
    EXPECT_TRUE(orient(3, below.points, below.faces).faces.empty());
}

TEST(Orient, InThePlaneFacesBecomeCounterClockwise) {
    const Grid right = plane(4, 3);
    for (const std::vector<std::size_t> &turned :
         {std::vector<std::size_t>{5}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 10}, {3, 4, 7}}) {
        Grid grid = right;
        for (const std::size_t f : turned)
            turn(grid, f);
        const Oriented oriented = orient(2, grid.points, grid.faces);
        EXPECT_EQ(oriented.faces, right.faces); // the first corner stays the first
        EXPECT_EQ(oriented.n_turned, static_cast<std::int64_t>(turned.size()));
        EXPECT_EQ(oriented.first_turned, static_cast<std::int64_t>(turned[0]));
    }
    Grid all = right;
    for (std::size_t f = 0; f < 12; ++f)
        turn(all, f);
    EXPECT_EQ(orient(2, all.points, all.faces).faces, right.faces);
}

TEST(Orient, AnInvertedFaceInThePlaneStaysOne) {
    Grid grid = plane(3, 3);
    grid.points[3 * 5] = 2.5; // beyond vertex 6: face 4 is inverted
    EXPECT_TRUE(orient(2, grid.points, grid.faces).faces.empty());
    const Grid right = grid;
    turn(grid, 8);
    EXPECT_EQ(orient(2, grid.points, grid.faces).faces, right.faces);
}

TEST(Orient, InSpaceMostFacesStay) {
    const Grid right = torus(6, 5);
    Grid grid = right;
    for (const std::size_t f : {0, 1, 7, 29})
        turn(grid, f);
    EXPECT_EQ(orient(3, grid.points, grid.faces).faces, right.faces);
    Grid two = plane(2, 1), second = two; // of equally many the first stays
    turn(two, 0);
    turn(second, 0);
    turn(second, 1);
    EXPECT_EQ(orient(3, two.points, two.faces).faces, second.faces);
}

TEST(Orient, ComponentsAreTurnedEachForItself) {
    const Grid one = plane(2, 1);
    Grid grid = one, right;
    for (const double x : one.points)
        grid.points.push_back(x + 10);
    grid.faces.insert(grid.faces.end(), {6, 7, 10, 9, 7, 8, 11, 10});
    right = grid;
    turn(grid, 2);
    turn(grid, 3);
    for (std::size_t i = 2; i < grid.points.size(); i += 3)
        grid.points[i] = 0;
    const Oriented oriented = orient(2, grid.points, grid.faces);
    EXPECT_EQ(oriented.faces, right.faces);
    EXPECT_EQ(oriented.first_turned, 2);
}

TEST(Orient, TrianglesAreTurned) {
    const Grid grid{plane(2, 1).points, {0, 1, 4, 3, 1, 4, 2, -1, 2, 5, 4, -1}};
    EXPECT_EQ(orient(2, grid.points, grid.faces).faces, (Ids{0, 1, 4, 3, 1, 2, 4, -1, 2, 5, 4, -1}));
}

TEST(Orient, PixelsAreRefused) {
    Grid grid = plane(4, 4);
    for (std::size_t f = 0; f < 16; ++f)
        std::swap(grid.faces[4 * f + 2], grid.faces[4 * f + 3]);
    const Failure failure = failure_of([&] { orient(2, grid.points, grid.faces); });
    EXPECT_EQ(failure.fault, Fault::not_manifold);
    EXPECT_NE(failure.text.find("crossing order"), std::string::npos);
}

TEST(Orient, OneSideIsRefused) {
    const Grid strip = moebius(12);
    const Failure failure = failure_of([&] { orient(3, strip.points, strip.faces); });
    EXPECT_EQ(failure.fault, Fault::not_manifold);
    EXPECT_NE(failure.text.find("only one side"), std::string::npos) << failure.text;
}

} // namespace
} // namespace alphamst::mesh
