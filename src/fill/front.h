// A front that advances into a disk by regular rows of quads, from whatever side is
// cheapest, until what is left has fewer corners.
#pragma once

#include "fill/filling.h"

namespace alphamst::fill {

struct Front {
    explicit Front(const Word &word);

    Word word;                             // faces still wanted at each front vertex
    std::vector<int> ids;                  // [word] vertices of the filling to be
    std::vector<std::array<int, 4>> quads; // laid so far
    int vertices = 0;                      // in use so far

    int corners() const;  // letters 1
    int concaves() const; // surplus of letters above 2

    // Lays one row of quads along the side between front positions i and j, two
    // corners with flat vertices between them. False, and nothing done, if the
    // neighbours beyond are corners too or the front would vanish.
    bool peel(std::size_t i, std::size_t j);

    // Peels the rows that bring the cheapest side to the nearest concave vertex, where
    // both cancel. False if no side can.
    bool cancel_concave();

    // One ring of quads along the whole front: convex corners and concave vertices move
    // inward unchanged. False if a side is too short.
    bool offset();

    // Closes the front with a filling of it (its boundary vertex i is front vertex i)
    // and returns the whole.
    Filling close(const Filling &rest, int boundary) const;
};

} // namespace alphamst::fill
