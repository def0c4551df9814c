#include "refill/respacing.h"

#include <gtest/gtest.h>
#include <numeric>

#include "../mesh/grids.h"
#include "reference/locate.h"

namespace alphamst::refill {
namespace {

// A window of three by two faces at the lower side of a grid, columns 4 to 6.
class AtTheLowerSide : public testing::Test {
protected:
    mesh::QuadMesh mesh = mesh::plane(12, 6).build();
    patch::Window window = patch::make_window(mesh, std::vector{4, 5, 6, 16, 17, 18});
    reference::Boundary boundary = reference::boundary_of(mesh, 1);
    double wanted = 1;
    reference::EdgeLength length = [this](surface::CurvePlace) { return wanted; };

    Respacing respacing(double tolerance = 0.5) const { return {mesh, window, boundary, length, tolerance}; }
};

TEST_F(AtTheLowerSide, WhatIsThereMayStay) {
    EXPECT_FALSE(respacing().empty());
    EXPECT_TRUE(respacing().towards().empty());
}

TEST_F(AtTheLowerSide, HalfTheLengthTakesSixEdges) {
    wanted = 0.5;
    const auto towards = respacing().towards();
    ASSERT_FALSE(towards.empty()); // 7, as the loop of 10 edges stays even
    EXPECT_TRUE(towards[0] == Respacing::Counts{5} || towards[0] == Respacing::Counts{7});
    const auto changed = respacing().window(towards[0], true);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->loop.size() % 2, 0u);
    EXPECT_EQ(changed->added.size(), std::size_t(towards[0][0] - 1));
    EXPECT_EQ(std::count(changed->interior.begin(), changed->interior.end(), 5), 1); // vertices 5, 6 go
    EXPECT_EQ(std::count(changed->interior.begin(), changed->interior.end(), 6), 1);
    for (const OpenMesh::Vec3d &p : changed->added) {
        EXPECT_EQ(p[1], 0);
        EXPECT_GT(p[0], 4);
        EXPECT_LT(p[0], 7);
    }
    for (std::size_t i = 0; i < changed->loop.size(); ++i)
        if (changed->loop[i] < 0) {
            EXPECT_NEAR(changed->angles[i], 180, 1e-9);
            EXPECT_EQ(changed->wanted[i], 2);
        }
    EXPECT_EQ(changed->parents.size(), changed->loop.size());
    const std::vector<Eigen::Vector3d> points = loop_points(mesh, *changed);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (changed->loop[i] >= 0) {
            EXPECT_EQ(points[i], reference::point_of(mesh, changed->loop[i]));
        }
}

TEST_F(AtTheLowerSide, NearCountsKeepTheLoopEven) {
    for (const bool wished : {false, true})
        for (const auto &counts : respacing().near(wished))
            EXPECT_EQ(std::abs(counts[0] - 3), 2);
    wanted = 3; // one edge instead of three
    const auto near = respacing().near(false);
    ASSERT_FALSE(near.empty());
    EXPECT_EQ(near[0], Respacing::Counts{1});
}

TEST_F(AtTheLowerSide, HeldVerticesPartRuns) {
    const std::vector held{5};
    const Respacing parted(mesh, window, boundary, length, 0.5, held);
    for (const auto &counts : parted.near(false)) {
        EXPECT_EQ(counts.size(), 2u);
        EXPECT_EQ((counts[0] + counts[1]) % 2, 1);
    }
}

TEST_F(AtTheLowerSide, TheCurveIsNotMissed) {
    mesh.set_point(5, {5, -0.4, 0});
    mesh.set_point(6, {6, 0.4, 0});
    window = patch::make_window(mesh, std::vector{4, 5, 6, 16, 17, 18});
    boundary = reference::boundary_of(mesh, 1);
    wanted = 3;
    EXPECT_TRUE(respacing(0.5).window({1}, false));
    EXPECT_FALSE(respacing(0.1).window({1}, false));
}

// Of a whole mesh one vertex of the boundary stays where no corner does.
TEST(Respacing, AWindowWithoutTheBoundaryHasNoRun) {
    const mesh::QuadMesh mesh = mesh::plane(6, 6).build();
    const patch::Window window = patch::make_window(mesh, std::vector{14, 15, 20, 21});
    const reference::Boundary boundary = reference::boundary_of(mesh, 1);
    const reference::EdgeLength length = [](surface::CurvePlace) { return 1.0; };
    EXPECT_TRUE(Respacing(mesh, window, boundary, length, 0.5).empty());
}

} // namespace
} // namespace alphamst::refill
