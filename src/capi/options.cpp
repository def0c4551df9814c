#include "capi/options.h"

#include <limits>
#include <string>

#include "capi/guard.h"
#include "capi/handles.h"

namespace alphamst::capi {
namespace {

template <typename T> struct Knob {
    std::int32_t key;
    const char *name;
    T Options::*member;
    T low, high;
};

constexpr std::int64_t int_min = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t int_max = std::numeric_limits<std::int64_t>::max();

constexpr Knob<std::int64_t> integers[] = {
    {AMST_OPT_SEED, "AMST_OPT_SEED", &Options::seed, int_min, int_max},
    {AMST_OPT_SMOOTH_STEPS, "AMST_OPT_SMOOTH_STEPS", &Options::smooth_steps, 0, 1000},
    {AMST_OPT_REPAIR_PATCHES, "AMST_OPT_REPAIR_PATCHES", &Options::repair_patches, 0, 1},
    {AMST_OPT_CANDIDATES, "AMST_OPT_CANDIDATES", &Options::candidates, 1, 1000},
    {AMST_OPT_NODE_LIMIT, "AMST_OPT_NODE_LIMIT", &Options::node_limit, 0, 1000000000},
    {AMST_OPT_QUADRANGULATE, "AMST_OPT_QUADRANGULATE", &Options::quadrangulate, 0, 1},
    {AMST_OPT_EDIT_BOUNDARY, "AMST_OPT_EDIT_BOUNDARY", &Options::edit_boundary, 0, 1},
    {AMST_OPT_STRATEGY, "AMST_OPT_STRATEGY", &Options::strategy, 0, 1},
    {AMST_OPT_ALIGN, "AMST_OPT_ALIGN", &Options::align, 0, 1},
    {AMST_OPT_CHART, "AMST_OPT_CHART", &Options::chart, 0, 3},
};

constexpr Knob<double> reals[] = {
    {AMST_OPT_MIN_QUALITY, "AMST_OPT_MIN_QUALITY", &Options::min_quality, 0, 1},
    {AMST_OPT_MIN_CONVEXITY, "AMST_OPT_MIN_CONVEXITY", &Options::min_convexity, 0, 1},
    {AMST_OPT_PATCH_FACES, "AMST_OPT_PATCH_FACES", &Options::patch_faces, 1,
     std::numeric_limits<amst_id>::max()},
    {AMST_OPT_TOLERANCE, "AMST_OPT_TOLERANCE", &Options::tolerance, 0.01, 100},
};

template <typename T, std::size_t n> const Knob<T> &find(const Knob<T> (&knobs)[n], std::int32_t key) {
    for (const Knob<T> &knob : knobs)
        if (knob.key == key)
            return knob;
    throw Failure(Fault::not_found, "there is no option of this type with key " + std::to_string(key));
}

template <typename T> void set(Options &options, const Knob<T> &knob, T value) {
    if (value < knob.low || value > knob.high)
        throw Failure(Fault::range, std::string(knob.name) + " must be in " + std::to_string(knob.low) +
                                        " .. " + std::to_string(knob.high) + ", it is " +
                                        std::to_string(value));
    options.*knob.member = value;
}

} // namespace

Options options_of(const amst_options *options) { return options == nullptr ? Options() : options->impl; }

quadrangulate::Quadrangulation quadrangulation_of(const amst_options *options) {
    return options_of(options).quadrangulate == 0 ? quadrangulate::Quadrangulation::pair
                                                  : quadrangulate::Quadrangulation::split;
}

chord::Rules rules_of(const Options &options) {
    chord::Rules rules;
    rules.boundary = options.edit_boundary != 0;
    return rules;
}

Settings settings_of(const Options &options, int threads) {
    Settings settings;
    settings.seed = static_cast<std::uint64_t>(options.seed);
    settings.smooth_steps = static_cast<int>(options.smooth_steps);
    settings.candidates = static_cast<int>(options.candidates);
    settings.node_limit = options.node_limit;
    settings.min_quality = options.min_quality;
    settings.tolerance = options.tolerance;
    settings.edit_boundary = options.edit_boundary != 0;
    settings.align = options.align != 0;
    settings.chart = static_cast<ChartKind>(options.chart);
    settings.threads = threads;
    return settings;
}

} // namespace alphamst::capi

using namespace alphamst;
using namespace alphamst::capi;

amst_status amst_options_create(amst_options **out) {
    return guarded(0, [&] {
        amst_options *&created = required(out, "out");
        created = new amst_options();
    });
}

void amst_options_destroy(amst_options *options) { delete options; }

amst_status amst_options_set_int(amst_options *options, std::int32_t key, std::int64_t value) {
    return guarded(0, [&] { set(required(options, "options").impl, find(integers, key), value); });
}

amst_status amst_options_set_real(amst_options *options, std::int32_t key, double value) {
    return guarded(0, [&] {
        Options &settings = required(options, "options").impl;
        const Knob<double> &knob = find(reals, key);
        require_real(value, std::numeric_limits<double>::lowest(), false, knob.name);
        set(settings, knob, value);
    });
}

amst_status amst_options_get_int(const amst_options *options, std::int32_t key, std::int64_t *value) {
    return guarded(0, [&] {
        const Options &settings = required(options, "options").impl;
        required(value, "value") = settings.*find(integers, key).member;
    });
}

amst_status amst_options_get_real(const amst_options *options, std::int32_t key, double *value) {
    return guarded(0, [&] {
        const Options &settings = required(options, "options").impl;
        required(value, "value") = settings.*find(reals, key).member;
    });
}
