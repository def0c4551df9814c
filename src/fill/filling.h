// A disk to be filled with quadrilaterals, and a filling of it. Combinatorics
// only: no coordinates and no mesh.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace alphamst::fill {

// The boundary word of a disk: for each boundary vertex, counter-clockwise, the
// number of faces wanted inside at it. 1 is a convex corner, 2 flat, 3 and more
// concave.
using Word = std::vector<int>;

// Quads over local vertices: 0 .. boundary-1 is the boundary loop in the order of
// the word, boundary .. vertices-1 are new. Corners counter-clockwise.
struct Filling {
    int boundary = 0;
    int vertices = 0;
    std::vector<std::array<int, 4>> quads;
};

// Adds the quads of part to whole: its boundary vertex i becomes vertex loop[i] of whole, its
// new vertices become new ones.
inline void append(Filling &whole, const Filling &part, const std::vector<int> &loop) {
    for (const auto &quad : part.quads) {
        std::array<int, 4> placed{};
        for (std::size_t k = 0; k < 4; ++k)
            placed[k] = quad[k] < part.boundary ? loop[static_cast<std::size_t>(quad[k])]
                                                : whole.vertices + quad[k] - part.boundary;
        whole.quads.push_back(placed);
    }
    whole.vertices += part.vertices - part.boundary;
}

} // namespace alphamst::fill
