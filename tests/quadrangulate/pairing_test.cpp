#include "quadrangulate/pairing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "quadrangulate/halve.h"
#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using namespace triangles;

TEST(Pairing, ClosedSurfacesLeaveNoTriangle) {
    std::vector<Input> inputs{octahedron(), sphere(1), sphere(4), globe(7, 4), globe(60, 31), globe(3, 2)};
    for (unsigned seed = 0; seed < 60; ++seed)
        inputs.push_back(random_sphere(seed, 3 + 11 * int(seed)));
    for (const Input &input : inputs) {
        const QuadArrays quads = input.quads();
        const mesh::QuadMesh mesh = expect_sound(input, quads);
        expect_pairs(input, quads);
        EXPECT_NO_THROW(mesh.check());
    }
}

TEST(Pairing, ASmoothSphereHasConvexQuads) { EXPECT_GT(smallest_sine(sphere(4).quads()), 0.05); }

TEST(Pairing, AnEvenDiscKeepsItsBoundary) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Input input = lattice(5 + int(seed), 7, seed);
        const QuadArrays quads = input.quads();
        expect_pairs(input, quads);
        EXPECT_NO_THROW(expect_sound(input, quads, 2).check());
        EXPECT_GT(smallest_sine(quads), 0.2);
    }
}

// Whether the triangles that are not taken make convex quads in pairs, by trying everything.
bool can_be_convex(const Input &input, const std::vector<std::int32_t> &across, std::vector<bool> &taken) {
    const auto first = std::find(taken.begin(), taken.end(), false);
    if (first == taken.end())
        return true;
    const auto f = static_cast<std::size_t>(first - taken.begin());
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t c = across[4 * f + k];
        if (c < 0 || taken[std::size_t(c / 4)])
            continue;
        const std::size_t g = std::size_t(c / 4), l = std::size_t(c % 4);
        const std::int32_t *t = &input.faces[4 * f], *u = &input.faces[4 * g];
        if (least_sine(input.points, {t[k], u[(l + 2) % 3], t[(k + 1) % 3], t[(k + 2) % 3]}) < 0.01)
            continue;
        taken[f] = taken[g] = true;
        if (can_be_convex(input, across, taken))
            return true;
        taken[f] = taken[g] = false;
    }
    return false;
}

TEST(Pairing, QuadsAreConvexIfTheyCanBe) {
    int can = 0, trials = 100;
    for (int seed = 0; seed < trials; ++seed) {
        const Input input = disc(6, 4, unsigned(seed));
        std::vector<bool> taken(input.n_faces());
        if (!can_be_convex(input, across_edges(input.faces, mesh::pair_sides(input.faces, input.n_points())),
                           taken))
            continue;
        ++can;
        const QuadArrays quads = input.quads();
        expect_pairs(input, quads);
        EXPECT_NO_THROW(expect_sound(input, quads, 2).check()) << seed;
    }
    EXPECT_GT(can, trials / 4);
    EXPECT_LT(can, trials);
}

} // namespace
} // namespace alphamst::quadrangulate
