#include "adapt/adapt.h"

#include <algorithm>

#include "adapt/batch.h"
#include "refill/propose.h"

namespace alphamst::adapt {

std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha,
                           const Settings &settings, const Progress &progress) {
    return refill(mesh, patches, settings, progress, "adapt", [&](const Patch &patch) {
        refill::Goal goal;
        goal.faces = refill::wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
        goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
        return goal;
    });
}

std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                          const Settings &settings, const Progress &progress) {
    return refill(mesh, patches, settings, progress, "reduce", [](const Patch &patch) {
        refill::Goal goal;
        goal.faces = static_cast<std::int64_t>(patch.faces.size());
        goal.any_count = true;
        return goal;
    });
}

Prediction predict(const mesh::QuadMesh &mesh, const Patch &patch, double alpha, const Settings &settings) {
    refill::Goal goal;
    goal.faces = refill::wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
    goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
    return refill::first_choice(mesh, patch, goal, settings,
                                reference::reference_of(mesh, std::span(&patch, 1)));
}

} // namespace alphamst::adapt
