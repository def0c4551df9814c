// Pieces of fillings that could not be given a shape, so that other fillings with the same
// piece at the same place need not be tried.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "fill/filling.h"

namespace alphamst::refill {

class Obstacles {
public:
    // The quads near `quad`, one that could not be opened. Ignored far from the boundary, where
    // the place cannot be told.
    void learn(const fill::Filling &filling, int quad);

    // Whether the filling has a learnt piece at its place.
    bool met_by(const fill::Filling &filling) const;

private:
    std::set<std::vector<int>> pieces_; // each begins with its boundary vertex
};

} // namespace alphamst::refill
