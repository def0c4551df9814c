#include "geometry/approximation_error.h"

#include <gtest/gtest.h>

#include "laid.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(ApproximationError, IsNothingOnAPlane) {
    const auto plane = graph(8, [](double x, double y) { return 0.3 * x - 0.2 * y; });
    EXPECT_LT(Laid(*plane, {0.3, 0.1, 0}).distance(*plane), 1e-12);
}

TEST(ApproximationError, OfAnArchIsThatOfItsChords) {
    const double radius = 20;
    const auto arch =
        graph(256, [&](double x, double) { return std::sqrt(radius * radius - (x - 4) * (x - 4)); });
    const Laid laid(*arch, Vector3d::Zero());
    // A chord of length h is off by x (h - x) / 2 r, the mean square of that is h^4 / (120 r^2).
    EXPECT_NEAR(laid.distance(*arch), 1 / (std::sqrt(120.0) * radius), 0.1 / (std::sqrt(120.0) * radius));
    ApproximationError approximation_error(*arch, laid.quads, laid.on_surface);
    approximation_error.measure(laid.on_surface, {});
    for (const ApproximationError::Place &place : approximation_error.at(20))
        EXPECT_LT(place.distance, 0); // chords lie below
}

TEST(ApproximationError, KnowsAreasAndSignedDistances) {
    const auto plane = graph(8, [](double x, double) { return 0.75 * x; });
    const Vector3d normal(-0.6, 0, 0.8);
    for (const double above : {-0.1, 0.2}) {
        Laid laid(*plane, Vector3d::Zero());
        for (Vector3d &p : laid.on_surface.points)
            p += above * normal;
        ApproximationError approximation_error(*plane, laid.quads, laid.on_surface);
        approximation_error.measure(laid.on_surface, {});
        for (std::size_t q = 0; q < laid.quads.size(); ++q) {
            EXPECT_NEAR(approximation_error.area(q), 1.25, 1e-12);
            EXPECT_NEAR(approximation_error.mean_square(q), above * above, 1e-12);
            for (const ApproximationError::Place &place : approximation_error.at(q)) {
                EXPECT_NEAR(place.distance, above, 1e-12);
                EXPECT_LT((place.normal - normal).norm(), 1e-12);
                EXPECT_NEAR(place.weights[0] + place.weights[1] + place.weights[2] + place.weights[3], 1,
                            1e-12);
            }
        }
        EXPECT_NEAR(approximation_error.mean_area(), 1.25, 1e-12);
        EXPECT_NEAR(approximation_error.mean_square(), above * above, 1e-12);
    }
}

} // namespace
} // namespace alphamst::geometry
