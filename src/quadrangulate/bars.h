// TriangleSides that two triangles shall not be paired over.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadrangulate/pairing.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// For each corner of these faces; origin: of each the face of the polygons whose marker counts, or empty.
// sharp_angle: between the normals of faces, in degrees; nothing is sharp where all z are equal.
std::vector<Bar> bars_of(const Polygons &polygons, mesh::Faces faces, std::span<const std::int32_t> origin,
                         const std::vector<std::int32_t> &across, double sharp_angle);

// The edges of barred sides, each once, smaller vertex first and ascending.
std::vector<std::array<std::int32_t, 2>> barred_edges(mesh::Faces faces, const std::vector<Bar> &bars);

} // namespace alphamst::quadrangulate
