// The ways to lay one quad on a front, and what then remains to be filled: what the exact filler
// tries at each step.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fill/filling.h"

namespace alphamst::fill {

// Singular vertices that a filling has, or still may have.
struct Budget {
    int v3, v5;
    int total() const { return v3 + v5; }
};

// A front part that remains to be filled after one quad; vertices name positions of the
// parent front, -1 and -2 the new vertices b and a.
struct Part {
    Word word;
    std::vector<int> vertices;
};

struct Branch {
    std::array<int, 4> quad; // positions in the front, -1 and -2 for new vertices
    Budget used{0, 0};
    std::vector<Part> parts;
};

// Calls visit for every quad on a fixed place of the front, its first corner among those with the fewest
// choices, else its first edge, that leaves fronts of even lengths without letters below 1: every filling
// within the budget has one of these quads there. Always in the same order.
void visit_branches(const Word &front, Budget budget, const std::function<void(Branch &)> &visit);

} // namespace alphamst::fill
