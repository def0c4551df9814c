#include "io/msh_numbers.h"

namespace alphamst::io {

void MshNumbers::begin_binary() {
    const char *const one = scan_.take(4).data();
    big_endian_ = decode<std::int32_t>(one, true) == 1;
    if (!big_endian_ && decode<std::int32_t>(one, false) != 1)
        scan_.malformed("the number that tells the order of bytes is not 1; the file is damaged");
    binary_ = true;
}

std::int64_t MshNumbers::whole(std::size_t size) {
    if (!binary_)
        return scan_.integer();
    const char *const bytes = scan_.take(size).data();
    return size == 4 ? decode<std::int32_t>(bytes, big_endian_) : decode<std::int64_t>(bytes, big_endian_);
}

double MshNumbers::real() {
    return binary_ ? decode<double>(scan_.take(8).data(), big_endian_) : scan_.real();
}

std::int64_t MshNumbers::count(std::string_view things, std::size_t in_text, std::size_t in_binary) {
    const std::int64_t n = long_integer();
    expect(n, things, in_text, in_binary);
    return n;
}

void MshNumbers::expect(std::int64_t n, std::string_view things, std::size_t in_text, std::size_t in_binary) {
    scan_.expect(n, things, binary_ ? in_binary : in_text);
}

void MshNumbers::begin() {
    if (binary_)
        scan_.line();
}

void MshNumbers::end_line() {
    if (!binary_)
        scan_.line();
}

} // namespace alphamst::io
