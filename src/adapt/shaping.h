// How far shapes are optimised, by the settings.
#pragma once

#include "adapt/adapt.h"
#include "geometry/embed.h"

namespace alphamst::adapt {

inline geometry::EmbedOptions shaping(const Settings &settings) {
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    options.patient = settings.patient;
    options.least_area = settings.least_area;
    return options;
}

} // namespace alphamst::adapt
