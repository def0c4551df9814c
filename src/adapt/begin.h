// How the work on a whole mesh begins.
#pragma once

#include <cstdint>

#include "mesh/quad_mesh.h"

namespace alphamst::adapt {

// A curved mesh that is nearly regular comes nearer to the wanted number of faces by whole chords, as they
// make no vertex singular. Left to the windows is what would uncover the surface or turn a quad over.
void begin_with_chords(mesh::QuadMesh &mesh, std::int64_t wanted);

} // namespace alphamst::adapt
