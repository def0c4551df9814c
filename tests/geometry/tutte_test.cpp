#include "geometry/tutte.h"

#include <gtest/gtest.h>

#include "disk.h"
#include "square.h"

namespace alphamst::geometry {
namespace {

using namespace samples;
using Eigen::Vector2d;

TEST(Tutte, EveryFaceIsConvexAndEveryFreeVertexIsAMean) {
    const Disk d = disk(surround(grid(4, 3), 2));
    const Points loop = star(d.boundary, 0.4);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < loop.size(); ++i)
        lengths.push_back((loop[(i + 1) % loop.size()] - loop[i]).norm());
    const Points points = embed_on_circle(d.quads, d.boundary, d.vertices, lengths);
    EXPECT_TRUE(judge(d.quads, points).valid);
    std::vector<Vector2d> sum(points.size(), Vector2d::Zero());
    std::vector<int> count(points.size(), 0);
    for (const auto &q : d.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            sum[static_cast<std::size_t>(q[k])] += points[static_cast<std::size_t>(q[(k + 1) % 4])];
            ++count[static_cast<std::size_t>(q[k])];
        }
    for (std::size_t v = 0; v < points.size(); ++v)
        if (static_cast<int>(v) < d.boundary) {
            EXPECT_NEAR(points[v].norm(), points[0].norm(), 1e-12);
        } else {
            EXPECT_LT((sum[v] / count[v] - points[v]).norm(), 1e-12);
        }
}

TEST(Tutte, AGridComesBackWhereverItsInsideWas) {
    const Square even = noisy(7, 0, 1);
    Square s = noisy(7, 5, 2);
    const Stars stars(s.quads, static_cast<int>(s.points.size()));
    const Tutte tutte(stars, s.fixed);
    ASSERT_TRUE(tutte.solve(s.points));
    for (std::size_t v = 0; v < s.points.size(); ++v)
        EXPECT_LT((s.points[v] - even.points[v]).norm(), 1e-12);
    for (std::size_t v = 0; v < s.points.size(); ++v) // factored once, for other places, too
        s.points[v] = s.fixed[v] ? Vector2d(3 * even.points[v].y(), even.points[v].x()) : Vector2d(9, 9);
    ASSERT_TRUE(tutte.solve(s.points));
    for (std::size_t v = 0; v < s.points.size(); ++v)
        EXPECT_LT((s.points[v] - Vector2d(3 * even.points[v].y(), even.points[v].x())).norm(), 1e-12);
}

TEST(Tutte, TheLoopIsOnACircleOfItsLength) {
    const std::vector<double> lengths{1, 2, 3, 0.5};
    const Points loop = loop_on_circle(lengths);
    ASSERT_EQ(loop.size(), 4U);
    const double radius = 6.5 / (2 * std::numbers::pi);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector2d &p = loop[i], &q = loop[(i + 1) % 4];
        EXPECT_NEAR(p.norm(), radius, 1e-12);
        const double turn = std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q)); // counter-clockwise
        EXPECT_NEAR(turn * radius, lengths[i], 1e-12);
    }
}

} // namespace
} // namespace alphamst::geometry
