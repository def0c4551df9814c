// The stages of the work on a whole mesh: sweeps with windows that grow until nothing improves, then the
// exact number of faces, then the shape of all.
#pragma once

#include <cstdint>
#include <optional>

#include "reference/reference.h"
#include "smooth/align.h"

namespace alphamst::adapt {

struct Aim {
    std::int64_t faces = 0;
    bool exact = true; // otherwise that many within a few percent
    // If given, there are no more singular vertices in the end than at first, and on the way no more than so
    // many times as many, unless what is asked for cannot be had.
    std::optional<double> room;
};

// reference: that of the mesh, with surface_distance where it is curved. cross_field: the field that edges
// turn to at last.
void run_schedule(mesh::QuadMesh &mesh, reference::Reference &reference, const Aim &aim,
                  const std::optional<reference::CrossField> &cross_field, const Settings &settings,
                  const Progress &progress);

} // namespace alphamst::adapt
