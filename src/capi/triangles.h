// Triangles of new meshes.
#pragma once

#include "capi/handles.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::capi {

// Quads, as the options say, of faces some of which are triangles. What was crossed or put on the boundary is
// told to the log, in the name of the call.
quadrangulate::QuadArrays quads_of(const Context &context, const char *call,
                                   const quadrangulate::Polygons &polygons, const Options &options);

} // namespace alphamst::capi
