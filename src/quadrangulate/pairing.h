// Which triangles of a mesh become a quad together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/sides.h"

namespace alphamst::quadrangulate {

// Of each corner, seen along the normal of the centre; the smallest is the scaled Jacobian.
std::array<double, 4> sines(mesh::Coordinates points, const std::array<std::int32_t, 4> &quad);
inline constexpr double flattest = 0.01; // of a corner that counts as convex

// What a triangle does with one of its sides; side -1: a quad, or a triangle without a mate.
struct Choice {
    enum class Kind : std::uint8_t {
        none,
        merge, // with the triangle across, its mate
        halve  // the side gets a midpoint, its mate across the side being in the same situation
    };
    Kind kind = Kind::none;
    std::int8_t side = -1;
    std::int32_t mate = -1; // -1: the side is on the boundary
};

// across: the corner on the other side of the edge of each corner, -1 at the boundary. Sides that are
// barred can only be halved.
std::vector<Choice> pair_triangles(mesh::Coordinates points, mesh::Faces faces,
                                   const std::vector<std::int32_t> &across, const std::vector<bool> &barred);

} // namespace alphamst::quadrangulate
