// Hanging nodes: vertices in the middle of an edge of a face that does not have them as corners.
#pragma once

#include <array>

#include "mesh/sides.h"

namespace alphamst::mesh {

struct Hanging {
    std::int32_t vertex;
    std::size_t edge; // place of that edge in the list
};

// Of edges with one face each: those along which others run from end to end. By edges, then along each.
std::vector<Hanging> find_hanging(Coordinates points, const std::vector<std::array<std::int32_t, 2>> &edges);

} // namespace alphamst::mesh
