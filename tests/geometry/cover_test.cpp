#include "geometry/cover.h"

#include <gtest/gtest.h>

#include "laid.h"

namespace alphamst::geometry {
namespace {

using namespace samples;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

TEST(Cover, FindsThePlacesNearestToSamples) {
    const auto plane = graph(8, [](double, double) { return 0.0; });
    const Laid laid(*plane, Vector3d::Zero());
    const Stars stars(laid.quads, static_cast<int>(laid.on_surface.points.size()));
    const std::vector<Sample> samples = {
        {{2.25, 3.5, 0.5}, 8 * 3 + 2}, {{4, 4, -1}, 8 * 4 + 4}, {{5.5, 1.5, 0}, 8 * 2 + 4}, {{9, 0.5, 0}, 7}};
    Cover cover(laid.quads, stars, samples);
    cover.measure(laid.on_surface, {});
    const double distances[] = {0.5, 1, 0, 1};
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(cover.place(i).distance, distances[i], 1e-12) << i;
    EXPECT_LT((cover.place(0).normal - Vector3d(0, 0, -1)).norm(), 1e-12);
    EXPECT_LT((cover.place(3).normal - Vector3d(-1, 0, 0)).norm(), 1e-12);
    // The third goes over to the quad across the corner that holds it.
    ASSERT_EQ(cover.at(8 * 1 + 5).size(), 1u);
    EXPECT_EQ(cover.at(8 * 1 + 5)[0], 2);
    Vector3d place = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
        place += cover.place(0).weights[k] * laid.on_surface.points[at(laid.quads[8 * 3 + 2][k])];
    EXPECT_LT((place - Vector3d(2.25, 3.5, 0)).norm(), 1e-12);
}

} // namespace
} // namespace alphamst::geometry
