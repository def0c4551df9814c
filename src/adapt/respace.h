// Vertices of the boundary come and go where its edges are not as long as is wanted.
#pragma once

#include <cstdint>
#include <span>

#include "adapt/sweep.h"

namespace alphamst::adapt {

struct RespacingPass {
    int size;     // of its windows
    double slack; // see Pass
    double shape; // part of the shape that windows keep
};

// Changes that a caller asks for may be steep.
std::span<const RespacingPass> respacings(bool wished);

Pass pass_of(const RespacingPass &respacing, const refill::ShapeBounds &shape);

// Gives the reference of a plane mesh its boundary and how long edges on it shall be, once it has its sizes:
// as the field "size" says, or as long as they are, times the change of faces, but no shorter than these are
// wide. mesh, reference and sizing must stay where they are.
void want_boundary(const mesh::QuadMesh &mesh, reference::Reference &reference,
                   const reference::SizingField &sizing, std::int64_t wanted);

} // namespace alphamst::adapt
