// A mesh as a picture: elements, patches and singularities.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/arrays.h"

namespace alphamst::draw {

// From the middle of one edge to that of another.
struct Polyline {
    std::array<std::int32_t, 2> from, to; // vertices
    std::int64_t number;                  // equal ones have the same colour
};

struct Picture {
    const io::Arrays *mesh = nullptr;
    std::vector<std::vector<std::int32_t>> outlines; // closed loops of vertices
    std::vector<Polyline> lines;
    std::vector<std::int32_t> singular3, singular5, singular_other; // vertices
    std::vector<double> errors; // [face] log2(area / wanted area), in colour; empty: not told
};

// The mesh with its singularities (interior vertices of valence other than 4, found from the
// arrays alone) and no outlines. The picture points to the mesh.
Picture picture(const io::Arrays &mesh);

// Seen as project() in draw/view.h says. A curved mesh is shaded, and what lies behind its
// faces is left out; the numbers below the picture are those of all. Throws Failure io.
void write_svg(const std::string &path, const Picture &picture);

} // namespace alphamst::draw
