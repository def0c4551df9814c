// What the log tells of a new mesh, in the name of the call.
#pragma once

#include "capi/handles.h"
#include "mesh/orient.h"

namespace alphamst::capi {

void say_turned(const Context &context, const char *call, const mesh::Oriented &oriented,
                std::int64_t n_faces);

// What is allowed and mostly a mistake: faces that share no edge, hanging vertices, edges without length.
void say_oddities(const Context &context, const char *call, const mesh::QuadMesh &mesh);

} // namespace alphamst::capi
