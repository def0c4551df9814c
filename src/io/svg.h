// A mesh as a picture: elements, patches and singularities.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/arrays.h"

namespace alphamst::io {

// From the middle of one edge to that of another.
struct Line {
    std::array<std::int32_t, 2> from, to; // vertices
    std::int64_t number;                  // equal ones have the same colour
};

struct Picture {
    const Arrays *mesh = nullptr;
    std::vector<std::vector<std::int32_t>> outlines; // closed loops of vertices
    std::vector<Line> lines;
    std::vector<std::int32_t> singular3, singular5, singular_other; // vertices
};

// The mesh with its singularities (interior vertices of valence other than 4, found from the
// arrays alone) and no outlines. The picture points to the mesh.
Picture picture(const Arrays &mesh);

// Seen along z when dim is 2, else along the mean normal (from a corner of the
// bounding box if there is none, as on a closed surface). Throws Failure io.
void write_svg(const std::string &path, const Picture &picture);

} // namespace alphamst::io
