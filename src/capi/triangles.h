// Triangles of new meshes.
#pragma once

#include "capi/handles.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::capi {

// The edges of the options, as the mesh numbers vertices. Failure (not_found) if one is no side of a face.
std::vector<std::array<std::int32_t, 2>> edges_to_keep(const Options &options, int index_base,
                                                       mesh::Faces faces);

// Quads, as the options say, of faces some of which are triangles. What was crossed or put on the boundary is
// told to the log, in the name of the call.
quadrangulate::QuadArrays quads_of(const Context &context, const char *call,
                                   const quadrangulate::Polygons &polygons, const Options &options);

EdgeChanges changes_in(const quadrangulate::QuadArrays &quads);

} // namespace alphamst::capi
