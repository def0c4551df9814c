#include "draw/view.h"

#include <gtest/gtest.h>

#include "io/samples.h"

namespace alphamst::draw {
namespace {

namespace samples = io::samples;

TEST(View, TellsCurvedFromPlane) {
    EXPECT_FALSE(project(samples::grid(4, 2)).curved);
    EXPECT_TRUE(project(samples::grid(4, 3)).curved);
    EXPECT_TRUE(project(samples::sphere(4)).curved);
    io::Arrays tilted = samples::grid(4, 2);
    tilted.dim = 3;
    for (std::size_t i = 0; i < tilted.points.size(); i += 3)
        tilted.points[i + 2] = 0.3 * tilted.points[i] - 2 * tilted.points[i + 1];
    EXPECT_FALSE(project(tilted).curved);
}

TEST(View, SeesAnOpenMeshAlongItsMeanNormal) {
    io::Arrays roof;
    roof.points = {0, 0, 0, 0, 4, 0, 2, 4, 1, 2, 0, 1, 4, 0, 0, 4, 4, 0};
    roof.faces = {3, 2, 1, 0, 4, 5, 2, 3};
    const Drawing drawing = project(roof);
    EXPECT_TRUE(drawing.curved);
    for (std::size_t v = 0; v < 6; ++v) { // x to the right, y up
        EXPECT_NEAR(drawing.points[v][0], 2500 * roof.points[3 * v], 1e-6);
        EXPECT_NEAR(drawing.points[v][1], 2500 * roof.points[3 * v + 1], 1e-6);
        EXPECT_NEAR(drawing.points[v][2], 2500 * roof.points[3 * v + 2], 1e-6);
    }
}

// What a stool stands on is down, be that along z or along y. A ball stands along z.
TEST(View, StandsUpright) {
    io::Arrays ball = samples::sphere(8);
    for (const bool is_stool : {false, true})
        for (const std::size_t axis : {2u, 1u}) {
            if (axis == 1 && !is_stool)
                continue;
            io::Arrays mesh = ball;
            for (std::size_t v = 0; v < mesh.points.size(); v += 3)
                if (is_stool && mesh.points[v + axis] < -0.2)
                    mesh.points[v + axis] = -0.8;
            const Drawing drawing = project(mesh);
            std::size_t low = 0, high = 0;
            for (std::size_t v = 0; v < mesh.points.size() / 3; ++v) {
                low = mesh.points[3 * v + axis] < mesh.points[3 * low + axis] ? v : low;
                high = mesh.points[3 * v + axis] > mesh.points[3 * high + axis] ? v : high;
            }
            EXPECT_GT(drawing.points[high][1], drawing.points[low][1] + 5000);
            EXPECT_GT(drawing.points[high][2], drawing.points[low][2]); // from a little above
        }
}

// A disc shows its edge to who looks along the ground, and more to who looks from above.
TEST(View, LooksWhereMostIsSeen) {
    io::Arrays disc = samples::sphere(8);
    for (std::size_t v = 0; v < disc.points.size(); v += 3)
        disc.points[v] *= 0.1; // thin along x
    const Drawing drawing = project(disc);
    // Nearly along x: the disc is about as wide as high.
    EXPECT_GT(static_cast<double>(drawing.width), 0.9 * longer_side);
}

} // namespace
} // namespace alphamst::draw
