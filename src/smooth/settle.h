// In a plane: all vertices at once to where areas are as wanted.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geometry/match_areas.h"

namespace alphamst::smooth {

// The positions that `improve` comes to, once it spoils no quad: the vertices of those that `spoiled` names
// are fixed the next time. Nothing if some are left after eight times.
std::optional<geometry::Points>
improve_without_spoiling(geometry::Quads quads, std::vector<char> &fixed,
                         const std::function<geometry::Points(std::span<const char> fixed)> &improve,
                         const std::function<std::vector<int>(const geometry::Points &)> &spoiled);

// Newton's method, as areas travel farther by it than where vertices move one by one. No scaled Jacobian that
// was `enough` falls below that, and no other one falls; no corner inverts. Positions stay as they are if
// they are not valid.
void settle(geometry::Quads quads, std::vector<char> fixed, geometry::Points &positions,
            const geometry::WantedAreas &wanted, double weight, double enough,
            const geometry::EmbedOptions &options);

} // namespace alphamst::smooth
