// Vertices of the boundary come and go where its edges are not as long as is wanted.
#pragma once

#include <array>
#include <cstdint>

#include "adapt/sweep.h"

namespace alphamst::adapt {

struct RespacingPass {
    int size;     // of its windows
    double shape; // part of the shape that windows keep
};

// Steep changes of sizes have to go on in several steps, and close corners that open later.
constexpr std::array<RespacingPass, 7> respacings = {
    {{16, 1}, {30, 1}, {60, 1}, {30, 0.6}, {60, 0.6}, {30, 0.4}, {60, 0.4}}};

Pass pass_of(const RespacingPass &respacing, const refill::ShapeBounds &shape);

// Gives the reference of a plane mesh its boundary and how long edges on it shall be, once it has its sizes:
// as the field "size" says, or as long as they are, times the change of faces, but no shorter than these are
// wide. mesh, reference and sizing must stay where they are.
void want_boundary(const mesh::QuadMesh &mesh, reference::Reference &reference,
                   const reference::SizingField &sizing, std::int64_t wanted);

} // namespace alphamst::adapt
