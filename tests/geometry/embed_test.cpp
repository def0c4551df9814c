#include "geometry/embed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace {

using namespace alphamst::geometry;
using Eigen::Vector2d;
using QuadList = std::vector<std::array<int, 4>>;

struct Disk {
    QuadList quads;
    int boundary = 0, vertices = 0;
    std::vector<int> loop; // names the boundary vertices had
};

// Renumbers quads so that the loop comes first, counter-clockwise from its smallest vertex.
Disk disk(const QuadList &quads) {
    std::set<std::pair<int, int>> edges;
    for (const auto &q : quads)
        for (std::size_t k = 0; k < 4; ++k)
            edges.insert({q[k], q[(k + 1) % 4]});
    std::map<int, int> next, name;
    for (const auto &[a, b] : edges)
        if (!edges.count({b, a}))
            next[a] = b;
    Disk d;
    int v = next.begin()->first;
    do {
        name.insert({v, static_cast<int>(name.size())});
        d.loop.push_back(v);
        v = next[v];
    } while (v != d.loop.front());
    d.boundary = static_cast<int>(name.size());
    for (const auto &q : quads) {
        d.quads.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
            d.quads.back()[k] = name.insert({q[k], static_cast<int>(name.size())}).first->second;
    }
    d.vertices = static_cast<int>(name.size());
    return d;
}

template <class Keep> QuadList grid(int n, int m, Keep keep) {
    QuadList quads;
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            if (keep(i, j)) {
                const int v = j * (n + 1) + i;
                quads.push_back({v, v + 1, v + n + 2, v + n + 1});
            }
    return quads;
}
QuadList grid(int n, int m) {
    return grid(n, m, [](int, int) { return true; });
}

// Layers of quads around a disk: its corners become vertices of valence 3.
QuadList surround(QuadList quads, int layers) {
    for (int layer = 0; layer < layers; ++layer) {
        const std::vector<int> loop = disk(quads).loop;
        int first = 0;
        for (const auto &q : quads)
            for (const int v : q)
                first = std::max(first, v + 1);
        const int n = static_cast<int>(loop.size());
        for (int i = 0; i < n; ++i) {
            const int j = (i + 1) % n;
            quads.push_back(
                {loop[static_cast<std::size_t>(j)], loop[static_cast<std::size_t>(i)], first + i, first + j});
        }
    }
    return quads;
}

// The loop of a disk cut from a grid of n columns, each vertex (i, j) put at map(i, j).
template <class Map> Points place(const Disk &d, int n, Map map) {
    Points loop;
    for (const int v : d.loop)
        loop.push_back(map(v % (n + 1), v / (n + 1)));
    return loop;
}

Points star(int n, double amplitude) {
    Points loop;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n, r = 1 + amplitude * std::cos(5 * a);
        loop.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return loop;
}

Embedding embedded(const Disk &d, const Points &loop, const EmbedOptions &options = {}) {
    return embed(d.quads, d.boundary, d.vertices, loop, options);
}

void expect_good(const Disk &d, const Points &loop, double least) {
    const Embedding e = embedded(d, loop);
    ASSERT_EQ(e.positions.size(), static_cast<std::size_t>(d.vertices));
    for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_EQ(e.positions[i], loop[i]); // to the last bit
    EXPECT_TRUE(e.valid);
    EXPECT_GE(e.min_scaled_jacobian, least);
    const Embedding again = judge(d.quads, e.positions);
    EXPECT_EQ(again.min_scaled_jacobian, e.min_scaled_jacobian);
    EXPECT_EQ(again.min_determinant, e.min_determinant);
}

TEST(Judge, UnitSquareAndSlantedQuad) {
    const QuadList quad{{0, 1, 2, 3}};
    const Embedding square = judge(quad, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    EXPECT_TRUE(square.valid);
    EXPECT_DOUBLE_EQ(square.min_determinant, 1);
    EXPECT_DOUBLE_EQ(square.min_scaled_jacobian, 1);
    // A parallelogram of 30 degrees: area 1 * 2 * sin 30.
    const double c = std::sqrt(3.0) / 2;
    const Embedding slanted = judge(quad, {{0, 0}, {2, 0}, {2 + c, 0.5}, {c, 0.5}});
    EXPECT_NEAR(slanted.min_determinant, 1, 1e-14);
    EXPECT_NEAR(slanted.min_scaled_jacobian, 0.5, 1e-14);
}

TEST(Judge, ConcaveStraightClockwiseAndCollapsedAreNotValid) {
    const QuadList quad{{0, 1, 2, 3}};
    const Embedding concave = judge(quad, {{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}});
    EXPECT_FALSE(concave.valid);
    EXPECT_NEAR(concave.min_determinant, -0.6, 1e-14); // (-0.8, 0.2) x (-0.2, 0.8)
    EXPECT_FALSE(judge(quad, {{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}}).valid);
    EXPECT_DOUBLE_EQ(judge(quad, {{0, 0}, {0, 1}, {1, 1}, {1, 0}}).min_scaled_jacobian, -1);
    EXPECT_FALSE(judge(quad, {{0, 0}, {0, 0}, {1, 1}, {0, 1}}).valid);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(judge(quad, {{0, 0}, {1, 0}, {nan, 1}, {0, 1}}).valid);
}

TEST(Embed, WithoutFreeVertices) {
    const Disk d = disk(grid(3, 1));
    const Points loop = place(d, 3, [](int i, int j) { return Vector2d(i, j); });
    expect_good(d, loop, 1 - 1e-12);
}

TEST(Embed, StructuredShapesKeepTheirShape) {
    const auto l = [](int i, int j) { return i < 6 || j < 6; };
    const auto stairs = [](int i, int j) { return i + j < 13; };
    const auto comb = [](int i, int j) { return j < 3 || i % 4 < 2; };
    const Disk a = disk(grid(12, 12, l)), b = disk(grid(12, 12, stairs)), c = disk(grid(21, 10, comb));
    expect_good(a, place(a, 12, [](int i, int j) { return Vector2d(i, j); }), 0.99);
    expect_good(b,
                place(b, 12,
                      [](int i, int j) {
                          return Vector2d(i + 0.3 * std::sin(7.0 * j), j + 0.2 * std::sin(5.0 * i));
                      }),
                0.85);
    expect_good(c, place(c, 21, [](int i, int j) { return Vector2d(i + 0.02 * j * j, j); }), 0.9);
}

TEST(Embed, SpiralStrip) {
    const Disk d = disk(grid(60, 6));
    const Points loop = place(d, 60, [](int i, int j) {
        const double a = i / 60.0 * 5.5, r = 1 + 0.35 * j / 6.0 + 0.08 * a;
        return Vector2d(-r * std::cos(a), r * std::sin(a));
    });
    expect_good(d, loop, 0.95);
}

TEST(Embed, UntanglesWhereTheLinearSolutionFolds) {
    const Disk d = disk(surround(grid(5, 5), 2));
    const Points loop = star(d.boundary, 0.35);
    EmbedOptions none;
    none.untangle_sweeps = 0;
    EXPECT_FALSE(embedded(d, loop, none).valid) << "the case no longer needs untangling";
    expect_good(d, loop, 0.55);
}

TEST(Embed, BlockWithLayersInAStar) {
    for (const int layers : {2, 4, 8})
        for (const double amplitude : {0.0, 0.2, 0.35}) {
            const Disk d = disk(surround(grid(5, 5), layers));
            expect_good(d, star(d.boundary, amplitude), amplitude > 0.3 ? 0.55 : 0.7);
        }
}

TEST(Embed, FourToOneSpacing) {
    const Disk d = disk(grid(16, 16));
    const auto g = [](int i) { return i < 8 ? i / 40.0 : 0.2 + (i - 8) * 0.1; };
    // Small edges at the left of the bottom and at the right of the top.
    expect_good(d,
                place(d, 16,
                      [&](int i, int j) {
                          const double low = g(i), high = 1 - g(16 - i), t = j / 16.0;
                          return Vector2d((1 - t) * low + t * high, t);
                      }),
                0.7);
}

TEST(Embed, ScaleAndPlaceDoNotMatter) {
    const Disk d = disk(surround(grid(5, 5), 4));
    const Points loop = star(d.boundary, 0.2);
    Points far;
    for (const auto &p : loop)
        far.push_back(1e-3 * p + Vector2d(50, -70));
    EXPECT_NEAR(embedded(d, loop).min_scaled_jacobian, embedded(d, far).min_scaled_jacobian, 1e-3);
}

TEST(Embed, SameInputSameBits) {
    const Disk d = disk(surround(grid(5, 5), 4));
    EXPECT_EQ(embedded(d, star(d.boundary, 0.35)).positions, embedded(d, star(d.boundary, 0.35)).positions);
}

TEST(Embed, RefusesLoopsWithoutAValidEmbedding) {
    const Disk d = disk(grid(4, 4));
    Points loop = place(d, 4, [](int i, int j) { return Vector2d(i, j); });
    const Points square = loop;
    loop[0] = {0.5, 0.5}; // the one face at the corner would get 180 degrees
    EXPECT_FALSE(embedded(d, loop).valid);
    loop[0] = {1.5, 1.5}; // or more
    EXPECT_FALSE(embedded(d, loop).valid);
    loop = square;
    std::reverse(loop.begin(), loop.end()); // clockwise
    EXPECT_FALSE(embedded(d, loop).valid);
    loop = square;
    loop[3] = loop[2];
    EXPECT_FALSE(embedded(d, loop).valid);
    EXPECT_FALSE(embedded(d, Points(square.size(), Vector2d(1, 1))).valid);
    EXPECT_TRUE(embedded(d, square).valid);
}

TEST(EmbedOnCircle, EveryFaceIsConvexAndEveryFreeVertexIsAMean) {
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

} // namespace
