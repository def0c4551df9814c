// Names of markers: what a boundary, a region or a point is called.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "failure.h"

namespace alphamst {

// Of a marker on vertices, edges or faces, in UTF-8; never empty. A marker that nothing has any more may
// have a name still.
using Names = std::map<std::pair<Entity, std::int32_t>, std::string>;

} // namespace alphamst
