// A layout: the blocks that remain of a filling when every regular line of edges is
// taken out. Its chords carry multiplicities; the singularities do not depend on them,
// side lengths are linear and the face count is quadratic in them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fill/filling.h"
#include "fill/move.h"

namespace alphamst::fill {

using Multiplicities = std::vector<int>; // [chords], each at least 1

struct Layout {
    int sides = 0;
    int v3 = 0, v5 = 0;
    Filling blocks;           // one quad a block, boundary from the first corner
    std::vector<int> corners; // [sides] boundary vertices, the first is 0
    int chords = 0;
    std::vector<std::array<int, 2>> crossing; // [blocks] chords across edges 0-1 and 1-2
    std::vector<std::vector<int>> incidence;  // [sides][chords] ends of the chord on the side
    std::vector<std::vector<int>> product;    // [chords][chords] symmetric: faces = x' product x / 2
    // For templates only:
    struct Turn { // a chord and the sides it ends on
        struct End {
            std::size_t side;
            int count, later; // ends on the side; chords after this one that also have some
        };
        std::size_t chord;
        std::vector<End> ends;
    };
    std::vector<Turn> order; // in which start values are given
    std::vector<Move> moves;

    int singularities() const { return v3 + v5; }
};

// Fills in everything but blocks, corners, v3, v5, order and moves.
void complete(Layout &layout);
// The layout of a filling with corners at these boundary vertices (ascending, the
// first is 0).
Layout extract(const Filling &filling, const std::vector<int> &corners);
// The filling with x_j copies of chord j; its boundary starts at the first corner.
Filling expand(const Layout &layout, const Multiplicities &x);
// Side lengths and face count for multiplicities.
std::vector<int> side_lengths(const Layout &layout, const Multiplicities &x);
std::int64_t face_count(const Layout &layout, const Multiplicities &x);
// Equal for layouts that are equal up to rotation and reflection of the corners.
std::vector<int> signature(const Layout &layout);

// The same filling with the boundary read backwards from vertex 0.
Filling mirrored(const Filling &filling);
// The same filling with boundary vertex `first` as the new first one.
Filling rotated(const Filling &filling, int first);

} // namespace alphamst::fill
