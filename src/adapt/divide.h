// A region too large, too curved or with too many holes for one filling is refilled in parts: disks inside
// it, each a patch of its own. Once more with other parts, so that no border of one stays as it was.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::adapt {

// Until the patch has so many faces, or no parts are found that come nearer. What parts may not cross
// (features, borders of numbered regions) and all outside the patch stays. The patches of the set follow the
// mesh. What there was and what became of it is written to the outcome.
void refill_in_parts(mesh::QuadMesh &mesh, std::vector<Patch> &patches, std::size_t patch,
                     std::int64_t wanted, const Settings &settings, const Progress &progress,
                     Outcome &outcome);

} // namespace alphamst::adapt
