// Windows that were tried in vain. A search that hardly finds anything more comes to the same windows again
// and again, and a window that is as it was gives what it gave.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "mesh/quad_mesh.h"
#include "refill/goal.h"
#include "refill/window.h"

namespace alphamst::adapt {

// Of all that the answer depends on: faces, where their corners are, what is asked for.
std::uint64_t fingerprint(const mesh::QuadMesh &mesh, const refill::Place &place, const refill::Goal &goal,
                          const refill::ShapeBounds &wanted, double tolerance);

class FailedWindows {
public:
    bool hold(std::uint64_t fingerprint) const { return known_.contains(fingerprint); }
    void add(std::uint64_t fingerprint) { known_.insert(fingerprint); }

private:
    std::unordered_set<std::uint64_t> known_;
};

} // namespace alphamst::adapt
