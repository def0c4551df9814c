// The alpha template for a flat boundary (Verma and Suresh): a core polygon with N corners, N
// transitional patches around it and N bridges from the boundary to the corners of the core.
#pragma once

#include <cstdint>
#include <vector>

#include "fill/polygon.h"

namespace alphamst::fill {

struct AlphaTemplate {
    Sides outer;                       // boundary edges of each transitional patch
    Sides core;                        // sides of the core
    int bridge = 1;                    // edges of every bridge: rings around the core where outer = core
    Template centre;                   // filling of the core
    std::vector<Template> transitions; // [N] fillings with sides outer_i, bridge, core_i, bridge
    std::int64_t faces = 0;
    int singularities = 0; // one valence-3 vertex a corner of the core, plus the parts' own
    double stretch = 0;    // 0: even; grows with thin cores, uneven sides and crowded rings
};

struct AlphaQuery {
    int perimeter = 0;
    int least_singularities = 4, most_singularities = 8;
    std::int64_t fewest_faces = 0, most_faces = 0, faces = 0;
    std::uint64_t seed = 0;
};

// Templates with exactly query.faces faces where there are any, else the nearest in range;
// fewest singularities first, then the least stretched. Numbers are known, nothing is built.
std::vector<AlphaTemplate> solve(const AlphaQuery &query, std::size_t most);

// The filling; outer corner 0 is boundary vertex `offset`.
Filling build(const AlphaTemplate &chosen, int offset);

} // namespace alphamst::fill
