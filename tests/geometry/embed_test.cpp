#include "geometry/embed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "disk.h"

namespace {

using namespace alphamst::geometry;
using namespace samples;
using Eigen::Vector2d;

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

} // namespace
