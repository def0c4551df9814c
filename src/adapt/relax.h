// Smoothing of a whole mesh that keeps coarse regions coarse and fine ones fine, or makes them so.
#pragma once

#include "adapt/adapt.h"
#include "adapt/density.h"
#include "adapt/ground.h"

namespace alphamst::adapt {

// Moves all vertices that may move, on a surface also along straight features. The smallest scaled Jacobian
// of the mesh never falls, and no corner turns over.
void relax(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
           const Settings &settings);

// Moves all vertices of a curved mesh that may move, over the surface, so that the faces come nearer to it
// between them; shapes may suffer, but no scaled Jacobian falls below 0.3 by that.
void fit(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
         const Settings &settings);

// 1 for vertices that do not move freely.
std::vector<char> immovable(const mesh::QuadMesh &mesh);

// Moves the vertices of a curved mesh from where they are, `start`, to `drape`; where that spoils quads or
// uncovers the surface they stay, and so do those on rails that would come past each other. False if all do.
bool settle(mesh::QuadMesh &mesh, Ground &ground, const geometry::Drape &start, geometry::Drape &drape,
            const geometry::Run &run, std::span<const geometry::Rail> rails = {});

} // namespace alphamst::adapt
