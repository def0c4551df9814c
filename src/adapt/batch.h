// Refills the patches of a set: those that target_count no vertex are proposed for in parallel, all are
// committed in their order, so the result does not depend on the number of threads.
#pragma once

#include <functional>

#include "refill/propose.h"

namespace alphamst::adapt {

std::vector<Outcome> refill(mesh::QuadMesh &mesh, std::vector<Patch> &patches, const Settings &settings,
                            const Progress &progress, const char *stage,
                            const std::function<refill::Goal(const Patch &)> &goal);

} // namespace alphamst::adapt
