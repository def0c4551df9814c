// Sweeps over a whole mesh: windows around singular vertices, many at a time, each refilled where
// that lowers their number.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "adapt/failed_windows.h"
#include "adapt/log.h"
#include "mesh/renumbered.h"
#include "parallel/workers.h"
#include "patch/grow.h"
#include "random.h"
#include "reference/sizing_field.h"
#include "refill/window.h"

namespace alphamst::adapt {

enum class Purpose {
    fewer_singularities,
    wander,   // no more singularities, but elsewhere
    turn,     // no more singularities, and edges along the cross field
    respace,  // the boundary gets the vertices that are wanted there
    spread,   // the faces go where they are wanted
    collapse, // faces go where there are far too many, whatever becomes of the singularities
    count,    // there come to be as many faces as are wanted
    mend,     // the worst shapes become better
};

// Faces, for each wanted one, that a collapse leaves: the windows that come then need room.
constexpr double collapse_to = 1.2;

struct Pass {
    Purpose purpose = Purpose::fewer_singularities;
    int size = 0;              // faces of a window, about
    double slack = 0;          // part of the wanted faces by which a commit may miss them
    int most_added = -1;       // singularities a window may add
    refill::ShapeBounds shape; // to keep, or to reach where it was more
};

class Sweep {
public:
    // target_counts: how many of the wanted faces each face stands for.
    Sweep(mesh::QuadMesh &mesh, reference::Reference &reference, std::vector<double> target_counts,
          const std::optional<reference::SizingField> &density, const Settings &settings);

    // No filling is taken that would leave more singular vertices than that.
    void limit(int most_singular) { most_singular_ = most_singular; }

    // Tries a window around every singular vertex once, where faces are to be moved elsewhere, too, and
    // returns how many were refilled. `between` is called between rounds on the calling thread with the part
    // that is done.
    int run(const Pass &pass, const char *stage, const std::function<void(double)> &between);

    // What was done so far: faces of all windows that were tried.
    std::int64_t effort() const { return effort_; }
    // Windows of the last run.
    int tried() const { return tried_; }
    int refilled() const { return refilled_; }
    std::int64_t wanted() const { return wanted_; }
    // Singular vertices, those of the mesh boundary included, and mismatches there.
    int singular() const { return singular_; }
    // Wanted faces that are missing; negative: faces too many.
    std::int64_t missing() const { return wanted_ - mesh_.n_faces(); }

private:
    struct Round;

    std::vector<int> irregular() const;
    std::vector<int> misspaced() const;
    std::vector<int> misshapen(double scaled_jacobian) const;
    Round plan_round(const Pass &pass);
    void grow_windows(const Pass &pass, Round &round);
    void choose_windows(const Pass &pass, Round &round);
    patch::GrowthPlan plan_window(int vertex, int size, Random random) const;
    int partner(int vertex) const;
    bool take(const refill::Place &place);
    std::vector<int> choose_seeds(const Pass &pass);
    static refill::Goal respaced(refill::Goal goal, std::int64_t now, double target_count);
    std::optional<refill::Goal> goal_of(const Pass &pass, const std::vector<int> &faces) const;
    bool welcome(const Pass &pass, const refill::Replacement &found) const;
    void try_windows(const Pass &pass, Round &round);
    void commit_round(const Pass &pass, const char *stage, Round &round);
    void follow(const refill::Replacement &taken, const mesh::QuadMesh::Replaced &replaced);

    mesh::QuadMesh &mesh_;
    reference::Reference &reference_;
    const Settings settings_;
    std::vector<double> target_counts_; // [face]
    const std::optional<reference::SizingField> &sizing_;
    std::int64_t wanted_;
    parallel::Workers workers_;
    std::vector<patch::Growth> growths_; // [worker]
    Random random_;
    int singular_ = 0, most_singular_ = std::numeric_limits<int>::max();
    std::vector<int> seeds_;       // vertices, by their numbers at the start of the run
    mesh::Renumbered vertices_{0}; // since then
    std::vector<int> taken_;       // [face] epoch_ if a window chosen now holds it
    int epoch_ = 0;
    std::deque<int> waiting_;      // places in seeds_
    int tried_ = 0, refilled_ = 0; // in this run
    std::int64_t effort_ = 0;
    FailedWindows failed_;
};

} // namespace alphamst::adapt
