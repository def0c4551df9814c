// What a caller may set, and how operations tell how far they are.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace alphamst {

// How a curved patch is laid in the plane to be filled anew.
enum class ChartKind {
    plane_or_circle, // a projection where it turns little, else on a circle
    mean_value,      // on a circle
    conformal,       // loop and all where angles are kept best
    low_stretch      // on a circle, stretched less
};

// An inside view: what each stage did, at level 2, and what each cavity came to, at level 3 (those of
// amst_log_level). Called on the calling thread only.
struct Log {
    int level = -1;
    std::function<void(int level, const std::string &message)> say;
};
constexpr int log_stages = 2, log_cavities = 3;

struct Settings {
    std::uint64_t seed = 0;
    int smooth_steps = 20;
    bool patient = true;            // false: a filling that does not come right soon is left
    double least_area = 0.005;      // see geometry::EmbedOptions
    int candidates = 16;            // fillings to try in a patch before it is left
    std::int64_t node_limit = 1000; // effort of one exact search
    double min_quality = 0;         // a filling must have a larger scaled Jacobian
    double effort = 1;              // times as much is spent on better fillings
    // Of sizes against shapes, in 0 .. 1: with less, sizes of four-fold refinements stay half as good; with
    // more, corners close.
    double size_weight = 0.7;
    // See reference::RegionSizes: half leaves a core of a quarter of the area and a growth from face to face
    // of less than 1.3 at alpha = 4.
    double transition = 0.5;
    double least_size = 0.125; // area over wanted area: no smaller face is made where there was none
    double size_band = 0;   // log2: faces off by less stay, where a plane mesh has a field "size"; 0: none do
    double tolerance = 0.5; // of the distance to surface or boundary, in wanted edges
    ChartKind chart = ChartKind::plane_or_circle;
    bool edit_boundary = false;     // vertices come and go on it; chords of curved meshes may end on it
    bool align = false;             // whole curved meshes: edges along the cross field
    int threads = 1;                // 0: all cores
    int starts = 1;                 // whole meshes: searches with different luck, the best is kept
    std::shared_ptr<const Log> log; // null: nobody looks

    bool tells(int level) const { return log != nullptr && log->level >= level; }
};

// Called on the calling thread only, between steps; throws Failure (cancelled) to stop.
using Progress = std::function<void(double fraction, const char *stage)>;

} // namespace alphamst
