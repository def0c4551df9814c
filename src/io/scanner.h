// Reads the bytes of a mesh file word by word, line by line or in blocks of
// binary values, and knows where it is when something is wrong. It never reads
// past the end and never believes a count that the rest of the file cannot hold.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "failure.h"
#include "io/arrays.h"

namespace alphamst::io {

class Scanner {
public:
    // comment: this character hides the rest of its line ('\0': no comments).
    // continues: a backslash at the end of a line joins it with the next.
    explicit Scanner(std::string_view text, char comment = '\0', bool continues = false)
        : text_(text), comment_(comment), continues_(continues) {}

    bool at_end();           // nothing but blanks, line ends and comments left
    bool at_line_end();      // the same for this line
    std::string_view word(); // the next one, on this line or a later one
    std::string_view line(); // the rest of this line, without its end
    double real();
    std::int64_t integer();
    // A number of things of at least `least` bytes each, which the file may hold.
    std::int64_t count(std::string_view things, std::size_t least);
    void expect(std::int64_t n, std::string_view things, std::size_t least); // the check alone

    std::string_view take(std::size_t bytes); // raw, from exactly here
    bool ahead(std::string_view start) const { return text_.substr(here_).starts_with(start); }
    std::size_t remaining() const { return text_.size() - here_; }

    // Failures with the line (or byte, after take) of the last word read.
    [[noreturn]] void fail(Fault fault, std::string_view text, Entity entity = Entity::none,
                           std::vector<std::int64_t> ids = {}) const;
    [[noreturn]] void malformed(std::string_view text) const { fail(Fault::format, text); }

private:
    void skip_blanks();

    std::string_view text_;
    std::size_t here_ = 0, word_ = 0;
    char comment_;
    bool continues_;
    bool binary_ = false;
};

// A word of a file, safe to put into a sentence: short, printable, without braces.
std::string quoted(std::string_view word);
bool same_word(std::string_view a, std::string_view b); // ASCII letters of either case

template <class Number> Number decode(const char *bytes, bool big_endian) {
    char ordered[sizeof(Number)];
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        ordered[i] =
            bytes[(std::endian::native == std::endian::big) == big_endian ? i : sizeof(Number) - 1 - i];
    Number value;
    std::memcpy(&value, ordered, sizeof(Number));
    return value;
}

// What every reader ends in. The face or vertex to come is named by its place.
void add_vertex(const Scanner &at, Arrays &mesh, double x, double y, double z);
std::int32_t corner(const Scanner &at, const Arrays &mesh, std::int64_t vertex, std::int64_t n_vertices,
                    std::int64_t first_number);
std::size_t need_corners(const Scanner &at, const Arrays &mesh, std::int64_t n); // 3 or 4
Arrays finished(Arrays mesh);                                                    // dim set

} // namespace alphamst::io
