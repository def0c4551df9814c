// Numeric settings by key, each with a default and a range.
#pragma once

#include <cstdint>

#include "adapt/adapt.h"
#include "alphamst/alphamst.h"
#include "chord/judge.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::capi {

struct Options {
    std::int64_t seed = 0;
    std::int64_t smooth_steps = 20;
    std::int64_t repair_patches = 1;
    std::int64_t candidates = 16;
    std::int64_t node_limit = 1000;
    std::int64_t quadrangulate = 0;
    std::int64_t edit_boundary = 0;
    std::int64_t strategy = 0;
    std::int64_t align = 0;
    std::int64_t chart = 0;
    double min_quality = 0;
    double min_convexity = 0.6;
    double patch_faces = 100;
    double tolerance = 0.5;
};

// Those of the handle, all defaults for NULL.
Options options_of(const amst_options *options);

quadrangulate::Quadrangulation quadrangulation_of(const amst_options *options);

chord::Rules rules_of(const Options &options);

Settings settings_of(const Options &options, int threads);

} // namespace alphamst::capi
