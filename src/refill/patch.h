// A patch of the caller, one new filling: its border and all outside stays as it is.
#pragma once

#include <cstdint>
#include <vector>

#include "outcome.h"
#include "refill/evaluate.h"
#include "settings.h"

namespace alphamst::refill {

struct Proposal {
    Replacement replacement;
    std::vector<int> buffer; // faces around that were judged with it: samples of the surface may go to them
    Outcome outcome;         // outcome.fault: there is nothing to commit
    bool unchanged = false;  // nor is there where the filling that is there is the answer
    Trace trace;
};

// Never throws for reasons of the patch; these are in outcome.fault. The result depends on
// the arguments alone.
Proposal propose(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
                 const reference::Reference &reference);

// Puts it into the mesh; vertices that move with it, and what follows the mesh, are left to the caller.
mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Replacement &replacement);

// The whole count, rounded half away from zero.
std::int64_t wanted_faces(double alpha, std::size_t faces);

} // namespace alphamst::refill
