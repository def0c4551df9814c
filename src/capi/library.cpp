#include <cstring>

#include "capi/guard.h"

using namespace alphamst::capi;

namespace {

// Two steps, so that the macros are replaced before # quotes them.
#define QUOTED(x) #x
#define VERSION_STRING(major, minor, patch) QUOTED(major) "." QUOTED(minor) "." QUOTED(patch)
constexpr const char *version_string =
    VERSION_STRING(AMST_VERSION_MAJOR, AMST_VERSION_MINOR, AMST_VERSION_PATCH);
#undef VERSION_STRING
#undef QUOTED

constexpr const char *features[] = {"threads"};

} // namespace

std::int32_t amst_version(void) {
    return AMST_VERSION_MAJOR * 10000 + AMST_VERSION_MINOR * 100 + AMST_VERSION_PATCH;
}

const char *amst_version_string(void) { return version_string; }

std::int32_t amst_has(const char *feature) {
    if (feature != nullptr)
        for (const char *known : features)
            if (std::strcmp(feature, known) == 0)
                return 1;
    return 0;
}

const char *amst_status_name(amst_status status) {
    switch (status) {
#define NAME(code)                                                                                           \
    case code:                                                                                               \
        return #code;
        NAME(AMST_ERR_INTERNAL)
        NAME(AMST_ERR_GEOMETRY)
        NAME(AMST_ERR_PROJECTION)
        NAME(AMST_ERR_CHORD)
        NAME(AMST_ERR_NO_FILLING)
        NAME(AMST_ERR_STATE)
        NAME(AMST_ERR_NO_MEMORY)
        NAME(AMST_ERR_CANCELLED)
        NAME(AMST_ERR_UNSUPPORTED)
        NAME(AMST_ERR_FORMAT)
        NAME(AMST_ERR_IO)
        NAME(AMST_ERR_NOT_FOUND)
        NAME(AMST_ERR_STALE)
        NAME(AMST_ERR_PATCH)
        NAME(AMST_ERR_NOT_MANIFOLD)
        NAME(AMST_ERR_NOT_QUAD)
        NAME(AMST_ERR_NOT_FINITE)
        NAME(AMST_ERR_BUFFER_TOO_SMALL)
        NAME(AMST_ERR_RANGE)
        NAME(AMST_ERR_ARGUMENT)
        NAME(AMST_ERR_NULL)
        NAME(AMST_OK)
        NAME(AMST_PARTIAL)
#undef NAME
    default:
        return "unknown status";
    }
}

const char *amst_last_error(void) { return last_error().text; }

amst_status amst_last_error_where(std::int32_t *entity, amst_id *id, amst_id *patch) {
    const LastError &error = last_error();
    if (entity != nullptr)
        *entity = error.entity;
    if (id != nullptr)
        *id = error.id;
    if (patch != nullptr)
        *patch = error.patch;
    return AMST_OK;
}
