// The array protocol of the interface: (T *out, int64_t capacity, int64_t *needed).
#pragma once

#include <cstdint>
#include <string>

#include "capi/guard.h"

namespace alphamst::capi {

// Tells the number of elements of the answer; true if the caller also wants them.
template <typename T>
bool answer(const T *out, std::int64_t capacity, std::int64_t *needed, std::int64_t elements) {
    std::int64_t &told = required(needed, "needed");
    require_array(out, capacity, "out", "capacity");
    told = elements;
    if (out == nullptr)
        return false;
    if (capacity < elements)
        throw StatusFailure(AMST_ERR_BUFFER_TOO_SMALL, "the answer has " + std::to_string(elements) +
                                                           " elements, the array holds " +
                                                           std::to_string(capacity));
    return true;
}

} // namespace alphamst::capi
