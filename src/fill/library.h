// The template types: every layout with N corners and k singularities that the exact filler finds
// on small polygons. Made at first use, then shared by all threads.
#pragma once

#include <vector>

#include "fill/layout.h"

namespace alphamst::fill {

// Types with N = sides corners and k singularities, fewest chords last; empty where none are kept.
const std::vector<Layout> &types(int sides, int singularities);

// Whether there are any; makes none.
bool has_types(int sides, int singularities);

} // namespace alphamst::fill
