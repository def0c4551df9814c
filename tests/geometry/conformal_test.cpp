#include "geometry/parametrise.h"

#include <gtest/gtest.h>

#include "sheet.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

TEST(Conformal, GivesAFlatDiskBack) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Sheet sheet = flat(seed);
        const Points positions = conformal(sheet.disk());
        expect_distances(positions, sheet.points, 1);
        EXPECT_TRUE(bijective(sheet, positions)); // not its mirror image
        EXPECT_NEAR(stretch(sheet.disk(), positions), 1, 1e-9);
    }
}

TEST(Conformal, UnrollsHalfACylinder) {
    const int n = 20;
    const Sheet sheet(n, 8, [](double s, double t) {
        return Vector3d(std::cos(pi * s), 1.5 * (1 - t), std::sin(pi * s)); // from inside
    });
    const Sheet unrolled(
        n, 8, [](double s, double t) { return Vector3d(2 * n * std::sin(pi / 2 / n) * s, 1.5 * t, 0); });
    expect_distances(conformal(sheet.disk()), unrolled.points, 1);
}

TEST(Conformal, KeepsAngles) {
    for (const double size : {0.4, 0.7}) {
        const Sheet coarse = bowl(12, size), fine = bowl(24, size);
        const Points kept = conformal(coarse.disk());
        const double error = mean_angle_error(coarse, kept);
        EXPECT_TRUE(bijective(coarse, kept));
        EXPECT_LT(error, 2.5);
        EXPECT_LT(5 * error, mean_angle_error(coarse, mean_value_on_circle(coarse.disk())));
        EXPECT_NEAR(mean_angle_error(fine, conformal(fine.disk())) / error, 0.5, 0.02); // to nothing
    }
}

TEST(Conformal, NoPositionsWithoutASolution) {
    const Sheet point(4, 4, [](double, double) { return Vector3d(1, 2, 3); });
    EXPECT_TRUE(conformal(point.disk()).empty());
}

} // namespace
} // namespace alphamst::geometry
