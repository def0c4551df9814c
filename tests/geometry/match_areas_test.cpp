#include "geometry/match_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "square.h"

namespace alphamst::geometry {
namespace {

using samples::noisy;
using samples::Square;

Eigen::Vector2d centre(const std::array<int, 4> &q, const Points &p) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const int v : q)
        sum += p[static_cast<std::size_t>(v)] / 4;
    return sum;
}

double area(const std::array<int, 4> &q, const Points &p) {
    const auto at = [&](std::size_t k) { return p[static_cast<std::size_t>(q[k])]; };
    const Eigen::Vector2d a = at(2) - at(0), b = at(3) - at(1);
    return (a.x() * b.y() - a.y() * b.x()) / 2;
}

// Of a square of n x n: a third in the middle, growing to the border.
double wanted_at(const Eigen::Vector2d &x, int n) {
    const double away = (x - Eigen::Vector2d(n / 2.0, n / 2.0)).norm() / n;
    return 1.0 / 3 + 2 * std::min(0.5, away);
}

double rms(const Square &s, const Points &points, int n) {
    double total = 0, wanted = 0, sum = 0;
    for (const auto &q : s.quads) {
        total += area(q, points);
        wanted += wanted_at(centre(q, points), n);
    }
    for (const auto &q : s.quads)
        sum += std::pow(std::log2(area(q, points) / (wanted_at(centre(q, points), n) * total / wanted)), 2);
    return std::sqrt(sum / static_cast<double>(s.quads.size()));
}

Embedding matched(const Square &s, int n, double weight) {
    const WantedAreas wanted = [&](const Points &now) {
        std::vector<double> areas;
        for (const auto &q : s.quads)
            areas.push_back(wanted_at(centre(q, now), n));
        return areas;
    };
    return match_areas(s.quads, s.fixed, s.points, wanted, weight, {});
}

TEST(MatchAreas, GivesTheAreasThatAreWantedWhereQuadsLie) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Square s = noisy(16, 0.3, seed);
        const Embedding result = matched(s, 16, 0.7);
        EXPECT_TRUE(result.valid);
        EXPECT_GT(rms(s, s.points, 16), 0.45);
        EXPECT_LT(rms(s, result.positions, 16), 0.25); // the corners of the square keep their area
    }
}

TEST(MatchAreas, WeighsThemAgainstShapes) {
    const Square s = noisy(16, 0.3, 4);
    const Embedding sizes = matched(s, 16, 0.9), shapes = matched(s, 16, 0.01);
    EXPECT_LT(rms(s, sizes.positions, 16), rms(s, shapes.positions, 16));
    EXPECT_GT(shapes.min_shape, sizes.min_shape);
}

// The barrier alone would leave a corner squeezed that is hardly positive.
TEST(MatchAreas, OpensSqueezedCorners) {
    Square s = noisy(12, 0, 1);
    s.points[6 * 13 + 6] = s.points[6 * 13 + 7] - Eigen::Vector2d(1e-6, 0);
    ASSERT_TRUE(judge(s.quads, s.points).valid);
    const Embedding result = matched(s, 12, 0.7);
    EXPECT_GT(result.min_scaled_jacobian, 0.7);
}

TEST(MatchAreas, LeavesWhatIsFixed) {
    const Square s = noisy(9, 0.3, 5);
    const Embedding result = matched(s, 9, 0.7);
    for (std::size_t v = 0; v < s.points.size(); ++v)
        if (s.fixed[v]) {
            EXPECT_EQ(result.positions[v], s.points[v]);
        }
}

} // namespace
} // namespace alphamst::geometry
