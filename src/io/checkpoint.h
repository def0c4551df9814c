// The project's own format, .amst: a mesh to the last bit and id, so that work goes on as if it had not been
// interrupted.
//
// A file begins with the 8 bytes 89 41 4d 53 54 0d 0a 1a (so that a change of line ends shows), the word
// 0x01020304, the version of the format as a word, and the length of the file as two. Sections follow, always
// the same ones in the same order: four letters, the size of an element, the number of bytes as two words, a
// digest of all this and of the bytes as two, and the bytes, filled up with zeros to a multiple of 8. Words
// are of 32 bits; all numbers are little-endian.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::io {

// What a mesh has been through, as the C interface counts it.
struct History {
    std::int64_t revision = 0, last_revision = 0;
    std::vector<std::array<std::int32_t, 2>> crossed; // of amst_mesh_get_crossed_edges
    std::vector<std::array<std::int32_t, 3>> split;
};

struct Checkpoint {
    std::shared_ptr<mesh::QuadMesh> mesh; // a move would copy it
    History history;
};

std::string print_checkpoint(const mesh::QuadMesh &mesh, const History &history);
// Throws Failure: format, with the byte, and unsupported (a later version of the format).
Checkpoint parse_checkpoint(std::string_view bytes);

} // namespace alphamst::io
