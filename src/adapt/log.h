// The inside view: one line for each cavity, one for each stage. Costs nothing while nobody looks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "outcome.h"
#include "refill/patch.h"
#include "refill/window.h"

namespace alphamst::adapt {

void log_patch(const Settings &settings, const char *stage, std::size_t patch,
               const refill::Proposal &proposal);

// seed: the vertex that the window grew from. taken: null if nothing was.
void log_window(const Settings &settings, const mesh::QuadMesh &mesh, const char *stage, int seed,
                const refill::Place &place, const refill::Trace &trace, const refill::Replacement *taken);

// What came of a pass of windows.
struct StageCount {
    int size = 0, windows = 0, refilled = 0, irregular = 0;
    std::int64_t missing = 0;
};
void log_stage(const Settings &settings, const char *stage, const StageCount &count);

// What each of several searches came to, and which is kept.
void log_starts(const Settings &settings, const std::vector<Outcome> &outcomes, std::size_t kept);

} // namespace alphamst::adapt
