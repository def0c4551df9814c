// A patch as the operations take it, and what they tell of it afterwards.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "failure.h"

namespace alphamst {

// One patch. The operations renew faces (and corners stay vertices of the mesh, renumbered).
struct Patch {
    std::vector<int> faces;   // ascending
    std::vector<int> corners; // 3 to 6 boundary vertices, or empty: the library chooses
    double alpha = 0;         // 0: that of the operation
};

struct Outcome {
    std::optional<Fault> fault; // why the patch was left as it was
    std::string text;           // the sentence that goes with it
    std::int64_t faces_before = 0, faces_after = 0, faces_wanted = 0;
    std::int64_t singular_before = 0, singular_after = 0, singular_bound = 0;
    std::int64_t candidate = 0; // 0: as predicted; n: geometry forced the n-th later filling
    double quality_before = 0, quality_after = 0, seconds = 0;
    double aspect_ratio_before = 0, aspect_ratio_after = 0; // the largest
    // Of area / wanted area: rms of log2, and the smallest; the smallest of edge / root of the wanted area.
    // NaN: no sizes were wanted, or none are known.
    double size_error_before = std::numeric_limits<double>::quiet_NaN(), size_error_after = size_error_before;
    double least_area_before = size_error_before, least_area_after = size_error_before;
    double shortest_edge_before = size_error_before, shortest_edge_after = size_error_before;
    std::vector<double> size_errors; // [face of the patch after, in its order] log2; empty likewise
    double time_step = 1;            // see reference::time_step: after over before
    std::map<int, std::int64_t> valences_before, valences_after; // interior vertices of the mesh in the patch
};

struct Prediction {
    std::int64_t faces = 0, singularities = 0;
};

} // namespace alphamst
