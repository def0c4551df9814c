#include "draw/shade.h"

#include <gtest/gtest.h>

#include "io/samples.h"

namespace alphamst::draw {
namespace {

namespace samples = io::samples;

bool is_sand(const std::string &tone) { return tone.substr(1, 2) > tone.substr(5, 2); } // more red than blue

TEST(Shade, DrawsWhatIsInFrontLast) {
    // A cube behind a smaller one, and one within it that nothing of is to be seen.
    const io::Arrays cube = samples::cube();
    io::Arrays cubes;
    for (const auto &[size, x] : {std::pair(1.0, 0.0), std::pair(0.8, 0.1), std::pair(0.5, 1.5)}) {
        const auto first = static_cast<std::int32_t>(cubes.points.size() / 3);
        for (double c : cube.points)
            cubes.points.push_back(size * c + x);
        for (std::int32_t v : cube.faces)
            cubes.faces.push_back(first + v);
    }
    const Drawing drawing = project(cubes);
    ASSERT_TRUE(drawing.curved);
    const Scene scene(cubes, drawing);
    ASSERT_EQ(scene.faces().size(), 6u);
    const double near = drawing.points[16][2], far = drawing.points[0][2];
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_EQ(scene.faces()[k] >= 12, (k < 3) == (near < far));
    for (std::size_t f : scene.faces())
        EXPECT_FALSE(is_sand(scene.tone(f)));
    for (std::int32_t v = 8; v < 16; ++v)
        EXPECT_FALSE(scene.shows(v));
    int n_shown = 0;
    for (std::int32_t v = 0; v < 8; ++v)
        n_shown += scene.shows(v);
    EXPECT_GE(n_shown, 6);
    EXPECT_LE(n_shown, 7);
}

// A depth buffer alone cannot tell the two sides of a sheet.
TEST(Shade, HidesTheVertexBehindAThinPlate) {
    io::Arrays plate = samples::cube();
    for (std::size_t i = 2; i < plate.points.size(); i += 3)
        plate.points[i] *= 1e-4;
    const Drawing drawing = project(plate);
    const Scene scene(plate, drawing);
    std::int32_t farthest_below = 0, n_shown = 0;
    for (std::int32_t v = 0; v < 4; ++v)
        if (drawing.points[static_cast<std::size_t>(v)][2] <
            drawing.points[static_cast<std::size_t>(farthest_below)][2])
            farthest_below = v;
    for (std::int32_t v = 0; v < 8; ++v)
        n_shown += scene.shows(v);
    EXPECT_FALSE(scene.shows(farthest_below));
    EXPECT_EQ(n_shown, 7);
}

TEST(Shade, ShowsTheInsideOfATubeInAnotherColour) {
    io::Arrays tube = samples::cube();
    tube.faces.erase(tube.faces.begin(), tube.faces.begin() + 8); // no floor, no lid
    const Drawing drawing = project(tube);
    const Scene scene(tube, drawing);
    ASSERT_EQ(scene.faces().size(), 4u);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(is_sand(scene.tone(scene.faces()[k])), k < 2);
}

} // namespace
} // namespace alphamst::draw
