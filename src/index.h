// Ids are signed, places in containers are not.
#pragma once

#include <concepts>
#include <cstddef>

namespace alphamst {

constexpr std::size_t at(std::integral auto id) { return static_cast<std::size_t>(id); }

} // namespace alphamst
