#include "geometry/relax.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fan.h"

namespace alphamst::geometry {
namespace {

using samples::Fan;

TEST(Sharpen, RaisesTheWorstCornerToTheOptimumByItself) {
    Fan f;
    double before = worst_corner(f.stars.at(0), f.points, f.points[0]);
    for (int i = 0; i < 20; ++i)
        sharpen(f.stars.at(0), f.points, 0, 0);
    const double reached = worst_corner(f.stars.at(0), f.points, f.points[0]);
    EXPECT_GT(reached, before);
    double best = -1;
    for (double x = -0.5; x < 0.5; x += 0.01)
        for (double y = -0.5; y < 0.5; y += 0.01)
            best = std::max(best, worst_corner(f.stars.at(0), f.points, {x, y}));
    EXPECT_GT(std::sqrt(reached), 0.93 * std::sqrt(best));
}

TEST(Sharpen, NoCornerGetsSmallerThanAllowed) {
    // The ring of the fan with every second vertex pulled in or out.
    const auto smallest_after = [](double pull, double x, int steps, double allowed) {
        Fan f;
        for (const std::size_t v : {1u, 3u, 5u})
            f.points[v] *= pull;
        f.points[1] *= 0.5;
        f.points[0] = {x, 0};
        for (int i = 0; i < steps; ++i)
            sharpen(f.stars.at(0), f.points, 0, 0, allowed);
        return judge(f.quads, f.points).min_determinant;
    };
    int shrinking = 0;
    for (double pull = 0.4; pull < 2; pull += 0.1)
        for (double x = -0.5; x < 0.5; x += 0.05) {
            const double start = smallest_after(pull, x, 0, 0), free = smallest_after(pull, x, 20, 0);
            if (!(start > 0 && free < 0.99 * start))
                continue;
            ++shrinking;
            const double between = (start + free) / 2;
            EXPECT_GE(smallest_after(pull, x, 20, between), between);
            EXPECT_GE(smallest_after(pull, x, 20, 10), start); // not below the present smallest
        }
    EXPECT_GT(shrinking, 0) << "the case no longer shrinks a corner";
}

TEST(Relax, TheFloorHolds) {
    for (int i = 0; i < 200; ++i) {
        Fan f;
        f.points[0] = {0.4 * std::sin(i), 0.4 * std::cos(3 * i)};
        const double before = worst_corner(f.stars.at(0), f.points, f.points[0]);
        const Barrier barrier{.theta = 0.9, .epsilon = 0.3, .area = f.area};
        relax(barrier, f.stars.at(0), f.points, 0, 0.05);
        EXPECT_GE(worst_corner(f.stars.at(0), f.points, f.points[0]), std::min(before, 0.05));
    }
}

// Four quads around the origin; the vertex is pushed off, and the best place is not on its line.
TEST(Freedom, AStepOnALineStaysOnItAndLowersTheEnergy) {
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}, {0, 7, 8, 1}};
    const Points start{{0.3, 0.2}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const Stars stars(quads, 9);
    const std::vector<double> area(4, 1);
    const Barrier barrier{.theta = 0.6, .area = area};
    Points on_line = start, in_plane = start, sharp = start;
    for (int i = 0; i < 20; ++i) {
        relax(barrier, stars.at(0), on_line, 0, no_floor, Freedom::line);
        relax(barrier, stars.at(0), in_plane, 0, no_floor);
        sharpen(stars.at(0), sharp, 0, 0, 0, Freedom::line);
    }
    EXPECT_NEAR(in_plane[0].norm(), 0, 1e-3);
    for (const Points *points : {&on_line, &sharp}) {
        EXPECT_EQ((*points)[0].y(), 0.2);
        EXPECT_NEAR((*points)[0].x(), 0, 1e-3);
    }
}

TEST(Relax, LowersTheBarrierAndTellsHowFarItWent) {
    Fan f;
    const Barrier barrier{.area = f.area};
    for (int i = 0; i < 30; ++i) {
        const Eigen::Vector2d from = f.points[0];
        const double before = value(barrier, f.stars.at(0), f.points, from);
        const double moved = relax(barrier, f.stars.at(0), f.points, 0, no_floor);
        EXPECT_NEAR(moved, (f.points[0] - from).squaredNorm(), 1e-15);
        EXPECT_LE(value(barrier, f.stars.at(0), f.points, f.points[0]), before);
    }
    const Expansion end = taylor_expansion(barrier, f.stars.at(0), f.points, f.points[0]);
    EXPECT_NEAR(end.gx, 0, 1e-4);
    EXPECT_NEAR(end.gy, 0, 1e-4);
}

} // namespace
} // namespace alphamst::geometry
