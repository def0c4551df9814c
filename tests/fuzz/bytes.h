// What a fuzzer's bytes ask for, one choice after another; when there are no more, all choices are 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "alphamst/alphamst.h"

namespace alphamst::fuzz {

class Bytes {
public:
    Bytes(const std::uint8_t *data, std::size_t size) : next_(data), end_(data + size) {}

    bool empty() const { return next_ == end_; }
    std::int32_t below(std::int32_t n) { return (next_ == end_ ? 0 : *next_++) % n; }
    // Most often one that is there.
    std::int32_t id(std::int64_t count) {
        const std::int32_t choice = below(256);
        if (choice >= 250)
            return choice == 250   ? -1
                   : choice == 251 ? INT32_MAX
                                   : static_cast<std::int32_t>(count) + choice - 252;
        return count == 0 ? 0 : choice % static_cast<std::int32_t>(count);
    }
    // Most often a small one.
    double real() {
        static const double odd[] = {0, -1, 1e-300, 1e300, 1e30, -1e-9, 0.0 / zero(), 1 / zero()};
        const std::int32_t choice = below(256);
        return choice >= 240 ? odd[choice % 8] : (choice + 1) / 64.0;
    }

private:
    static double zero() {
        volatile double value = 0; // not computed while compiling, which would warn
        return value;
    }
    const std::uint8_t *next_, *end_;
};

// Ends the process, which a fuzzer takes for a finding.
inline void require(bool holds, const char *rule) {
    if (holds)
        return;
    std::fprintf(stderr, "broken: %s; last error: %s\n", rule, amst_last_error());
    std::abort();
}

// Whether no face is inverted or flat; else the mesh is in order all the same.
inline bool is_valid(const amst_mesh *mesh) {
    const amst_status status = amst_mesh_check(mesh);
    require(status == AMST_OK || status == AMST_ERR_ARGUMENT, "a mesh is in order");
    return status == AMST_OK;
}

inline std::int64_t checksum(const amst_mesh *mesh) {
    std::int64_t digest = 0;
    require(amst_mesh_get_checksum(mesh, &digest) == AMST_OK, "a mesh has a checksum");
    return digest;
}

inline std::int64_t count(const amst_mesh *mesh, std::int32_t entity) {
    std::int64_t n = 0;
    require(amst_mesh_get_count(mesh, entity, &n) == AMST_OK, "a mesh has counts");
    return n;
}

} // namespace alphamst::fuzz
