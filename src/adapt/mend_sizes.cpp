#include "adapt/mend_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "adapt/commit.h"
#include "adapt/log.h"
#include "index.h"
#include "patch/grow.h"
#include "reference/size_error.h"
#include "reference/sizing_field.h"
#include "refill/patch.h"

namespace alphamst::adapt {
namespace {

// Faces of a patch: a web has up to a few hundred, and where they go to there must be room.
constexpr std::array<int, 4> window_sizes = {100, 200, 400, 800};
constexpr int most_added = 4; // singular vertices that a mended place may cost
constexpr int most_places = 32;

class SizeMender {
public:
    SizeMender(mesh::QuadMesh &mesh, reference::Reference &reference, const Settings &settings)
        : mesh_(mesh), reference_(reference), settings_(settings) {}

    int run() {
        int mended = 0;
        for (int k = 0; k < most_places; ++k) {
            const int face = worst();
            if (face < 0)
                break;
            if (mend(face))
                ++mended;
            else
                hopeless_.push_back(mesh_.point(mesh_.corners(face)[0]));
        }
        return mended;
    }

private:
    // The smallest face for what is wanted that is not known to be hopeless; -1: none is too small.
    int worst() const {
        std::vector<int> all(at(mesh_.n_faces()));
        std::iota(all.begin(), all.end(), 0);
        const std::vector<double> weights = reference_.sizes->weights(mesh_, all);
        int face = -1;
        double least = settings_.least_size * reference_.face_weight;
        for (const int f : all)
            if (weights[at(f)] < least && !is_hopeless(f)) {
                least = weights[at(f)];
                face = f;
            }
        return face;
    }

    bool is_hopeless(int face) const {
        const OpenMesh::Vec3d point = mesh_.point(mesh_.corners(face)[0]);
        return std::find(hopeless_.begin(), hopeless_.end(), point) != hopeless_.end();
    }

    bool mend(int face) {
        patch::Growth growth(mesh_);
        for (const int size : window_sizes) {
            patch::GrowthPlan plan;
            plan.start = mesh_.corners(face)[0];
            plan.most = size;
            plan.nearness = patch::Nearness::ball;
            Patch place;
            place.faces = growth.disk(plan);
            if (place.faces.empty())
                return false;
            refill::Goal goal;
            goal.faces = static_cast<std::int64_t>(place.faces.size());
            goal.forbid_old = true;
            goal.most_added = most_added;
            refill::Proposal proposal = refill::propose(mesh_, place, goal, settings_, reference_);
            log_patch(settings_, "sizes", 0, proposal);
            if (proposal.outcome.fault || !is_better(proposal.outcome))
                continue;
            Commits(mesh_, reference_).put(proposal.replacement, proposal.buffer);
            return true;
        }
        return false;
    }

    static bool is_better(const Outcome &outcome) {
        return outcome.least_area_after > 2 * outcome.least_area_before &&
               outcome.singular_after <= outcome.singular_before + most_added;
    }

    mesh::QuadMesh &mesh_;
    reference::Reference &reference_;
    const Settings &settings_;
    std::vector<OpenMesh::Vec3d> hopeless_;
};

} // namespace

int mend_sizes(mesh::QuadMesh &mesh, reference::Reference &reference, const Settings &settings) {
    return SizeMender(mesh, reference, settings).run();
}

} // namespace alphamst::adapt
