// What a new filling of a cavity is to be.
#pragma once

#include <cstdint>
#include <limits>

namespace alphamst::refill {

struct Goal {
    std::int64_t faces = 0;    // wanted
    bool any_count = false;    // fewest singularities first, faces only as near as possible
    bool keep_quality = false; // prefer fillings whose smallest scaled Jacobian is not below the old one
    bool sizes = false;        // faces get the areas that RegionSizes wants
    bool forbid_old = false;   // the old filling is no answer
    bool turn = false;         // towards the cross field of the reference
    bool or_nearest = false;   // where that many faces cannot be had, as near to it as can be
    bool last_try = true;      // otherwise it is asked for again with a larger tolerance of distances
    bool respace = false;      // the boundary of the mesh gets the vertices that are wanted there
    bool collapse = false;     // quads of the old filling collapsed, nothing else
    std::int64_t fewest = 0, most = 0; // any_count: faces in this range; 0: from half to twice as many
    int most_added = 1 << 20;          // singularities, those of the mesh boundary included
};

// Of some faces: smallest scaled Jacobian and shape (both Verdict's), and the numbers of poor and inverted
// quads. As bounds: how many quads may become poor for one singularity less.
struct ShapeBounds {
    double scaled_jacobian = 1, shape = 1, poor = 0;
    int inverted = 0;
};

} // namespace alphamst::refill
