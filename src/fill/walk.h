// Search over the multiplicities of one template type for a face count.
#pragma once

#include <cstdint>
#include <vector>

#include "fill/layout.h"

namespace alphamst::fill {

struct WalkQuery {
    std::int64_t fewest_faces = 0, most_faces = 0; // accepted range
    std::int64_t faces = 0;                        // nearest to this is best
    int effort = 40;                               // steps
    std::uint64_t seed = 0;
};

struct Found {
    Multiplicities x;
    std::int64_t faces = 0;
};

// Climbs from x, which fits the sides, to where the product of the multiplicities is largest;
// walks from there towards the face count and collects what is in range on the way. Multiplicities
// above 10,000 are not walked.
std::vector<Found> walk(const Layout &type, const Multiplicities &x, const WalkQuery &query);

} // namespace alphamst::fill
