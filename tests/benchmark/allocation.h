// What the program has allocated, the library's own calls included.
#pragma once

#include <cstdint>

namespace alphamst::benchmarks {

std::int64_t bytes_live();
std::int64_t bytes_most(); // since the last restart
void restart_bytes_most();

} // namespace alphamst::benchmarks
