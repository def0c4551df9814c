// The border between C++ and C: every exported body runs inside guarded(), which
// turns whatever is thrown into a status and a sentence.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "alphamst/alphamst.h"
#include "failure.h"

namespace alphamst::capi {

// A failure that only the interface knows, with its status.
class StatusFailure : public Failure {
public:
    StatusFailure(amst_status status, std::string text)
        : Failure(Fault::argument, std::move(text)), status(status) {}

    amst_status status;
};

amst_status status_of(Fault fault) noexcept;

// The last failure of this thread. A fixed buffer, so that keeping it cannot fail.
struct LastError {
    char text[1024];
    std::int32_t entity;
    amst_id id;
    amst_id patch;
};
const LastError &last_error() noexcept;

// Text with each {} replaced by the next id, in the caller's numbering.
std::string with_ids(const Failure &failure, int index_base);

// Keeps the exception under way as this thread's last error and names its status.
// To be called in a catch block only.
amst_status record_exception(int index_base) noexcept;
// What a call that succeeds has to say; patch: -1 if it is about none.
void record_remark(const std::string &text, int patch, int index_base) noexcept;

// Runs body, which returns nothing or a status.
template <typename Body> amst_status guarded(int index_base, Body &&body) noexcept {
    try {
        if constexpr (std::is_void_v<std::invoke_result_t<Body>>) {
            std::forward<Body>(body)();
            return AMST_OK;
        } else {
            return std::forward<Body>(body)();
        }
    } catch (...) {
        return record_exception(index_base);
    }
}

// *pointer, or the refusal of NULL that names the parameter.
template <typename T> T &required(T *pointer, const char *name) {
    if (pointer == nullptr)
        throw StatusFailure(AMST_ERR_NULL, std::string(name) + " is NULL");
    return *pointer;
}

// A non-negative count; the array that goes with it may be NULL only when it is empty.
void require_array(const void *array, std::int64_t count, const char *array_name, const char *count_name);

// Failure (not_finite or argument) unless value is finite and not below low, or above
// it when `open`.
void require_real(double value, double low, bool open, const char *name);

} // namespace alphamst::capi
