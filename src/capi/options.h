// Numeric settings by key, each with a default and a range.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "adapt/adapt.h"
#include "alphamst/alphamst.h"
#include "chord/judge.h"
#include "quadrangulate/quadrangulate.h"
#include "reference/indicator.h"

namespace alphamst::capi {

// Those of operations, and of what comes before them.
struct Options : Settings, reference::SizeRules {
    bool repair_patches = true;
    quadrangulate::Quadrangulation quadrangulate = quadrangulate::Quadrangulation::pair;
    double sharp_angle = 40; // beyond which triangles are not paired
    bool keep_boundary = false;
    std::vector<std::array<amst_id, 2>> edges; // that are not crossed, as the caller numbers vertices
    bool by_chords = false;                    // how whole meshes are adapted
    double min_convexity = 0.6;
    double patch_faces = 100;
};

// Those of the handle, all defaults for NULL.
Options options_of(const amst_options *options);

chord::Rules rules_of(const Options &options);

// Keys of the options of operations that are not at their default and not among those in use, ascending.
std::vector<std::int32_t> unused_options(const Options &options, std::span<const std::int32_t> in_use);
const char *option_name(std::int32_t key);

Settings settings_of(const Options &options, int threads);

} // namespace alphamst::capi
