// Numbers as bytes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace alphamst::io {

template <class Number> void append_little(std::string &bytes, Number number) {
    std::array<char, sizeof(Number)> ordered;
    std::memcpy(ordered.data(), &number, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big)
        std::reverse(ordered.begin(), ordered.end());
    bytes.append(ordered.data(), ordered.size());
}

} // namespace alphamst::io
