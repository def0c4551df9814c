#include "capi/options.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "capi/array.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "mesh/sides.h"

namespace alphamst::capi {
namespace {

// An option as the interface has it: a number, whatever the type of the member that holds it. Its default is
// that of the member.
template <typename T> struct Knob {
    std::int32_t key;
    const char *name;
    T (*get)(const Options &);
    void (*set)(Options &, T);
    T low, high;
};

template <auto member, typename T> constexpr Knob<T> knob(std::int32_t key, const char *name, T low, T high) {
    return {key,
            name,
            [](const Options &options) { return static_cast<T>(options.*member); },
            [](Options &options, T value) {
                options.*member = static_cast<std::remove_cvref_t<decltype(options.*member)>>(value);
            },
            low,
            high};
}

template <auto member>
constexpr Knob<std::int64_t> integer(std::int32_t key, const char *name, std::int64_t low,
                                     std::int64_t high) {
    return knob<member, std::int64_t>(key, name, low, high);
}

template <auto member>
constexpr Knob<double> real(std::int32_t key, const char *name, double low, double high) {
    return knob<member, double>(key, name, low, high);
}

constexpr std::int64_t int_min = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t int_max = std::numeric_limits<std::int64_t>::max();
constexpr double most_patch_faces = std::numeric_limits<amst_id>::max();

constexpr Knob<std::int64_t> integers[] = {
    integer<&Options::seed>(AMST_OPT_SEED, "AMST_OPT_SEED", int_min, int_max),
    integer<&Options::smooth_steps>(AMST_OPT_SMOOTH_STEPS, "AMST_OPT_SMOOTH_STEPS", 0, 1000),
    integer<&Options::repair_patches>(AMST_OPT_REPAIR_PATCHES, "AMST_OPT_REPAIR_PATCHES", 0, 1),
    integer<&Options::candidates>(AMST_OPT_CANDIDATES, "AMST_OPT_CANDIDATES", 1, 1000),
    integer<&Options::node_limit>(AMST_OPT_NODE_LIMIT, "AMST_OPT_NODE_LIMIT", 0, 1000000000),
    integer<&Options::quadrangulate>(AMST_OPT_QUADRANGULATE, "AMST_OPT_QUADRANGULATE", 0, 1),
    integer<&Options::edit_boundary>(AMST_OPT_EDIT_BOUNDARY, "AMST_OPT_EDIT_BOUNDARY", 0, 1),
    integer<&Options::by_chords>(AMST_OPT_STRATEGY, "AMST_OPT_STRATEGY", 0, 1),
    integer<&Options::align>(AMST_OPT_ALIGN, "AMST_OPT_ALIGN", 0, 1),
    integer<&Options::chart>(AMST_OPT_CHART, "AMST_OPT_CHART", 0, 3),
    integer<&Options::keep_boundary>(AMST_OPT_KEEP_BOUNDARY, "AMST_OPT_KEEP_BOUNDARY", 0, 1),
    integer<&Options::starts>(AMST_OPT_STARTS, "AMST_OPT_STARTS", 1, 1000),
    integer<&Options::buffer_layers>(AMST_OPT_BUFFER_LAYERS, "AMST_OPT_BUFFER_LAYERS", 0, 1000),
};

constexpr Knob<double> reals[] = {
    real<&Options::min_quality>(AMST_OPT_MIN_QUALITY, "AMST_OPT_MIN_QUALITY", 0, 1),
    real<&Options::min_convexity>(AMST_OPT_MIN_CONVEXITY, "AMST_OPT_MIN_CONVEXITY", 0, 1),
    real<&Options::patch_faces>(AMST_OPT_PATCH_FACES, "AMST_OPT_PATCH_FACES", 1, most_patch_faces),
    real<&Options::tolerance>(AMST_OPT_TOLERANCE, "AMST_OPT_TOLERANCE", 0.01, 100),
    real<&Options::effort>(AMST_OPT_EFFORT, "AMST_OPT_EFFORT", 0.01, 100),
    real<&Options::size_weight>(AMST_OPT_SIZE_WEIGHT, "AMST_OPT_SIZE_WEIGHT", 0, 1),
    real<&Options::transition>(AMST_OPT_TRANSITION, "AMST_OPT_TRANSITION", 0.05, 1),
    real<&Options::least_size>(AMST_OPT_LEAST_SIZE, "AMST_OPT_LEAST_SIZE", 0, 1),
    real<&Options::sharp_angle>(AMST_OPT_SHARP_ANGLE, "AMST_OPT_SHARP_ANGLE", 0, 180),
    real<&Options::size_band>(AMST_OPT_SIZE_BAND, "AMST_OPT_SIZE_BAND", 0, 8),
    real<&Options::min_edge>(AMST_OPT_MIN_EDGE, "AMST_OPT_MIN_EDGE", 0, mesh::largest_coordinate),
    real<&Options::max_edge>(AMST_OPT_MAX_EDGE, "AMST_OPT_MAX_EDGE", 0, mesh::largest_coordinate),
    real<&Options::gradation>(AMST_OPT_GRADATION, "AMST_OPT_GRADATION", 0.01, 100),
    real<&Options::error_order>(AMST_OPT_ERROR_ORDER, "AMST_OPT_ERROR_ORDER", 0.1, 16),
};

static_assert(static_cast<int>(quadrangulate::Quadrangulation::pair) == 0 &&
              static_cast<int>(quadrangulate::Quadrangulation::split) == 1 &&
              static_cast<int>(ChartKind::mean_value) == 1 && static_cast<int>(ChartKind::low_stretch) == 3);

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
    knob.set(options, value);
}

} // namespace

Options options_of(const amst_options *options) { return options == nullptr ? Options() : options->impl; }

std::vector<std::int32_t> unused_options(const Options &options, std::span<const std::int32_t> in_use) {
    // Seed and smoothing are of use to every operation; the others that are not here are for patch sets,
    // triangles and indicators.
    constexpr std::int32_t of_operations[] = {
        AMST_OPT_CANDIDATES, AMST_OPT_NODE_LIMIT,  AMST_OPT_EDIT_BOUNDARY, AMST_OPT_STRATEGY,
        AMST_OPT_ALIGN,      AMST_OPT_CHART,       AMST_OPT_MIN_QUALITY,   AMST_OPT_TOLERANCE,
        AMST_OPT_EFFORT,     AMST_OPT_SIZE_WEIGHT, AMST_OPT_TRANSITION,    AMST_OPT_LEAST_SIZE,
        AMST_OPT_SIZE_BAND,  AMST_OPT_STARTS};
    const Options defaults;
    std::vector<std::int32_t> unused;
    const auto look = [&](const auto &knobs) {
        for (const auto &knob : knobs)
            if (knob.get(options) != knob.get(defaults) &&
                std::ranges::find(of_operations, knob.key) != std::end(of_operations) &&
                std::ranges::find(in_use, knob.key) == in_use.end())
                unused.push_back(knob.key);
    };
    look(integers);
    look(reals);
    return unused;
}

const char *option_name(std::int32_t key) {
    return key < 1000 ? find(integers, key).name : find(reals, key).name;
}

chord::Rules rules_of(const Options &options) {
    chord::Rules rules;
    rules.boundary = options.edit_boundary;
    return rules;
}

Settings settings_of(const Options &options, int threads) {
    Settings settings = options;
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
        required(value, "value") = find(integers, key).get(settings);
    });
}

amst_status amst_options_get_real(const amst_options *options, std::int32_t key, double *value) {
    return guarded(0, [&] {
        const Options &settings = required(options, "options").impl;
        required(value, "value") = find(reals, key).get(settings);
    });
}

amst_status amst_options_set_edges(amst_options *options, const amst_id *vertices, std::int64_t n_edges) {
    return guarded(0, [&] {
        Options &settings = required(options, "options").impl;
        require_array(vertices, n_edges, "vertices", "n_edges");
        std::vector<std::array<amst_id, 2>> edges;
        for (std::int64_t e = 0; e < n_edges; ++e)
            edges.push_back({vertices[2 * e], vertices[2 * e + 1]});
        settings.edges = std::move(edges);
    });
}

amst_status amst_options_get_edges(const amst_options *options, amst_id *out, std::int64_t capacity,
                                   std::int64_t *needed) {
    return guarded(0, [&] {
        const auto &edges = required(options, "options").impl.edges;
        if (answer(out, capacity, needed, 2 * static_cast<std::int64_t>(edges.size())))
            for (const auto &[v, w] : edges) {
                *out++ = v;
                *out++ = w;
            }
    });
}
