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

} // namespace alphamst::smooth
