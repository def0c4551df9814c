// The numbers of a data array of VTK's XML format, in whatever way the file has them: as words, in base64,
// raw behind the text, or in blocks compressed by zlib.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/vtk_values.h"

namespace alphamst::io::vtu {

// As the first element of the file says.
struct Encoding {
    bool big_endian = false, long_lengths = false, zlib = false;
};

// An element DataArray.
struct Array {
    enum class Place { words, base64, raw };

    std::string name;
    vtk::Type type{vtk::Kind::real, 8};
    std::int64_t components = 1;
    std::int64_t tuples = -1; // not said
    Place place = Place::words;
    std::size_t begin = 0, end = 0; // in the file; raw ones and those in base64 may end sooner
};

// Throw Failure format, with the byte: more or fewer than `wanted` numbers (-1: any number), or damaged ones.
// Memory is taken only for what the bytes of the file hold, of compressed ones for what zlib makes of them.
std::vector<double> reals(std::string_view file, const Array &array, Encoding encoding, std::int64_t wanted);
std::vector<std::int64_t> integers(std::string_view file, const Array &array, Encoding encoding,
                                   std::int64_t wanted);

} // namespace alphamst::io::vtu
