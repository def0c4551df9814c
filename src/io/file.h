// Whole files, to and from memory. Paths are UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace alphamst::io {

// Both throw Failure io with the system's reason.
std::string load(const std::string &path);
// All or nothing: writes a new file next to path and renames it when all of it is
// on its way to the disk, so that a failure leaves what was there.
void save(const std::string &path, std::string_view bytes);

} // namespace alphamst::io
