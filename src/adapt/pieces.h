// Small meshes: their pieces are patches.
#pragma once

#include <cstdint>
#include <optional>

#include "mesh/quad_mesh.h"
#include "settings.h"

namespace alphamst::adapt {

// At most a thousand faces.
bool is_small(const mesh::QuadMesh &mesh);

// Refills each connected piece of a small mesh, features, markers and fixed faces
// being borders, by one filling: so many faces in all, if their boundaries allow it. Windows, which are for
// large meshes, come to worse sizes there, and spend seconds where there is nothing that they can change. How
// many pieces lie at the boundary of the mesh; nothing if that is not small or was not changed.
std::optional<std::size_t> refill_pieces(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings,
                                         const Progress &progress);

} // namespace alphamst::adapt
