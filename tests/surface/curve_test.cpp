#include "surface/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;
using Edges = std::vector<std::array<int, 2>>;

constexpr double tolerance = 1e-12;

// From each point to the next, in some order and direction.
Edges shuffled_way(int points, bool closed, unsigned seed) {
    std::mt19937 random(seed);
    Edges edges;
    for (int i = 0; i + 1 < points + closed; ++i)
        edges.push_back({i, (i + 1) % points});
    for (std::size_t i = edges.size(); i-- > 0;) {
        std::swap(edges[i], edges[random() % (i + 1)]);
        if (random() % 2)
            std::swap(edges[i][0], edges[i][1]);
    }
    return edges;
}

bool joins(const Line &line, const Vector3d &a, const Vector3d &b) {
    return (line.start == a && line.end == b) || (line.start == b && line.end == a);
}

// Uneven, and not along an axis.
std::vector<Vector3d> on_line(int n) {
    std::vector<Vector3d> points;
    for (int i = 0; i < n; ++i)
        points.push_back(Vector3d(1, 2, -0.5) + (i + 0.3 * std::sin(5 * i)) * Vector3d(0.3, -0.1, 0.7));
    return points;
}

TEST(Line, KnowsPlacesAndDistances) {
    const Line line{{1, 1, 0}, {5, 1, 0}};
    EXPECT_EQ(line.place({2, 7, 3}), 0.25);
    EXPECT_EQ(line.place({-3, 0, 0}), -1);
    EXPECT_EQ(line.at(0.75), Vector3d(4, 1, 0));
    EXPECT_EQ(line.distance({2, 4, 4}), 5);
    EXPECT_EQ(line.distance({8, 1, 4}), 5); // it ends
    EXPECT_EQ(line.distance({-2, 5, 0}), 5);
    const Line point{{1, 1, 0}, {1, 1, 0}};
    EXPECT_EQ(point.place({2, 2, 2}), 0);
    EXPECT_EQ(point.distance({1, 4, 4}), 5);
}

TEST(Curves, JoinWhatIsStraightWhateverTheOrder) {
    const std::vector<Vector3d> points = on_line(9);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Curves curves(points, shuffled_way(9, false, seed), tolerance);
        ASSERT_EQ(curves.lines().size(), 1u);
        EXPECT_TRUE(joins(curves.lines()[0], points.front(), points.back()));
        EXPECT_EQ(curves.find(points), 0);
    }
}

TEST(Curves, JoinWhatIsStraightButForRoundingOnly) {
    for (const double off : {0.5 * tolerance, 2 * tolerance}) {
        const std::vector<Vector3d> points{{0, 0, 0}, {1, off, 0}, {2, 0, 0}};
        const Curves curves(points, Edges{{0, 1}, {1, 2}}, tolerance);
        EXPECT_EQ(curves.lines().size(), off < tolerance ? 1u : 2u);
    }
    // Back over the edge before is a bend, too.
    const std::vector<Vector3d> folded{{0, 0, 0}, {3, 0, 0}, {2, 0, 0}};
    EXPECT_EQ(Curves(folded, Edges{{0, 1}, {1, 2}}, tolerance).lines().size(), 2u);
}

TEST(Curves, EndWhereThreeEdgesMeet) {
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}};
    const Curves curves(points, Edges{{0, 1}, {1, 2}, {2, 3}, {1, 4}}, tolerance);
    ASSERT_EQ(curves.lines().size(), 3u);
    EXPECT_TRUE(joins(curves.lines()[0], points[0], points[1]));
    EXPECT_TRUE(joins(curves.lines()[1], points[1], points[3]));
    EXPECT_TRUE(joins(curves.lines()[2], points[1], points[4]));
}

TEST(Curves, OfAClosedPolygonAreItsSidesWhereverItBegins) {
    std::vector<Vector3d> square;
    for (const auto &[corner, way] : {std::pair(Vector3d(0, 0, 0), Vector3d(1, 0, 0)),
                                      {{4, 0, 0}, {0, 1, 0}},
                                      {{4, 4, 0}, {-1, 0, 0}},
                                      {{0, 4, 0}, {0, -1, 0}}})
        for (int i = 0; i < 4; ++i)
            square.push_back(corner + i * way);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Curves curves(square, shuffled_way(16, true, seed), tolerance);
        ASSERT_EQ(curves.lines().size(), 4u);
        for (const Line &line : curves.lines())
            EXPECT_EQ((line.end - line.start).norm(), 4);
    }
}

// No single point of it bends, as far as the tolerance tells.
TEST(Curves, OfAFineCircleStayNearIt) {
    constexpr int n = 1000;
    constexpr double coarse = 1e-3;
    std::vector<Vector3d> circle;
    for (int i = 0; i < n; ++i)
        circle.emplace_back(std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n),
                            0);
    for (const bool closed : {false, true}) {
        const Curves curves(circle, shuffled_way(n, closed, 3), coarse);
        EXPECT_GT(curves.lines().size(), 30u);
        EXPECT_LT(curves.lines().size(), 200u); // and not one for each edge
        double sum = 0;
        for (const Line &line : curves.lines()) {
            sum += (line.end - line.start).norm();
            EXPECT_GT(((line.start + line.end) / 2).norm(), 1 - coarse);
        }
        EXPECT_NEAR(sum, 2 * std::numbers::pi * (closed ? n : n - 1) / n, 0.01);
        for (const Vector3d &p : circle)
            EXPECT_GE(curves.find(std::array{p}), 0);
    }
}

TEST(Curves, AreFoundByPointsThatAreAllOnOneLine) {
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}};
    const Curves curves(points, Edges{{3, 4}, {0, 1}, {1, 2}, {2, 3}}, tolerance);
    ASSERT_EQ(curves.lines().size(), 2u);
    const auto find = [&](std::vector<Vector3d> asked) { return curves.find(asked); };
    EXPECT_EQ(find({points[3]}), 0);
    EXPECT_EQ(find({points[1]}), 1);
    EXPECT_EQ(find({points[2]}), 0); // on both
    EXPECT_EQ(find({points[2], points[1]}), 1);
    EXPECT_EQ(find({{0.3, 0, 0}, points[0], points[2]}), 1);
    EXPECT_EQ(find({points[2], points[1], points[3]}), -1); // around the bend
    EXPECT_EQ(find({{0.3, 1e-9, 0}}), -1);
    EXPECT_EQ(find({points[0], {0.3, 1e-9, 0}}), -1);
    EXPECT_EQ(find({{-1e-9, 0, 0}}), -1);
    EXPECT_EQ(find({}), -1);
}

TEST(Curves, KeepGivenLinesFirst) {
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}};
    const Line given{{-1, 0, 0}, {3, 0, 0}};
    const Curves curves(points, Edges{{0, 1}}, tolerance, {given});
    ASSERT_EQ(curves.lines().size(), 2u);
    EXPECT_TRUE(joins(curves.lines()[0], given.start, given.end));
    EXPECT_EQ(curves.find(points), 0);
    EXPECT_EQ(Curves({}, {}, tolerance).find(points), -1);
}

TEST(Curves, ToleratePointsAtOnePlace) {
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const Curves curves(points, Edges{{0, 1}, {1, 2}, {2, 3}}, tolerance);
    EXPECT_EQ(curves.find(points), 0);
    const std::vector<Vector3d> one(3, Vector3d(1, 2, 3));
    EXPECT_EQ(Curves(one, Edges{{0, 1}, {1, 2}, {2, 0}}, tolerance).find(one), 0);
}

// 24 edges: it turns by 15 degrees at each point.
std::vector<Vector3d> ring() {
    std::vector<Vector3d> points;
    for (int i = 0; i < 24; ++i)
        points.emplace_back(std::cos(std::numbers::pi * i / 12), std::sin(std::numbers::pi * i / 12), 0.5);
    return points;
}

TEST(Curves, LeadAroundBendsByTheShorterWay) {
    const std::vector<Vector3d> points = ring();
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Curves curves(points, shuffled_way(24, true, seed), tolerance);
        ASSERT_EQ(curves.lines().size(), 24u);
        for (const auto &[from, to] : {std::pair(22, 1), std::pair(1, 22)}) {
            const Vector3d start = (points[22] + points[23]) / 2;
            const Vector3d a = from == 22 ? start : points[1], b = from == 22 ? points[1] : start;
            const std::vector<Line> way = curves.way(a, b);
            ASSERT_EQ(way.size(), 3u) << seed;
            EXPECT_TRUE(joins(way[0], points[from == 22 ? 22 : 0], points[from == 22 ? 23 : 1]));
            for (std::size_t i = 0; i + 1 < way.size(); ++i)
                EXPECT_EQ(way[i].end, way[i + 1].start);
        }
        EXPECT_EQ(curves.way(points[3], points[4]).size(), 1u);
        EXPECT_EQ(curves.lines_between(points[3], points[4]).size(), 1u);
        EXPECT_EQ(curves.lines_between(points[3], points[6]).size(), 3u);
        EXPECT_TRUE(curves.way(points[0], points[12]).empty()); // half around is a detour
        EXPECT_TRUE(curves.way(points[0], {0, 0, 0}).empty());
    }
}

TEST(Curves, LeadThroughAPointAndBeyond) {
    const std::vector<Vector3d> points = ring();
    const Curves curves(points, shuffled_way(24, true, 3), tolerance);
    for (const Vector3d &between : {points[5], Vector3d(0.3 * points[5] + 0.7 * points[6])}) {
        const std::vector<Line> way = curves.way_through(points[4], between, points[7]);
        ASSERT_GE(way.size(), 5u);
        bool found = false;
        for (std::size_t i = 0; i < way.size(); ++i) {
            if (i > 0) {
                EXPECT_EQ(way[i - 1].end, way[i].start);
            }
            found |= joins(way[i], points[4], points[5]) && i > 0; // it goes on before
        }
        EXPECT_TRUE(found);
        EXPECT_LT((way.front().start - points[4]).norm(), (way.front().end - points[7]).norm());
    }
    EXPECT_TRUE(curves.way_through(points[4], points[8], points[6]).empty());
}

TEST(Curves, EndAtCornersAndWhereThreeMeet) {
    // 40 degrees at point 1; three edges at point 3.
    const std::vector<Vector3d> points{{0, 0, 0},     {1, 0, 0},   {1.77, 0.64, 0},
                                       {2.5, 1.3, 0}, {3.2, 2, 0}, {2, 2, 0}};
    const Curves curves(points, Edges{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {3, 5}}, tolerance);
    EXPECT_TRUE(curves.way(points[0], points[2]).empty());
    EXPECT_EQ(curves.way(points[1], points[3]).size(), 2u);
    EXPECT_TRUE(curves.way(points[2], points[4]).empty());
}

} // namespace
} // namespace alphamst::surface
