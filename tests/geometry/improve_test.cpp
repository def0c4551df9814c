#include <gtest/gtest.h>

#include "square.h"

namespace {

using namespace alphamst::geometry;
using samples::noisy;
using samples::Square;

double worst(const Square &s, std::size_t quad, const Points &points) {
    return judge(Quads(&s.quads[quad], 1), points).min_determinant;
}

TEST(Improve, NeverLowersTheWorstScaledJacobian) {
    for (unsigned seed = 0; seed < 40; ++seed)
        for (const double noise : {0.1, 0.3, 0.5})
            for (const int steps : {1, 3, 20}) {
                const Square s = noisy(8, noise, seed);
                EmbedOptions options;
                options.steps = steps;
                const Embedding before = judge(s.quads, s.points),
                                after = improve(s.quads, s.fixed, s.points, options);
                EXPECT_GE(after.min_scaled_jacobian, before.min_scaled_jacobian);
                for (std::size_t v = 0; v < s.points.size(); ++v)
                    if (s.fixed[v]) {
                        EXPECT_EQ(after.positions[v], s.points[v]);
                    }
            }
}

TEST(Improve, NoisyGridBecomesNearlySquare) {
    const Square s = noisy(8, 0.3, 1);
    const Embedding before = judge(s.quads, s.points), after = improve(s.quads, s.fixed, s.points, {});
    EXPECT_LT(before.min_scaled_jacobian, 0.6);
    EXPECT_GT(after.min_scaled_jacobian, 0.97);
}

TEST(Improve, UntanglesIfItCan) {
    const Square s = noisy(10, 1.5, 2);
    EXPECT_FALSE(judge(s.quads, s.points).valid);
    const Embedding after = improve(s.quads, s.fixed, s.points, {});
    EXPECT_TRUE(after.valid);
    EXPECT_GT(after.min_scaled_jacobian, 0.9);
}

TEST(Improve, KeepsPositiveCornersPositiveWhereSomeCannotBe) {
    Square s = noisy(8, 0.45, 3);
    s.points[0] = {0.8, 0.8}; // a fixed corner beyond repair
    const Embedding before = judge(s.quads, s.points), after = improve(s.quads, s.fixed, s.points, {});
    EXPECT_FALSE(after.valid);
    EXPECT_GE(after.min_scaled_jacobian, before.min_scaled_jacobian);
    double gain = 0;
    for (std::size_t q = 0; q < s.quads.size(); ++q) {
        if (worst(s, q, s.points) > 0) {
            EXPECT_GT(worst(s, q, after.positions), 0);
        }
        gain += worst(s, q, after.positions) - worst(s, q, s.points);
    }
    EXPECT_GT(gain, 1); // the rest is still improved
}

TEST(Improve, FreeBoundaryVerticesAndMeshesWithoutAreaAreHarmless) {
    Square s = noisy(4, 0.2, 4);
    std::fill(s.fixed.begin() + 1, s.fixed.end(), char(0));
    EXPECT_GE(improve(s.quads, s.fixed, s.points, {}).min_scaled_jacobian,
              judge(s.quads, s.points).min_scaled_jacobian);
    const Points flat(s.points.size(), Eigen::Vector2d(1, 2));
    EXPECT_FALSE(improve(s.quads, s.fixed, flat, {}).valid);
}

} // namespace
