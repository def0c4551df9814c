// In a plane: all vertices at once to where areas are as wanted.
#pragma once

#include "geometry/match_areas.h"

namespace alphamst::smooth {

// Newton's method, as areas travel farther by it than where vertices move one by one. No scaled Jacobian that
// was `enough` falls below that, and no other one falls; no corner inverts. Positions stay as they are if
// they are not valid.
void settle(geometry::Quads quads, std::vector<char> fixed, geometry::Points &positions,
            const geometry::WantedAreas &wanted, double weight, double enough,
            const geometry::EmbedOptions &options);

} // namespace alphamst::smooth
