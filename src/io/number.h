// Numbers as text, whatever the locale: <charconv> alone, because streams and strtod
// follow the locale of the host program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace alphamst::io {

enum class Parsed { number, malformed, too_large };

// The whole word must be the number; a leading + is allowed. "inf" and "nan" are
// numbers here, and a real too small for a double is 0.
Parsed parse(std::string_view word, std::int64_t &value);
Parsed parse(std::string_view word, double &value);

// Shortest text that reads back to the same double, bit for bit.
void append_number(std::string &text, double value);
void append_number(std::string &text, std::int64_t value);

} // namespace alphamst::io
