// Fields of files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/arrays.h"

namespace alphamst::io {

// Adds a field with the carry rule of data that say nothing of one: whole numbers and "cross" are
// INHERIT, other reals LINEAR on vertices and CONSERVE on faces.
void add_new_field(Arrays &mesh, Entity entity, std::string_view name, int components, bool whole,
                   std::vector<double> values);

// Leaves out what can be no field of a mesh, as every reader does in the end that has some; mesh.remarks
// tell.
void settle_fields(Arrays &mesh);

} // namespace alphamst::io
