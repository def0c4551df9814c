#include "adapt/adapt.h"

#include <algorithm>

#include "adapt/batch.h"
#include "adapt/propose.h"

namespace alphamst::adapt {

std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Region> &patches, double alpha,
                           const Settings &settings, const Progress &progress) {
    return refill(mesh, patches, settings, progress, "adapt", [&](const Region &patch) {
        Goal goal;
        goal.faces = wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
        goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
        return goal;
    });
}

std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Region> &patches,
                                          const Settings &settings, const Progress &progress) {
    return refill(mesh, patches, settings, progress, "reduce", [](const Region &patch) {
        Goal goal;
        goal.faces = static_cast<std::int64_t>(patch.faces.size());
        goal.any_count = true;
        return goal;
    });
}

Prediction predict(const mesh::QuadMesh &mesh, const Region &patch, double alpha, const Settings &settings) {
    Goal goal;
    goal.faces = wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
    goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
    return first_choice(mesh, patch, goal, settings, ground_of(mesh, std::span(&patch, 1)));
}

} // namespace alphamst::adapt
