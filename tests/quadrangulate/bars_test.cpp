#include "quadrangulate/bars.h"

#include "bodies.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

std::vector<Bar> bars(const Input &input, double angle) {
    return bars_of(input.polygons(), input.faces, {},
                   across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points())), angle);
}

TEST(Bars, SharpEdges) {
    const Input body = box(2, 3, 4, true);
    EXPECT_EQ(barred_edges(body.faces, bars(body, 40)).size(), 4U * (2 + 3 + 4));
    EXPECT_TRUE(barred_edges(body.faces, bars(body, 91)).empty());
    EXPECT_TRUE(barred_edges(body.faces, bars(body, 180)).empty());
}

TEST(Bars, NothingIsSharpInThePlane) {
    Input flat = lattice(4, 4, 1);
    flat.points[3 * 6] += 5; // faces there are turned over
    EXPECT_TRUE(barred_edges(flat.faces, bars(flat, 40)).empty());
    flat.points[2] = 1e-9;
    EXPECT_FALSE(barred_edges(flat.faces, bars(flat, 40)).empty());
}

TEST(Bars, CurvesAndRegions) {
    Input input = lattice(3, 3, 1);
    input.curves = {{input.faces[2], input.faces[1]}};
    EXPECT_EQ(barred_edges(input.faces, bars(input, 180)).size(), 1U);
    input.markers.assign(input.n_faces(), 1);
    for (std::size_t f = 0; f < 6; ++f)
        input.markers[f] = 2; // the lowest row
    EXPECT_EQ(barred_edges(input.faces, bars(input, 180)).size(), 3U + 1U);
}

// A fold that begins on the boundary and ends inside parts nothing.
TEST(Bars, ACreaseEndsInside) {
    Input input = lattice(6, 6, 1, 1000000, 0);
    const std::size_t raised = 3 * 7 + 3;
    input.points[3 * raised + 2] = 3;
    const std::vector<Bar> found = bars(input, 40);
    EXPECT_GT(std::count(found.begin(), found.end(), Bar::sharp), 0); // around the peak
    input = lattice(6, 6, 1, 1000000, 0);
    for (std::size_t v = 0; v < 3; ++v)
        input.points[3 * (3 * 7 + v) + 2] = 2;
    input.curves.clear();
    const std::vector<Bar> fold = bars(input, 100);
    EXPECT_EQ(std::count(fold.begin(), fold.end(), Bar::sharp), 0);
}

TEST(Bars, ARoughSurfaceHasNoSides) {
    Input input = sphere(4);
    std::mt19937 random(1);
    for (double &x : input.points)
        x += 0.05 * (double(random() % 1000) / 1000 - 0.5);
    EXPECT_TRUE(barred_edges(input.faces, bars(input, 40)).empty());
}

} // namespace
} // namespace alphamst::quadrangulate
