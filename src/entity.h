// What the kinds of entities of a mesh are called in sentences.
#pragma once

#include <string>

#include "failure.h"

namespace alphamst {

inline std::string plural_of(Entity entity) {
    return entity == Entity::vertex ? "vertices" : entity == Entity::edge ? "edges" : "faces";
}

} // namespace alphamst
