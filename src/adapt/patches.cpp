#include "adapt/patches.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "adapt/commit.h"
#include "adapt/divide.h"
#include "adapt/followed.h"
#include "adapt/log.h"
#include "index.h"
#include "parallel/workers.h"

namespace alphamst::adapt {
namespace {

// The first patches in order that share no vertex with another of the batch.
std::vector<std::size_t> independent(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches,
                                     std::vector<std::size_t> &waiting) {
    std::vector<char> used(at(mesh.n_vertices()), 0);
    std::vector<std::size_t> batch, later;
    for (const std::size_t p : waiting) {
        bool free = true;
        for (const int f : patches[p].faces)
            for (const int v : mesh.corners(f))
                free = free && !used[at(v)];
        // A patch that waits keeps its vertices from those after it, or order would matter.
        for (const int f : patches[p].faces)
            for (const int v : mesh.corners(f))
                used[at(v)] = 1;
        (free ? batch : later).push_back(p);
    }
    waiting = std::move(later);
    return batch;
}

// The faces that the mesh will have.
std::int64_t faces_wanted(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches, const GoalOf &goal) {
    std::int64_t faces = mesh.n_faces();
    for (const Patch &patch : patches)
        faces += goal(patch).faces - static_cast<std::int64_t>(patch.faces.size());
    return std::max<std::int64_t>(1, faces);
}

} // namespace

void sort_faces(Patch &patch, Outcome &outcome) {
    std::vector<int> &faces = patch.faces;
    std::vector<double> &errors = outcome.size_errors;
    std::vector<std::pair<int, double>> order;
    for (std::size_t i = 0; i < faces.size(); ++i)
        order.emplace_back(faces[i], errors.empty() ? 0 : errors[i]);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        faces[i] = order[i].first;
        if (!errors.empty())
            errors[i] = order[i].second;
    }
}

PatchReference::PatchReference(mesh::QuadMesh &mesh, const std::vector<Patch> &patches,
                               const Settings &settings, const GoalOf &goal)
    : reference(reference::reference_of(mesh, patches)) {
    if (settings.edit_boundary)
        reference.boundary = reference::boundary_of(mesh, 1);
    if (!reference.surface) {
        want_sizes(mesh, faces_wanted(mesh, patches, goal));
        return;
    }
    mesh.surface = reference.surface;
    reference = reference::reference_of(mesh);
    if (!reference.surface)
        return;
    reference.planes_first = true;
    const std::int64_t wanted = faces_wanted(mesh, patches, goal);
    reference.surface_distance =
        reference::surface_distance_of(mesh, *reference.surface, wanted, settings.tolerance);
    tolerance_ = reference.surface_distance->tolerance();
    want_sizes(mesh, wanted);
    if (settings.align)
        reference.cross_field = &cross_field_.emplace(mesh);
}

void PatchReference::want_sizes(const mesh::QuadMesh &mesh, std::int64_t wanted) {
    if (mesh.field(Entity::vertex, "size") == nullptr)
        return;
    sizing_ = reference::SizingField::of(mesh, reference, wanted);
    reference.sizes = &*sizing_;
}

void PatchReference::loosen(double times) {
    if (reference.surface_distance)
        reference.surface_distance->set_tolerance(times * tolerance_);
}

refill::Goal goal_of(const Patch &patch, double alpha) {
    refill::Goal goal;
    goal.faces = refill::wanted_faces(patch.alpha > 0 ? patch.alpha : alpha, patch.faces.size());
    goal.or_nearest = true;
    goal.keep_quality = goal.faces == static_cast<std::int64_t>(patch.faces.size());
    return goal;
}

void share(std::vector<Patch> &patches, const std::vector<double> &weights, std::int64_t total) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    double passed = 0;
    std::int64_t given = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        passed += weights[i];
        const std::int64_t now = std::llround(static_cast<double>(total) * passed / sum);
        patches[i].alpha = static_cast<double>(std::max<std::int64_t>(1, now - given)) /
                           static_cast<double>(patches[i].faces.size());
        given = now;
    }
}

bool wants_more_room(const refill::Proposal &proposal) {
    return (proposal.outcome.fault || proposal.unchanged) && proposal.trace.of(refill::Refused::distance) > 0;
}

namespace {

// One call on the patches of a set.
class Refill {
public:
    Refill(mesh::QuadMesh &mesh, std::vector<Patch> &patches, const Settings &settings,
           const Progress &progress, const char *stage, const GoalOf &goal, const Manner &manner)
        : mesh_(mesh), patches_(patches), settings_(settings), progress_(progress), stage_(stage),
          goal_(goal), manner_(manner),
          followed_(mesh, patches, manner.whole != nullptr ? *manner.whole : std::vector<Patch>()),
          workers_(settings.threads), judged_(mesh, patches, settings, goal), outcomes_(patches.size()) {}

    std::vector<Outcome> run() {
        judged_.reference.region_sizes = manner_.sizes;
        std::vector<std::size_t> waiting(patches_.size());
        std::iota(waiting.begin(), waiting.end(), std::size_t{0});
        for (const double times : manner_.tolerances) {
            judged_.loosen(times);
            last_try_ = manner_.last_try && times == manner_.tolerances.back();
            while (!waiting.empty()) {
                const std::vector<std::size_t> batch = independent(mesh_, patches_, waiting);
                // Small rounds, so that progress and cancel are heard in time.
                const std::size_t most = 8 * static_cast<std::size_t>(workers_.count());
                for (std::size_t first = 0; first < batch.size(); first += most)
                    refill_round(std::span(batch).subspan(first, std::min(batch.size() - first, most)));
                for (std::size_t p = 0; p < patches_.size(); ++p)
                    patches_[p] = followed_.now(p);
            }
            waiting.swap(again_);
        }
        progress_(1, stage_);
        for (std::size_t p = 0; p < patches_.size(); ++p)
            sort_faces(patches_[p], outcomes_[p]);
        if (manner_.whole != nullptr)
            *manner_.whole = followed_.around();
        return std::move(outcomes_);
    }

private:
    void refill_round(std::span<const std::size_t> round) {
        progress_(std::min(1.0, static_cast<double>(done_) / static_cast<double>(patches_.size())), stage_);
        std::vector<refill::Proposal> proposals(round.size());
        workers_.run(round.size(), [&](std::size_t i, std::size_t) {
            const Patch region = followed_.now(round[i]);
            refill::Goal goal = goal_(region);
            goal.last_try = last_try_;
            proposals[i] = refill::propose(mesh_, region, goal, settings_, judged_.reference);
        });
        Commits commits(mesh_, judged_.reference);
        for (std::size_t i = 0; i < round.size(); ++i) {
            refill::Proposal &proposal = proposals[i];
            outcomes_[round[i]] = proposal.outcome;
            log_patch(settings_, stage_, round[i], proposal);
            if (wants_more_room(proposal))
                again_.push_back(round[i]);
            else
                ++done_;
            if (!proposal.outcome.fault && !proposal.unchanged) {
                const auto replaced = commits.put(proposal.replacement, proposal.buffer);
                followed_.follow(round[i], proposal.replacement, replaced);
            }
        }
    }

    mesh::QuadMesh &mesh_;
    std::vector<Patch> &patches_;
    const Settings &settings_;
    const Progress &progress_;
    const char *stage_;
    const GoalOf &goal_;
    const Manner manner_;
    Followed followed_;
    const parallel::Workers workers_;
    PatchReference judged_;
    std::vector<Outcome> outcomes_;
    std::vector<std::size_t> again_; // where the tolerance was in the way
    bool last_try_ = false;
    std::size_t done_ = 0;
};

} // namespace

std::vector<Outcome> refill_patches(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                    const Settings &settings, const Progress &progress, const char *stage,
                                    const GoalOf &goal, const Manner &manner) {
    return Refill(mesh, patches, settings, progress, stage, goal, manner).run();
}

} // namespace alphamst::adapt
