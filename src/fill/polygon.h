// Fillings of polygons (flat sides, corners of one face) by template types.
#pragma once

#include <cstdint>
#include <vector>

#include "fill/closed_form.h"
#include "fill/layout.h"

namespace alphamst::fill {

// A filling known by its numbers; build() makes it.
struct Template {
    const Layout *type = nullptr;
    Multiplicities x;
    int first_side = 0;    // the polygon's side that is the type's first one
    bool mirrored = false; // the type's sides run against the polygon's
    std::int64_t faces = 0;
    int singularities = 0;
    double evenness = 0; // sum of log x: large when no chord is thin
};

struct PolygonQuery {
    Sides sides;
    int singularities = 0;
    std::int64_t fewest_faces = 0, most_faces = 0; // accepted range
    std::int64_t faces = 0;                        // nearest to this is best
    std::uint64_t seed = 0;
    int effort = 40;     // steps of the search for the face count in each type
    int enough = 24;     // templates with exactly `faces` faces after which the search ends
    int walks = 1 << 20; // types and turns that are searched for the count; more if none is in range
};

// Templates that answer the query, nearest face count first, then the most even ones;
// at most `most` of them, all different.
std::vector<Template> solve(const PolygonQuery &query, std::size_t most);

// The filling, its boundary from the polygon's first corner.
Filling build(const Template &chosen, const Sides &sides);

} // namespace alphamst::fill
