// How far shapes are optimised, by the settings.
#pragma once

#include "geometry/embed.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::smooth {

inline geometry::EmbedOptions shaping(const Settings &settings) {
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    options.patient = settings.patient;
    options.least_area = settings.least_area;
    return options;
}

// In a plane, of the wanted weight of sizes: where many vertices move one by one. Errors of sizes fall from
// .55 (rms of log2) at a weight of 1/128 to .43 at .2, .36 at .4 and .34 at .6, where a fifth of the faces
// gets too long.
inline constexpr double part_of_weight = 4.0 / 7;
// Of a corner, over the wanted area of its face, that the smallest angles may cost: with .3 time steps halve.
inline constexpr double least_area = 0.5;

inline geometry::EmbedOptions flat_shaping(const Settings &settings) {
    geometry::EmbedOptions options = shaping(settings);
    options.size_weight = part_of_weight * settings.size_weight;
    options.least_area = least_area;
    return options;
}

} // namespace alphamst::smooth
