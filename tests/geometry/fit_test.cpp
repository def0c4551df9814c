#include "geometry/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/cover.h"
#include "laid.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The points of the surface as samples of the quads below or above them.
std::vector<Sample> samples_of(const Surface &surface) {
    std::vector<Sample> samples;
    for (const Vector3d &p : surface.points())
        samples.push_back(
            {p, 8 * std::min(7, static_cast<int>(p.y())) + std::min(7, static_cast<int>(p.x()))});
    return samples;
}

double farthest(const std::vector<Sample> &samples, const Laid &laid) {
    const Stars stars(laid.quads, static_cast<int>(laid.on_surface.points.size()));
    Cover cover(laid.quads, stars, samples);
    cover.measure(laid.on_surface, {});
    double most = 0;
    for (std::size_t i = 0; i < cover.size(); ++i)
        most = std::max(most, cover.place(static_cast<int>(i)).distance);
    return most;
}

TEST(Fit, SamplesOfAPeakDrawAVertexToIt) {
    const auto peak = graph(64, [](double x, double y) {
        return 1.5 * std::exp(-((x - 4.3) * (x - 4.3) + (y - 4.3) * (y - 4.3)) / 0.25);
    });
    const std::vector<Sample> samples = samples_of(*peak);
    Laid with(*peak, Vector3d::Zero()), without = with;
    const double before = farthest(samples, with);
    fit(*peak, with.quads, with.fixed, with.on_surface, {}, samples);
    fit(*peak, without.quads, without.fixed, without.on_surface, {});
    EXPECT_LT(farthest(samples, with), 0.8 * before);
    EXPECT_LT(farthest(samples, with), farthest(samples, without));
    EXPECT_GT(judge(with.quads, with.on_surface).min_scaled_jacobian, 0.3);
}

TEST(Fit, VerticesComeToTheRidge) {
    const auto roof = graph(64, [](double x, double) { return -0.8 * std::abs(x - 4); });
    Laid laid(*roof, {0.4, 0, 0});
    const double before = laid.distance(*roof);
    ASSERT_GT(before, 0.05);
    const SurfacePositions start = laid.on_surface;
    fit(*roof, laid.quads, laid.fixed, laid.on_surface, {});
    EXPECT_LT(laid.distance(*roof), before / 4);
    for (int j = 2; j < 7; ++j)
        EXPECT_NEAR(laid.on_surface.points[at(9 * j + 4)].x(), 4, 0.05) << j;
    for (std::size_t v = 0; v < laid.fixed.size(); ++v) {
        if (laid.fixed[v]) {
            EXPECT_EQ(laid.on_surface.points[v], start.points[v]);
        }
        EXPECT_LT(roof->nearest(laid.on_surface.points[v]).distance, 1e-9);
    }
    EXPECT_GT(judge(laid.quads, laid.on_surface).min_scaled_jacobian, 0.32);
}

TEST(Fit, GetsNearerOnBumpsAndSpoilsNoQuad) {
    const auto bumps = graph(64, [](double x, double y) { return 0.5 * std::sin(x) * std::cos(0.8 * y); });
    Laid laid(*bumps, {0.2, -0.2, 0});
    const double before = laid.distance(*bumps);
    fit(*bumps, laid.quads, laid.fixed, laid.on_surface, {});
    EXPECT_LT(laid.distance(*bumps), 0.9 * before);
    EXPECT_GT(judge(laid.quads, laid.on_surface).min_scaled_jacobian, 0.32);
}

TEST(Fit, LeavesSquaresOnAPlane) {
    const auto plane = graph(8, [](double, double) { return 0.0; });
    Laid laid(*plane, Vector3d::Zero());
    const SurfacePositions start = laid.on_surface;
    fit(*plane, laid.quads, laid.fixed, laid.on_surface, {});
    for (std::size_t v = 0; v < start.points.size(); ++v)
        EXPECT_LT((laid.on_surface.points[v] - start.points[v]).norm(), 1e-6);
}

TEST(Fit, DoesNotDependOnHowWorkIsRun) {
    const auto bumps = graph(64, [](double x, double y) { return std::sin(x) * std::sin(y); });
    Laid one(*bumps, {0.2, 0.1, 0}), other = one;
    fit(*bumps, one.quads, one.fixed, one.on_surface, {});
    EmbedOptions backwards;
    backwards.run = [](std::size_t n, const std::function<void(std::size_t)> &work) {
        while (n-- > 0)
            work(n);
    };
    fit(*bumps, other.quads, other.fixed, other.on_surface, backwards);
    EXPECT_EQ(one.on_surface.points, other.on_surface.points);
}

TEST(Fit, NothingFreeIsNothingToDo) {
    const auto plane = graph(4, [](double, double) { return 0.0; });
    Laid laid(*plane, Vector3d::Zero());
    laid.fixed.assign(laid.fixed.size(), 1);
    const SurfacePositions start = laid.on_surface;
    fit(*plane, laid.quads, laid.fixed, laid.on_surface, {});
    EXPECT_EQ(laid.on_surface.points, start.points);
    SurfacePositions none;
    fit(*plane, {}, {}, none, {});
    EXPECT_TRUE(none.points.empty());
}

} // namespace
} // namespace alphamst::geometry
