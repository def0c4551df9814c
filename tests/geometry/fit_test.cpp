#include "geometry/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "geometry/cover.h"
#include "geometry/misfit.h"
#include "square.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;
using surface::Surface;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The graph z = height(x, y) over a square of side 8, as n x n squares of two triangles.
template <class Height> std::unique_ptr<Surface> graph(int n, const Height &height) {
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = 8.0 * i / n, y = 8.0 * j / n;
            points.emplace_back(x, y, height(x, y));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return std::make_unique<Surface>(std::move(points), std::move(triangles));
}

// An 8 x 8 grid laid on the surface, its inner vertices moved sideways by `shift`.
struct Laid {
    explicit Laid(const Surface &surface, const Vector3d &shift) {
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i) {
                const bool rim = i % 8 == 0 || j % 8 == 0;
                fixed.push_back(rim);
                Vector3d p(i, j, 0);
                if (!rim)
                    p += shift;
                drape.add(surface.nearest(surface_point(surface, p)));
            }
        for (int j = 0; j < 8; ++j)
            for (int i = 0; i < 8; ++i) {
                const int a = 9 * j + i;
                quads.push_back({a, a + 1, a + 10, a + 9});
            }
    }

    // Above p, so that the nearest place is right there.
    static Vector3d surface_point(const Surface &surface, Vector3d p) {
        for (int k = 0; k < 40; ++k)
            p.z() = surface.nearest(p).point.z();
        return p;
    }

    double distance(const Surface &surface) const {
        Misfit misfit(surface, quads, drape);
        misfit.measure(drape, {});
        return std::sqrt(misfit.mean_square());
    }

    Drape drape;
    std::vector<std::array<int, 4>> quads;
    std::vector<char> fixed;
};

TEST(Misfit, IsNothingOnAPlane) {
    const auto plane = graph(8, [](double x, double y) { return 0.3 * x - 0.2 * y; });
    EXPECT_LT(Laid(*plane, {0.3, 0.1, 0}).distance(*plane), 1e-12);
}

TEST(Misfit, OfAnArchIsThatOfItsChords) {
    const double radius = 20;
    const auto arch =
        graph(256, [&](double x, double) { return std::sqrt(radius * radius - (x - 4) * (x - 4)); });
    const Laid laid(*arch, Vector3d::Zero());
    // A chord of length h is off by x (h - x) / 2 r, the mean square of that is h^4 / (120 r^2).
    EXPECT_NEAR(laid.distance(*arch), 1 / (std::sqrt(120.0) * radius), 0.1 / (std::sqrt(120.0) * radius));
    Misfit misfit(*arch, laid.quads, laid.drape);
    misfit.measure(laid.drape, {});
    for (const Misfit::Place &place : misfit.at(20))
        EXPECT_LT(place.distance, 0); // chords lie below
}

// The points of the surface as samples of the quads below or above them.
std::vector<Sample> samples_of(const Surface &surface) {
    std::vector<Sample> samples;
    for (const Vector3d &p : surface.points())
        samples.push_back(
            {p, 8 * std::min(7, static_cast<int>(p.y())) + std::min(7, static_cast<int>(p.x()))});
    return samples;
}

double farthest(const std::vector<Sample> &samples, const Laid &laid) {
    const Stars stars(laid.quads, static_cast<int>(laid.drape.points.size()));
    Cover cover(laid.quads, stars, samples);
    cover.measure(laid.drape, {});
    double most = 0;
    for (std::size_t i = 0; i < cover.size(); ++i)
        most = std::max(most, cover.place(static_cast<int>(i)).distance);
    return most;
}

TEST(Cover, FindsThePlacesNearestToSamples) {
    const auto plane = graph(8, [](double, double) { return 0.0; });
    const Laid laid(*plane, Vector3d::Zero());
    const Stars stars(laid.quads, static_cast<int>(laid.drape.points.size()));
    const std::vector<Sample> samples = {
        {{2.25, 3.5, 0.5}, 8 * 3 + 2}, {{4, 4, -1}, 8 * 4 + 4}, {{5.5, 1.5, 0}, 8 * 2 + 4}, {{9, 0.5, 0}, 7}};
    Cover cover(laid.quads, stars, samples);
    cover.measure(laid.drape, {});
    const double distances[] = {0.5, 1, 0, 1};
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(cover.place(i).distance, distances[i], 1e-12) << i;
    EXPECT_LT((cover.place(0).normal - Vector3d(0, 0, -1)).norm(), 1e-12);
    EXPECT_LT((cover.place(3).normal - Vector3d(-1, 0, 0)).norm(), 1e-12);
    // The third goes over to the quad across the corner that holds it.
    ASSERT_EQ(cover.at(8 * 1 + 5).size(), 1u);
    EXPECT_EQ(cover.at(8 * 1 + 5)[0], 2);
    Vector3d place = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
        place += cover.place(0).weights[k] * laid.drape.points[at(laid.quads[8 * 3 + 2][k])];
    EXPECT_LT((place - Vector3d(2.25, 3.5, 0)).norm(), 1e-12);
}

TEST(Fit, SamplesOfAPeakDrawAVertexToIt) {
    const auto peak = graph(64, [](double x, double y) {
        return 1.5 * std::exp(-((x - 4.3) * (x - 4.3) + (y - 4.3) * (y - 4.3)) / 0.25);
    });
    const std::vector<Sample> samples = samples_of(*peak);
    Laid with(*peak, Vector3d::Zero()), without = with;
    const double before = farthest(samples, with);
    fit(*peak, with.quads, with.fixed, with.drape, {}, samples);
    fit(*peak, without.quads, without.fixed, without.drape, {});
    EXPECT_LT(farthest(samples, with), 0.8 * before);
    EXPECT_LT(farthest(samples, with), farthest(samples, without));
    EXPECT_GT(judge(with.quads, with.drape).min_scaled_jacobian, 0.3);
}

TEST(Fit, VerticesComeToTheRidge) {
    const auto roof = graph(64, [](double x, double) { return -0.8 * std::abs(x - 4); });
    Laid laid(*roof, {0.4, 0, 0});
    const double before = laid.distance(*roof);
    ASSERT_GT(before, 0.05);
    const Drape start = laid.drape;
    fit(*roof, laid.quads, laid.fixed, laid.drape, {});
    EXPECT_LT(laid.distance(*roof), before / 4);
    for (int j = 2; j < 7; ++j)
        EXPECT_NEAR(laid.drape.points[at(9 * j + 4)].x(), 4, 0.05) << j;
    for (std::size_t v = 0; v < laid.fixed.size(); ++v) {
        if (laid.fixed[v]) {
            EXPECT_EQ(laid.drape.points[v], start.points[v]);
        }
        EXPECT_LT(roof->nearest(laid.drape.points[v]).distance, 1e-9);
    }
    EXPECT_GT(judge(laid.quads, laid.drape).min_scaled_jacobian, 0.32);
}

TEST(Fit, GetsNearerOnBumpsAndSpoilsNoQuad) {
    const auto bumps = graph(64, [](double x, double y) { return 0.5 * std::sin(x) * std::cos(0.8 * y); });
    Laid laid(*bumps, {0.2, -0.2, 0});
    const double before = laid.distance(*bumps);
    fit(*bumps, laid.quads, laid.fixed, laid.drape, {});
    EXPECT_LT(laid.distance(*bumps), 0.9 * before);
    EXPECT_GT(judge(laid.quads, laid.drape).min_scaled_jacobian, 0.32);
}

TEST(Fit, LeavesSquaresOnAPlane) {
    const auto plane = graph(8, [](double, double) { return 0.0; });
    Laid laid(*plane, Vector3d::Zero());
    const Drape start = laid.drape;
    fit(*plane, laid.quads, laid.fixed, laid.drape, {});
    for (std::size_t v = 0; v < start.points.size(); ++v)
        EXPECT_LT((laid.drape.points[v] - start.points[v]).norm(), 1e-6);
}

TEST(Fit, DoesNotDependOnHowWorkIsRun) {
    const auto bumps = graph(64, [](double x, double y) { return std::sin(x) * std::sin(y); });
    Laid one(*bumps, {0.2, 0.1, 0}), other = one;
    fit(*bumps, one.quads, one.fixed, one.drape, {});
    EmbedOptions backwards;
    backwards.run = [](std::size_t n, const std::function<void(std::size_t)> &work) {
        while (n-- > 0)
            work(n);
    };
    fit(*bumps, other.quads, other.fixed, other.drape, backwards);
    EXPECT_EQ(one.drape.points, other.drape.points);
}

TEST(Fit, NothingFreeIsNothingToDo) {
    const auto plane = graph(4, [](double, double) { return 0.0; });
    Laid laid(*plane, Vector3d::Zero());
    laid.fixed.assign(laid.fixed.size(), 1);
    const Drape start = laid.drape;
    fit(*plane, laid.quads, laid.fixed, laid.drape, {});
    EXPECT_EQ(laid.drape.points, start.points);
    Drape none;
    fit(*plane, {}, {}, none, {});
    EXPECT_TRUE(none.points.empty());
}

} // namespace
} // namespace alphamst::geometry
