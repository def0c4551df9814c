// What moving vertices over a surface has spoiled goes back to where it was, and only that.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/surface_positions.h"

namespace alphamst::smooth {

// Takes vertices back from `on_surface` to `start` around the quads that `spoiled` names, which is asked anew
// each time, and around those on feature lines that have come past a neighbour, as when only that one was
// taken back: first near them, then farther and farther around. False if some are left after the last time.
// feature_lines: [vertex]; empty: there are none.
bool roll_back(geometry::Quads quads, const geometry::SurfacePositions &start,
               geometry::SurfacePositions &on_surface, std::span<const geometry::FeatureLine> feature_lines,
               const std::function<std::vector<int>()> &spoiled);

} // namespace alphamst::smooth
