// The numbers in a file of legacy VTK: their types by name, and their values in text or big-endian binary.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/scanner.h"

namespace alphamst::io::vtk {

enum class Kind { whole, natural, real };

struct Type {
    Kind kind;
    std::size_t size; // bytes; 0 for bits, which are not read
};

std::optional<Type> find_type(std::string_view word); // nothing if VTK has none of that name

// Of one value, of any type; of a type of whole numbers.
double real_of(const char *bytes, Type type, bool big_endian);
std::int64_t integer_of(const char *bytes, Type type, bool big_endian);

class Values {
public:
    explicit Values(Scanner &scan) : scan_(scan) {}

    bool binary = false; // as the header of the file says

    Type read_type();                   // fails if the next word is none
    std::size_t least(Type type) const; // bytes that a value takes in the file
    void begin();                       // moves to the first value, past the line that announces it
    double real(Type type);             // of any type
    std::int64_t integer(Type type);    // of a type of whole numbers
    std::vector<double> reals(std::int64_t n, Type type); // from exactly here
    // n whole numbers behind the line that announces them.
    std::vector<std::int64_t> integers(std::int64_t n, Type type);

private:
    Scanner &scan_;
};

} // namespace alphamst::io::vtk
