// Given quads as pairs of triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/sides.h"

namespace alphamst::quadrangulate {

struct Cut {
    std::vector<std::int32_t> faces, origin; // triangles; the face given that each is, or is half of
    std::vector<bool> diagonals;             // of each corner: its side is not one of the faces given
};

// The first corner that the diagonal of each quad is at, 0 or 1; -1 for triangles. Diagonals are parallel
// from quad to quad where that is possible: then two halves beyond a common side make a parallelogram, where
// with diagonals that meet they would make a triangle.
std::vector<std::int8_t> parallel_diagonals(mesh::Faces faces, const std::vector<std::int32_t> &across);

// Draws lots for the diagonals of quads at most so many layers from some faces.
void draw_diagonals(mesh::Faces faces, const std::vector<std::int32_t> &across,
                    const std::vector<std::int32_t> &near, int layers, std::uint64_t seed,
                    std::vector<std::int8_t> &diagonals);

// So that triangles among quads can be paired along paths that lead through quads. A quad with a corner of
// more than 180 degrees is cut from there.
Cut cut_quads(mesh::Coordinates points, mesh::Faces faces, const std::vector<std::int8_t> &diagonals);

} // namespace alphamst::quadrangulate
