// Puts the markers of a file in order, as every reader does in the end that has some.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "io/arrays.h"

namespace alphamst::io {

using Number = std::function<std::int64_t(std::int32_t vertex)>; // of a vertex, in the file

// Of several markers on one edge, face or vertex the smallest counts; faces of several markers come once for
// each, and equal in all but that. Lines that are no edges of faces are left out, and points without a face.
// What somebody may miss is told in mesh.remarks. Markers that are all 0 are none.
void settle_markers(Arrays &mesh, const Number &number);

// A name that may stand in quotes on a line of its own, whatever a file has.
std::string clean_name(std::string_view name);

} // namespace alphamst::io
