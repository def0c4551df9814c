#include "capi/guard.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>

namespace alphamst::capi {
namespace {

// The only state of the library that is not in a handle.
thread_local LastError slot = {"", AMST_ENTITY_NONE, -1, -1};

amst_id clamped(std::int64_t id) noexcept {
    constexpr std::int64_t low = std::numeric_limits<amst_id>::min();
    constexpr std::int64_t high = std::numeric_limits<amst_id>::max();
    return static_cast<amst_id>(id < low ? low : id > high ? high : id);
}

// Appends characters to a fixed buffer; what does not fit is cut off between two
// UTF-8 characters.
class Line {
public:
    Line(char *text, std::size_t size) noexcept : text_(text), room_(size - 1) {}

    void add(const char *characters, std::size_t n) noexcept {
        if (cut_)
            return;
        if (n > room_ - length_) {
            n = room_ - length_;
            while (n > 0 && (static_cast<unsigned char>(characters[n]) & 0xC0U) == 0x80U)
                --n;
            cut_ = true;
        }
        std::memcpy(text_ + length_, characters, n);
        length_ += n;
    }

    void end() noexcept { text_[length_] = '\0'; }

private:
    char *text_;
    std::size_t room_;
    std::size_t length_ = 0;
    bool cut_ = false;
};

// Calls add(characters, count) for the pieces of the sentence; allocates nothing.
template <typename Add> void compose(const Failure &failure, int index_base, Add &&add) {
    const std::string &text = failure.text;
    std::size_t from = 0;
    for (const std::int64_t id : failure.ids) {
        const std::size_t hole = text.find("{}", from);
        if (hole == std::string::npos)
            break;
        add(text.data() + from, hole - from);
        char digits[24];
        const int n = std::snprintf(digits, sizeof digits, "%lld", static_cast<long long>(id) + index_base);
        add(digits, static_cast<std::size_t>(n));
        from = hole + 2;
    }
    add(text.data() + from, text.size() - from);
}

void keep(const char *text) noexcept {
    Line line(slot.text, sizeof slot.text);
    line.add(text, std::strlen(text));
    line.end();
}

void keep(const Failure &failure, int index_base) noexcept {
    Line line(slot.text, sizeof slot.text);
    compose(failure, index_base, [&](const char *characters, std::size_t n) { line.add(characters, n); });
    line.end();
    if (failure.entity != Entity::none && !failure.ids.empty()) {
        slot.entity = static_cast<std::int32_t>(failure.entity);
        slot.id = clamped(failure.ids.front() + index_base);
    }
    if (failure.patch >= 0)
        slot.patch = clamped(failure.patch + index_base);
}

} // namespace

amst_status status_of(Fault fault) noexcept {
    switch (fault) {
    case Fault::argument:
        return AMST_ERR_ARGUMENT;
    case Fault::range:
        return AMST_ERR_RANGE;
    case Fault::not_finite:
        return AMST_ERR_NOT_FINITE;
    case Fault::not_quad:
        return AMST_ERR_NOT_QUAD;
    case Fault::not_manifold:
        return AMST_ERR_NOT_MANIFOLD;
    case Fault::patch:
        return AMST_ERR_PATCH;
    case Fault::no_filling:
        return AMST_ERR_NO_FILLING;
    case Fault::geometry:
        return AMST_ERR_GEOMETRY;
    case Fault::chord:
        return AMST_ERR_CHORD;
    case Fault::projection:
        return AMST_ERR_PROJECTION;
    case Fault::stale:
        return AMST_ERR_STALE;
    case Fault::not_found:
        return AMST_ERR_NOT_FOUND;
    case Fault::io:
        return AMST_ERR_IO;
    case Fault::format:
        return AMST_ERR_FORMAT;
    case Fault::unsupported:
        return AMST_ERR_UNSUPPORTED;
    case Fault::cancelled:
        return AMST_ERR_CANCELLED;
    case Fault::state:
        return AMST_ERR_STATE;
    case Fault::internal:
        break;
    }
    return AMST_ERR_INTERNAL;
}

const LastError &last_error() noexcept { return slot; }

std::string with_ids(const Failure &failure, int index_base) {
    std::string sentence;
    compose(failure, index_base,
            [&](const char *characters, std::size_t n) { sentence.append(characters, n); });
    return sentence;
}

amst_status record_exception(int index_base) noexcept {
    slot.entity = AMST_ENTITY_NONE;
    slot.id = index_base - 1;
    slot.patch = index_base - 1;
    try {
        throw;
    } catch (const StatusFailure &refusal) {
        keep(refusal, index_base);
        return refusal.status;
    } catch (const Failure &failure) {
        keep(failure, index_base);
        return status_of(failure.fault);
    } catch (const std::bad_alloc &) {
        keep("not enough memory");
        return AMST_ERR_NO_MEMORY;
    } catch (const std::length_error &) {
        keep("not enough memory: an array would be longer than this machine allows");
        return AMST_ERR_NO_MEMORY;
    } catch (const std::exception &exception) {
        keep(exception.what());
        return AMST_ERR_INTERNAL;
    } catch (...) {
        keep("an unknown exception was stopped at the interface");
        return AMST_ERR_INTERNAL;
    }
}

void record_remark(const std::string &text, int patch, int index_base) noexcept {
    slot.entity = AMST_ENTITY_NONE;
    slot.id = index_base - 1;
    slot.patch = patch < 0 ? index_base - 1 : clamped(patch + index_base);
    keep(text.c_str());
}

void require_array(const void *array, std::int64_t count, const char *array_name, const char *count_name) {
    if (count < 0)
        throw Failure(Fault::range, std::string(count_name) + " is negative: " + std::to_string(count));
    if (count > 0 && array == nullptr)
        throw StatusFailure(AMST_ERR_NULL, std::string(array_name) + " is NULL");
}

void require_real(double value, double low, bool open, const char *name) {
    if (!std::isfinite(value))
        throw Failure(Fault::not_finite, std::string(name) + " is not a finite number");
    if (value < low || (open && value == low))
        throw Failure(Fault::argument, std::string(name) + " must be " + (open ? "above " : "at least ") +
                                           std::to_string(low) + ", it is " + std::to_string(value));
}

} // namespace alphamst::capi
