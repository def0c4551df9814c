// Smoothing of a whole mesh that keeps coarse regions coarse and fine ones fine, or makes them so.
#pragma once

#include "adapt/adapt.h"
#include "adapt/density.h"
#include "adapt/ground.h"

namespace alphamst::adapt {

// Moves all vertices that may move. The smallest scaled Jacobian of the mesh never falls, and no
// corner turns over.
void relax(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
           const Settings &settings);

} // namespace alphamst::adapt
