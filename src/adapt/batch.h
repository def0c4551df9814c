// Refills the patches of a set: those that share no vertex are proposed for in parallel, all are
// committed in their order, so the result does not depend on the number of threads.
#pragma once

#include <functional>

#include "adapt/propose.h"

namespace alphamst::adapt {

std::vector<Outcome> refill(mesh::QuadMesh &mesh, std::vector<Region> &patches, const Settings &settings,
                            const Progress &progress, const char *stage,
                            const std::function<Goal(const Region &)> &goal);

} // namespace alphamst::adapt
