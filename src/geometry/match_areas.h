// Positions that give every quad the area that is wanted where it lies.
#pragma once

#include <functional>

#include "geometry/embed.h"

namespace alphamst::geometry {

// Negative where the quad runs clockwise.
double signed_area(const std::array<int, 4> &quad, const Points &positions);

// [quad] Areas wanted of quads at these positions, whatever they sum up to.
using WantedAreas = std::function<std::vector<double>(const Points &positions)>;

// From valid positions: Newton's method on all free vertices at once, as areas travel too slowly where
// vertices move one by one. `weight` in 0 .. 1 is that of areas against shapes. No corner inverts, but the
// smallest scaled Jacobian may fall.
Embedding match_areas(Quads quads, std::span<const char> fixed, Points positions, const WantedAreas &wanted,
                      double weight, const EmbedOptions &options);

} // namespace alphamst::geometry
