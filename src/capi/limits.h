// How large a mesh can be when its ids are amst_id.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>

#include "alphamst/alphamst.h"
#include "failure.h"
#include "outcome.h"

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

// A patch is filled at once, with effort that grows faster than its faces: this many take
// hours, and need gigabytes.
constexpr double max_patch_faces = 100000;

// Failure (range) if alpha asks for too many faces in place of those of patch p.
inline void require_wanted_in_patch(std::size_t p, std::size_t n_faces, double alpha) {
    if (alpha <= 1 || alpha * static_cast<double>(n_faces) <= max_patch_faces)
        return;
    const auto patch = static_cast<std::int64_t>(p);
    Failure failure(
        Fault::range,
        "patch {} would get more than 100000 faces, which are too many to be laid at once; take a "
        "smaller alpha or smaller patches, or adapt in steps",
        Entity::none, {patch});
    failure.patch = patch;
    throw failure;
}

inline void require_wanted(std::int64_t n_faces, std::span<const Patch> patches, double alpha) {
    double all = static_cast<double>(n_faces);
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const double asked = patches[p].alpha > 0 ? patches[p].alpha : alpha;
        require_wanted_in_patch(p, patches[p].faces.size(), asked);
        all += (asked - 1) * static_cast<double>(patches[p].faces.size());
    }
    if (all > static_cast<double>(max_faces))
        throw Failure(Fault::range, "the mesh would have more faces than 32-bit ids can name, which are " +
                                        std::to_string(max_faces) + "; take a smaller alpha");
}

inline void require_wanted(std::int64_t n_faces, double alpha) {
    if (alpha * static_cast<double>(n_faces) > static_cast<double>(max_faces))
        throw Failure(Fault::range, "alpha asks for more faces than 32-bit ids can name, which are " +
                                        std::to_string(max_faces));
}

} // namespace alphamst::capi
