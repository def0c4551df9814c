#include "geometry/quad.h"

#include <gtest/gtest.h>

#include <random>

#include "adapt/meshes.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

Quad flat(double x0, double y0, double x1, double y1, double x2, double y2, double x3, double y3) {
    return {Vector3d(x0, y0, 0), Vector3d(x1, y1, 0), Vector3d(x2, y2, 0), Vector3d(x3, y3, 0)};
}

const Quad square = flat(0, 0, 1, 0, 1, 1, 0, 1);
const Quad dart = flat(0, 0, 2, 0, 0.5, 0.5, 0, 2); // reflex at its corner 2

Vector3d place(const Quad &quad, const QuadPoint &spot) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GE(spot.weights[i], 0);
        sum += spot.weights[i] * quad[i];
    }
    return sum;
}

TEST(Quad, NearestSpotIsThePointItselfInside) {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        const Vector3d p(adapt::samples::chance(random), adapt::samples::chance(random), 0);
        const QuadPoint spot = closest_point(square, p);
        EXPECT_LT((place(square, spot) - p).norm(), 1e-15);
        EXPECT_LT(spot.distance, 1e-30);
    }
}

TEST(Quad, NearestSpotInASlenderQuad) {
    std::mt19937 random(2);
    for (const double width : {1e-2, 1e-3, 1e-4})
        for (int i = 0; i < 2000; ++i) {
            const auto any = [&](double most) { return most * adapt::samples::chance(random); };
            Quad quad = flat(0, 0, 1, any(width / 3), 1.1, width, -any(0.2), width);
            for (Vector3d &corner : quad) // not along an axis
                corner = {3 + 0.8 * corner.x() - 0.6 * corner.y(), 5 + 0.6 * corner.x() + 0.8 * corner.y(),
                          0};
            const double a = any(1), b = any(1);
            const Vector3d p =
                (1 - a) * ((1 - b) * quad[0] + b * quad[3]) + a * ((1 - b) * quad[1] + b * quad[2]);
            EXPECT_LT((place(quad, closest_point(quad, p)) - p).norm(), 1e-12) << "width " << width;
        }
}

TEST(Quad, NearestSpotOutside) {
    const auto expect = [](const Quad &quad, const Vector3d &from, const Vector3d &to) {
        const QuadPoint spot = closest_point(quad, from);
        EXPECT_LT((place(quad, spot) - to).norm(), 1e-15);
        EXPECT_NEAR(spot.distance, (from - to).squaredNorm(), 1e-15);
    };
    expect(square, {-1, -2, 0}, {0, 0, 0});
    expect(square, {0.25, -2, 1}, {0.25, 0, 0});
    expect(square, {3, 0.75, 0}, {1, 0.75, 0});
    expect(square, {2, 2, 0}, {1, 1, 0});
    expect(square, {-5, 0.5, 0}, {0, 0.5, 0});
    expect(square, {0.25, 0.5, -3}, {0.25, 0.5, 0});
    expect(dart, {0.5, 0.5, 0}, {0.5, 0.5, 0});
    expect(dart, {0.75, 0.6, 0}, {0.695, 0.435, 0}); // not through the notch
    const Quad point = flat(1, 1, 1, 1, 1, 1, 1, 1);
    expect(point, {2, 1, 0}, {1, 1, 0});
}

TEST(Quad, OverlapOfSquares) {
    EXPECT_DOUBLE_EQ(overlap(square, square).area, 1);
    EXPECT_DOUBLE_EQ(overlap(square, flat(0.5, 0.25, 1.5, 0.25, 1.5, 1.25, 0.5, 1.25)).area, 0.375);
    EXPECT_DOUBLE_EQ(overlap(square, flat(-1, -1, 2, -1, 2, 2, -1, 2)).area, 1);
    EXPECT_DOUBLE_EQ(overlap(flat(-1, -1, 2, -1, 2, 2, -1, 2), square).area, 1);
    EXPECT_EQ(overlap(square, flat(1, 0, 2, 0, 2, 1, 1, 1)).area, 0); // a side in common
    EXPECT_EQ(overlap(square, flat(0, 1, 1, 1, 1, 0, 0, 0)).area, 0); // from below
    EXPECT_EQ(overlap(flat(1, 1, 1, 1, 1, 1, 1, 1), square).area, 0);
}

TEST(Quad, OverlapFollowsAReflexCorner) {
    EXPECT_DOUBLE_EQ(overlap(dart, flat(0, 0, 2, 0, 2, 2, 0, 2)).area, 1);
    EXPECT_DOUBLE_EQ(overlap(flat(0, 0, 2, 0, 2, 2, 0, 2), dart).area, 1);
    EXPECT_EQ(overlap(dart, flat(0.75, 0.75, 1, 0.75, 1, 1, 0.75, 1)).area, 0);
}

TEST(Quad, OverlapIsSeenAlongTheNormal) {
    Quad tilted = square; // 45 degrees about the x axis, as high as the unit square
    tilted[2].z() = tilted[3].z() = 1;
    EXPECT_NEAR(overlap(square, tilted).area, 1, 1e-15);
    EXPECT_NEAR(overlap(tilted, square).area, std::sqrt(0.5), 1e-15);
}

TEST(Quad, OverlapHasACentroid) {
    const auto expect = [](const Quad &quad, const Quad &other, const Eigen::Vector3d &place) {
        EXPECT_LT((overlap(quad, other).centroid - place).norm(), 1e-15);
    };
    expect(square, square, {0.5, 0.5, 0});
    expect(square, flat(0.5, 0.25, 1.5, 0.25, 1.5, 1.25, 0.5, 1.25), {0.75, 0.625, 0});
    expect(flat(0, 0, 2, 0, 2, 2, 0, 2), dart, area_centroid(dart));
    expect(flat(-9, -9, 9, -9, 0, 9, -9, 9), flat(1, 1, 4, 1, 1, 4, 1, 2), {2, 2, 0}); // a triangle
}

TEST(Quad, CentroidIsThatOfTheArea) {
    EXPECT_LT((area_centroid(square) - Eigen::Vector3d(0.5, 0.5, 0)).norm(), 1e-15);
    EXPECT_LT((area_centroid(flat(1, 1, 4, 1, 1, 4, 1, 2)) - Eigen::Vector3d(2, 2, 0)).norm(), 1e-15);
    EXPECT_LT((area_centroid(flat(1, 1, 1, 1, 1, 1, 1, 1)) - Eigen::Vector3d(1, 1, 0)).norm(), 1e-15);
}

// Linear functions go on beyond the quad; from a triangle that is nearly a line nothing can be told.
TEST(Quad, ContinuedPointKeepsLinearFunctions) {
    const Quad kite = flat(0, 0, 2, 0.5, 3, 3, 0.25, 1.5);
    for (const Eigen::Vector3d &p :
         {Eigen::Vector3d(1, 1, 0), {2.5, 1, 0}, {-0.5, -0.25, 0}, {3.5, 3.25, 0}, {-0.5, 1.5, 0}}) {
        const QuadPoint place = continued_point(kite, p);
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < 4; ++i)
            sum += place.weights[i] * kite[i];
        EXPECT_LT((sum - p).norm(), 1e-14);
    }
    const Quad line = flat(0, 0, 1, 0, 2, 1e-9, 0.5, 0);
    const QuadPoint place = continued_point(line, {1, -1, 0}), nearest = closest_point(line, {1, -1, 0});
    EXPECT_EQ(place.weights, nearest.weights);
}

} // namespace
} // namespace alphamst::geometry
