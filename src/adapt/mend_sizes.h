// Faces far too small, as rings around a core leave them in their middle: what lies around them is refilled
// as a patch is, by sizes, with as many faces.
#pragma once

#include "reference/reference.h"
#include "settings.h"

namespace alphamst::adapt {

// reference: that of the mesh, with sizes. How many were mended.
int mend_sizes(mesh::QuadMesh &mesh, reference::Reference &reference, const Settings &settings);

} // namespace alphamst::adapt
