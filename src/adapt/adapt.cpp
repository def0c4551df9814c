#include "adapt/adapt.h"

#include <algorithm>

#include "adapt/patches.h"
#include "refill/patch.h"

namespace alphamst::adapt {

namespace {

refill::Goal goal_of(const Patch &patch, double alpha) {
    refill::Goal goal;
    goal.faces = refill::wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
    goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
    return goal;
}

} // namespace

std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha,
                           const Settings &settings, const Progress &progress) {
    return refill_patches(mesh, patches, settings, progress, "adapt",
                          [alpha](const Patch &patch) { return goal_of(patch, alpha); });
}

std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                          const Settings &settings, const Progress &progress) {
    return refill_patches(mesh, patches, settings, progress, "reduce", [](const Patch &patch) {
        refill::Goal goal;
        goal.faces = static_cast<std::int64_t>(patch.faces.size());
        goal.any_count = true;
        return goal;
    });
}

Prediction predict(const mesh::QuadMesh &mesh, const Patch &patch, double alpha, const Settings &settings) {
    const refill::Goal goal = goal_of(patch, alpha);
    const std::vector<Patch> patches{patch};
    // Which filling is the best only the sizes and shapes of some can tell.
    mesh::QuadMesh copy = mesh; // it may get a surface to keep to
    PatchReference judged(copy, patches, settings, [&](const Patch &) { return goal; });
    refill::Proposal proposal;
    for (const double times : tolerances) {
        judged.loosen(times);
        proposal = refill::propose(copy, patch, goal, settings, judged.reference);
        if (!wants_more_room(proposal))
            break;
    }
    if (proposal.outcome.fault)
        throw Failure(*proposal.outcome.fault, proposal.outcome.text);
    return {proposal.outcome.faces_after, proposal.outcome.singular_after};
}

} // namespace alphamst::adapt
