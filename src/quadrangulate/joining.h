// Quads out of what triangles do with each other.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "quadrangulate/pairing.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// The triangles that were paired, some of which may be halves of quads given.
struct Triangles {
    mesh::Faces faces;
    std::span<const std::int32_t> origin; // of each the face given, or empty: itself
    mesh::Faces given;
    const TriangleSides &sides;
    const Pairing &pairing;
};

// Makes one face of each two that are merged or four that are a cross, at the place of the first, and quads
// of those that have a side halved. Returns the sides that lead to midpoints.
std::vector<std::array<std::int32_t, 2>> join(const Triangles &paired, QuadArrays &quads);

} // namespace alphamst::quadrangulate
