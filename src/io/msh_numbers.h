// The numbers in a file of Gmsh, as words or in binary.
#pragma once

#include <cstdint>
#include <string_view>

#include "io/scanner.h"

namespace alphamst::io {

class MshNumbers {
public:
    explicit MshNumbers(Scanner &scan) : scan_(scan) {}

    // Behind the line of the version: the number one in binary tells the order of bytes.
    void begin_binary();
    bool binary() const { return binary_; }

    // In binary of 4 bytes, or of 8 as counts and numbers of nodes and elements are since MSH 4.
    std::int64_t integer() { return whole(4); }
    std::int64_t long_integer() { return whole(8); }
    double real();
    // A number of things, of which each takes this many bytes in text and in binary at least.
    std::int64_t count(std::string_view things, std::size_t in_text, std::size_t in_binary);
    void expect(std::int64_t n, std::string_view things, std::size_t in_text, std::size_t in_binary);

    void begin();    // moves to the first number of a section, which in binary is exactly behind the line
    void end_line(); // of text: passes over the rest

    Scanner &scan() { return scan_; }

private:
    std::int64_t whole(std::size_t size);

    Scanner &scan_;
    bool binary_ = false, big_endian_ = false;
};

} // namespace alphamst::io
