#include <algorithm>
#include <string>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/ids.h"

namespace alphamst::capi {
namespace {

const Report::Row &row_of(const amst_report *handle, amst_id patch) {
    const Report &report = required(handle, "report").impl;
    if (patch == AMST_ALL)
        return report.all;
    const int p =
        in(report.index_base, patch, static_cast<std::int64_t>(report.patches.size()), Entity::none);
    return report.patches[static_cast<std::size_t>(p)];
}

[[noreturn]] void no_result(std::int32_t key) {
    throw Failure(Fault::not_found, "there is no result of this type with key " + std::to_string(key));
}

std::int64_t integer(const Report::Row &row, std::int32_t key) {
    switch (key) {
    case AMST_RESULT_STATUS:
        return row.status;
    case AMST_RESULT_FACES_BEFORE:
        return row.faces_before;
    case AMST_RESULT_FACES_AFTER:
        return row.faces_after;
    case AMST_RESULT_FACES_WANTED:
        return row.faces_wanted;
    case AMST_RESULT_SINGULAR_BEFORE:
        return row.singular_before;
    case AMST_RESULT_SINGULAR_AFTER:
        return row.singular_after;
    case AMST_RESULT_SINGULAR_BOUND:
        return row.singular_bound;
    case AMST_RESULT_CANDIDATE:
        return row.candidate;
    case AMST_RESULT_UNUSED_OPTION:
        return row.unused_option;
    default:
        no_result(key);
    }
}

double real(const Report::Row &row, std::int32_t key) {
    switch (key) {
    case AMST_RESULT_ALPHA: // of nothing, nothing has changed
        return row.faces_before == 0
                   ? 1
                   : static_cast<double>(row.faces_after) / static_cast<double>(row.faces_before);
    case AMST_RESULT_QUALITY_BEFORE:
        return row.quality_before;
    case AMST_RESULT_QUALITY_AFTER:
        return row.quality_after;
    case AMST_RESULT_SECONDS:
        return row.seconds;
    case AMST_RESULT_SIZE_ERROR_BEFORE:
        return row.size_error_before;
    case AMST_RESULT_SIZE_ERROR_AFTER:
        return row.size_error_after;
    case AMST_RESULT_LEAST_AREA_BEFORE:
        return row.least_area_before;
    case AMST_RESULT_LEAST_AREA_AFTER:
        return row.least_area_after;
    case AMST_RESULT_TIME_STEP:
        return row.time_step;
    case AMST_RESULT_SHORTEST_EDGE_BEFORE:
        return row.shortest_edge_before;
    case AMST_RESULT_SHORTEST_EDGE_AFTER:
        return row.shortest_edge_after;
    case AMST_RESULT_ASPECT_RATIO_BEFORE:
        return row.aspect_ratio_before;
    case AMST_RESULT_AREA_GAINED:
        return row.area_gained;
    case AMST_RESULT_ASPECT_RATIO_AFTER:
        return row.aspect_ratio_after;
    default:
        no_result(key);
    }
}

} // namespace
} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

void amst_report_destroy(amst_report *report) { delete report; }

amst_status amst_report_get_int(const amst_report *report, amst_id patch, std::int32_t key,
                                std::int64_t *value) {
    return guarded(index_base(report), [&] {
        const std::int64_t found = integer(row_of(report, patch), key);
        required(value, "value") = found;
    });
}

amst_status amst_report_get_real(const amst_report *report, amst_id patch, std::int32_t key, double *value) {
    return guarded(index_base(report), [&] {
        const double found = real(row_of(report, patch), key);
        required(value, "value") = found;
    });
}

amst_status amst_report_get_valence(const amst_report *report, amst_id patch, std::int32_t after,
                                    std::int32_t valence, std::int64_t *count) {
    return guarded(index_base(report), [&] {
        const Report::Row &row = row_of(report, patch);
        const auto &valences = after == 0 ? row.valences_before : row.valences_after;
        const auto found = valences.find(valence);
        required(count, "count") = found == valences.end() ? 0 : found->second;
    });
}

amst_status amst_report_get_origin(const amst_report *report, std::int32_t entity, amst_id *out,
                                   std::int64_t capacity, std::int64_t *needed) {
    return guarded(index_base(report), [&] {
        const Report &asked = required(report, "report").impl;
        const Entity kind = entity_of(entity);
        const Report::Origin &origin = kind == Entity::vertex ? asked.vertices
                                       : kind == Entity::edge ? asked.edges
                                                              : asked.faces;
        if (!answer(out, capacity, needed, origin.count))
            return;
        for (int i = 0; i < static_cast<int>(origin.count); ++i)
            out[i] = capi::out(asked.index_base,
                               origin.from.empty() ? i : origin.from[static_cast<std::size_t>(i)]);
    });
}
