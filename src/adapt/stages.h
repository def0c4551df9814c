// The stages of the work on a whole mesh: sweeps with windows that grow until nothing improves, then the
// exact number of faces, then the shape of all.
#pragma once

#include <cstdint>
#include <optional>

#include "adapt/align.h"
#include "adapt/ground.h"

namespace alphamst::adapt {

struct Aim {
    std::int64_t faces = 0;
    bool exact = true; // otherwise that many within a few percent
    // If given, there are no more singular vertices in the end than at first, and on the way no more than so
    // many times as many, unless what is asked for cannot be had.
    std::optional<double> room;
};

// ground: that of the mesh, with coverage where it is curved. crosses: the field that edges turn to at last.
void work_through(mesh::QuadMesh &mesh, Ground &ground, const Aim &aim, const std::optional<Crosses> &crosses,
                  const Settings &settings, const Progress &progress);

} // namespace alphamst::adapt
