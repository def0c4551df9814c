// A window of a whole mesh: the library chose it, so its border may give way.
#pragma once

#include <optional>
#include <vector>

#include "refill/evaluate.h"

namespace alphamst::refill {

struct Place {
    std::vector<int> faces;  // of the window, ascending
    std::vector<int> buffer; // the faces around them
};

// The first filling, best numbers first, that meets the goal and is, together with the buffer, as
// shapely as wanted, or as it was before if that is less; of some with the same numbers the one along the
// cross field, if the reference has one. Nothing if there is none. The result depends on the arguments alone.
std::optional<Replacement> refill_window(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                                         const ShapeBounds &wanted, const Settings &settings,
                                         const reference::Reference &reference, Trace &trace);

} // namespace alphamst::refill
