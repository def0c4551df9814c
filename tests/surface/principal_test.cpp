#include "surface/principal.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// Ways around a quad of a surface with these curvatures along `first` and at right angles to it.
std::array<Bend, 4> bends(const Vector3d &normal, const Vector3d &first, double k1, double k2) {
    const Vector3d second = normal.cross(first);
    std::array<Bend, 4> result;
    const std::array<std::array<double, 2>, 4> ways{{{0.3, 0.1}, {-0.2, 0.4}, {-0.4, -0.1}, {0.3, -0.4}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [x, y] = ways[i];
        result[i] = {x * first + y * second, k1 * x * first + k2 * y * second};
    }
    return result;
}

TEST(Principal, DeviationIsHalfTheDifferenceOfCurvatures) {
    const Vector3d normal = Vector3d(1, -2, 0.5).normalized();
    const Vector3d first = normal.cross(Vector3d(0.3, 0.2, 1)).normalized();
    const Frame frame(normal);
    for (const auto &[k1, k2] : {std::array{3.0, 1.0}, {1.0, -1.0}, {0.5, 0.0}}) {
        const Complex found = deviation(frame, bends(normal, first, k1, k2));
        EXPECT_NEAR(length(found), (k1 - k2) / 2, 1e-12);
        EXPECT_NEAR(std::abs(frame.at(half(unit(found, {}))).dot(first)), 1, 1e-12);
    }
    EXPECT_NEAR(length(deviation(frame, bends(normal, first, 2, 2))), 0, 1e-12); // as on a sphere
}

TEST(Principal, DeviationOfWaysInOneLineIsNone) {
    const Frame frame(Vector3d::UnitZ());
    const std::array<Bend, 2> line{Bend{Vector3d::UnitX(), Vector3d::UnitX()},
                                   Bend{-Vector3d::UnitX(), Vector3d::UnitY()}};
    EXPECT_EQ(length(deviation(frame, line)), 0);
    EXPECT_EQ(length(deviation(frame, {})), 0);
}

TEST(Principal, AverageIsOfWhatTheSameDirectionIsInOtherFrames) {
    Links links;
    links.frames = {Frame(Vector3d::UnitZ()), Frame(Vector3d(0, 0.6, 0.8)), Frame(Vector3d(0, -0.6, 0.8))};
    links.begin = {0, 2, 3, 4};
    links.neighbours = {1, 2, 0, 0};
    links.weights = {1, 1, 1, 1};
    std::vector<Complex> deviations;
    for (const Frame &frame : links.frames) // all along x, which all three planes have
        deviations.push_back(square(frame.of(Vector3d::UnitX())));
    deviations[0] = 3 * deviations[0];
    average(links, deviations, 1);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(length(deviations[i]), 2, 1e-12);
        EXPECT_NEAR(std::abs(links.frames[i].at(half(unit(deviations[i], {}))).x()), 1, 1e-12);
    }
}

TEST(Principal, TransportThereAndBackIsNothing) {
    const Frame one(Vector3d(1, 2, 2) / 3), other(Vector3d(2, -1, 2) / 3);
    const Complex both = transport(one, other) * transport(other, one);
    EXPECT_NEAR(both.re, 1, 1e-15);
    EXPECT_NEAR(both.im, 0, 1e-15);
    // What both planes have stays where it is.
    const Vector3d common = Vector3d(1, 2, 2).cross(Vector3d(2, -1, 2)).normalized();
    EXPECT_LT((other.at(transport(one, other) * one.of(common)) - common).norm(), 1e-15);
}

} // namespace
} // namespace alphamst::surface
