// Refills the patches of a set: those that share no vertex are proposed for in parallel, all are
// committed in their order, so the result does not depend on the number of threads.
#pragma once

#include <functional>
#include <span>

#include "reference/cross_field.h"
#include "reference/sizing_field.h"
#include "refill/patch.h"

namespace alphamst::adapt {

using GoalOf = std::function<refill::Goal(const Patch &)>;

// What the patches are judged against, as long as nothing has changed. The mesh must outlive it.
struct PatchReference {
    PatchReference(mesh::QuadMesh &mesh, const std::vector<Patch> &patches, const Settings &settings,
                   const GoalOf &goal);
    PatchReference(const PatchReference &) = delete;
    PatchReference &operator=(const PatchReference &) = delete;

    // So many times the tolerance that was asked for.
    void loosen(double times);

    reference::Reference reference;

private:
    void want_sizes(const mesh::QuadMesh &mesh, std::int64_t wanted);

    std::optional<reference::CrossField> cross_field_;
    std::optional<reference::SizingField> sizing_;
    double tolerance_ = 0;
};

// Patches that cannot be filled within the tolerance may be somewhat farther from the surface, as whole
// meshes may for the last faces of their count (see the levels in schedule.cpp): so many times.
inline constexpr double tolerances[] = {1, 1.4, 2, 3};
bool wants_more_room(const refill::Proposal &proposal);

// What an alpha asks of a patch that has none of its own.
refill::Goal goal_of(const Patch &patch, double alpha);

// Alphas that bring patches to so many faces as their weights say, together to `total`.
void share(std::vector<Patch> &patches, const std::vector<double> &weights, std::int64_t total);

// Makes faces ascending; what is known of each goes with it.
void sort_faces(Patch &patch, Outcome &outcome);

struct Manner {
    // Times the tolerance that was asked for, one after the other.
    std::span<const double> tolerances = adapt::tolerances;
    bool last_try = true; // they are not tried again
    // Where the patches are parts of others: the others, which follow the mesh, and the sizes that are wanted
    // in the one that has the parts.
    std::vector<Patch> *whole = nullptr;
    const reference::RegionSizes *sizes = nullptr;
};

std::vector<Outcome> refill_patches(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                    const Settings &settings, const Progress &progress, const char *stage,
                                    const GoalOf &goal, const Manner &manner = {});

} // namespace alphamst::adapt
