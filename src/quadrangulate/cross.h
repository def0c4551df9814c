// Flat quads that are cut in four triangles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/sides.h"
#include "quadrangulate/pairing.h"

namespace alphamst::quadrangulate {

struct Surroundings {
    mesh::Coordinates points;
    mesh::Faces faces;
    const TriangleSides &sides;
};

// Four triangles around the vertex of a corner that are flat and together a convex quad, no side
// between them being barred, nor the vertex held. Two of them in a pair make a corner of about 180 degrees,
// and two such pairs share two sides, which no smoothing mends.
std::optional<Cross> cross_around(const Surroundings &mesh, std::int32_t corner);

// The crosses around these corners and those that follow from cross to cross over common sides, without
// those that have a face that is taken; takes the faces of the others.
std::vector<Cross> crosses_from(const Surroundings &mesh, const std::vector<std::int32_t> &corners,
                                std::vector<bool> &taken);

} // namespace alphamst::quadrangulate
