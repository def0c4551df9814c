// Several searches with different luck, of which the best is kept.
#pragma once

#include <cstdint>
#include <functional>
#include <tuple>

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::adapt {

// One search: changes the mesh. Its settings ask for one start.
using Search =
    std::function<Outcome(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress)>;

// What an outcome costs; the least is the best.
using Price = std::tuple<bool, bool, std::int64_t, double>;

// The mesh that the best of Settings::starts searches of it makes, the first of equals. They share the
// threads; the result is the same for any number of these. The first has the seed of the settings, so that
// more starts never cost more.
Outcome best_of_starts(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress,
                       const Search &search, const std::function<Price(const Outcome &)> &price);

} // namespace alphamst::adapt
