// Edges along a cross field.
#pragma once

#include "reference/cross_field.h"
#include "reference/reference.h"
#include "settings.h"

namespace alphamst::smooth {

// Turns the faces of the whole curved mesh as far towards the field as their connectivity, their shapes and
// the cover of the surface allow.
void align_to_field(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const reference::CrossField &cross_field, const Settings &settings);

} // namespace alphamst::smooth
