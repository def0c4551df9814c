// How large a mesh can be when its ids are amst_id.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "alphamst/alphamst.h"
#include "failure.h"

namespace alphamst::capi {

// Half-edges are numbered in an int too, and a quad mesh has at most eight a face.
constexpr std::int64_t max_faces = std::numeric_limits<amst_id>::max() / 8;
constexpr std::int64_t max_vertices = std::numeric_limits<amst_id>::max() - 1;

inline void require_size(std::int64_t n_vertices, std::int64_t n_faces) {
    if (n_faces == 0)
        throw Failure(Fault::range, "a mesh needs at least one face");
    const auto require = [](std::int64_t n, std::int64_t most, const char *what) {
        if (n > most)
            throw Failure(Fault::range, std::to_string(n) + ' ' + what +
                                            " are too many: ids are 32 bits wide, "
                                            "which is enough for " +
                                            std::to_string(most));
    };
    require(n_vertices, max_vertices, "vertices");
    require(n_faces, max_faces, "faces");
}

} // namespace alphamst::capi
