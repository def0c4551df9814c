#include "quadrangulate/cut.h"

#include "mesh/grids.h"
#include "quadrangulate/halve.h"
#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

Input grid(int nx, int ny) {
    const mesh::Grid plane = mesh::plane(nx, ny);
    Input input;
    input.points = plane.points;
    input.faces = plane.faces;
    for (std::size_t f = 0; f < input.n_faces(); f += 2) // whatever corner comes first
        std::rotate(input.faces.begin() + std::ptrdiff_t(4 * f),
                    input.faces.begin() + std::ptrdiff_t(4 * f) + 1,
                    input.faces.begin() + std::ptrdiff_t(4 * f) + 4);
    return input;
}

std::vector<std::int32_t> across(const Input &input) {
    return across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points()));
}

TEST(Cut, DiagonalsAreParallel) {
    const Input input = grid(5, 4);
    const Cut cut = cut_quads(input.points, input.faces, parallel_diagonals(input.faces, across(input)));
    ASSERT_EQ(cut.origin.size(), 2 * input.n_faces());
    double slope = 0;
    std::size_t diagonals = 0;
    for (std::size_t c = 0; c < cut.faces.size(); ++c)
        if (cut.diagonals[c]) {
            ++diagonals;
            const auto v = 3 * std::size_t(cut.faces[c]),
                       w = 3 * std::size_t(cut.faces[mesh::next_corner(cut.faces, c)]);
            const double here =
                (input.points[w + 1] - input.points[v + 1]) / (input.points[w] - input.points[v]);
            if (slope == 0)
                slope = here;
            EXPECT_NEAR(here, slope, 1e-9);
        }
    EXPECT_EQ(diagonals, cut.origin.size());
}

TEST(Cut, TrianglesStay) {
    const Input input = lattice(4, 4, 1, 3);
    const std::vector<std::int8_t> diagonals = parallel_diagonals(input.faces, across(input));
    const Cut cut = cut_quads(input.points, input.faces, diagonals);
    for (std::size_t f = 0; f < input.n_faces(); ++f)
        EXPECT_EQ(std::count(cut.origin.begin(), cut.origin.end(), std::int32_t(f)),
                  mesh::is_triangle(input.faces, f) ? 1 : 2);
}

TEST(Cut, FromAConcaveCorner) {
    Input input;
    input.points = {0, 0, 0, 2, -1, 0, 0.5, 0, 0, 2, 1, 0};
    input.add(0, 1, 2, 3);
    const Cut cut = cut_quads(input.points, input.faces, {1});
    EXPECT_GT(area(input.points, &cut.faces[0], 3), 0);
    EXPECT_GT(area(input.points, &cut.faces[4], 3), 0);
}

TEST(Cut, LotsAreDrawnNearOnly) {
    const Input input = grid(20, 20);
    const std::vector<std::int8_t> before(input.n_faces(), 0);
    std::vector<std::int8_t> diagonals = before;
    draw_diagonals(input.faces, across(input), {0}, 2, 1, diagonals);
    EXPECT_NE(diagonals, before);
    EXPECT_LE(std::count(diagonals.begin(), diagonals.end(), 1), 13); // of a diamond of two layers
}

} // namespace
} // namespace alphamst::quadrangulate
