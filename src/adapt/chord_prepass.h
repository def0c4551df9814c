// How the work on a whole mesh begins.
#pragma once

#include <cstdint>

#include "adapt/adapt.h"

namespace alphamst::adapt {

// A curved mesh that is nearly regular comes nearer to another number of faces by whole chords, as they make
// no vertex singular. Features lose vertices only where they are straight, unless Settings::edit_boundary
// lets them, and the boundary, lose those where they turn little. Left to the windows is what would uncover
// the surface or turn a quad over, and a mesh with a field "size", as chords know nothing of sizes.
void chord_prepass(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings,
                   const Progress &progress);

} // namespace alphamst::adapt
