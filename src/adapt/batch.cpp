#include "adapt/batch.h"

#include <algorithm>
#include <numeric>

#include "parallel/workers.h"

namespace alphamst::adapt {
namespace {

// Follows the faces and corners of all patches while commits renumber the mesh.
class Numbers {
public:
    Numbers(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches)
        : owner_(static_cast<std::size_t>(mesh.n_faces()), -1),
          vertex_(static_cast<std::size_t>(mesh.n_vertices())), start_(vertex_.size()) {
        std::iota(vertex_.begin(), vertex_.end(), 0);
        std::iota(start_.begin(), start_.end(), 0);
        for (std::size_t p = 0; p < patches.size(); ++p)
            for (const int f : patches[p].faces)
                owner_[static_cast<std::size_t>(f)] = static_cast<int>(p);
    }

    void follow(const mesh::QuadMesh &mesh, int patch, const refill::Proposal &proposal,
                const mesh::QuadMesh::Replaced &replaced, std::vector<Patch> &patches) {
        const auto faces = static_cast<std::size_t>(mesh.n_faces());
        owner_.resize(std::max(owner_.size(), faces), -1);
        start_.resize(std::max(start_.size(), static_cast<std::size_t>(mesh.n_vertices())), -1);
        for (const int v : proposal.window.interior)
            start_[static_cast<std::size_t>(v)] = -1;
        for (const int v : replaced.vertices)
            start_[static_cast<std::size_t>(v)] = -1;
        for (const int f : proposal.window.faces)
            owner_[static_cast<std::size_t>(f)] = -1;
        patches[static_cast<std::size_t>(patch)].faces = replaced.faces;
        for (const int f : replaced.faces)
            owner_[static_cast<std::size_t>(f)] = patch;
        for (const auto &[from, to] : replaced.moved_faces) {
            const int moved = owner_[static_cast<std::size_t>(from)];
            owner_[static_cast<std::size_t>(to)] = moved;
            if (moved >= 0) {
                auto &mine = patches[static_cast<std::size_t>(moved)].faces;
                std::replace(mine.begin(), mine.end(), from, to);
            }
        }
        for (const auto &[from, to] : replaced.moved_vertices) {
            const int first = start_[static_cast<std::size_t>(from)];
            start_[static_cast<std::size_t>(to)] = first;
            if (first >= 0)
                vertex_[static_cast<std::size_t>(first)] = to;
        }
        owner_.resize(faces);
        start_.resize(static_cast<std::size_t>(mesh.n_vertices()));
    }

    // Number now of a vertex that had this number at the start.
    int vertex(int at_start) const { return vertex_[static_cast<std::size_t>(at_start)]; }

private:
    std::vector<int> owner_;          // [faces now] patch
    std::vector<int> vertex_, start_; // [vertices at the start] now, and back
};

// The first patches in order that target_count no vertex with another of the batch.
std::vector<std::size_t> independent(const mesh::QuadMesh &mesh, const std::vector<Patch> &patches,
                                     std::vector<std::size_t> &waiting) {
    std::vector<char> used(static_cast<std::size_t>(mesh.n_vertices()), 0);
    std::vector<std::size_t> batch, later;
    for (const std::size_t p : waiting) {
        bool free = true;
        for (const int f : patches[p].faces)
            for (const int v : mesh.corners(f))
                free = free && !used[static_cast<std::size_t>(v)];
        // A patch that waits keeps its vertices from those after it, or order would matter.
        for (const int f : patches[p].faces)
            for (const int v : mesh.corners(f))
                used[static_cast<std::size_t>(v)] = 1;
        (free ? batch : later).push_back(p);
    }
    waiting = std::move(later);
    return batch;
}

} // namespace

std::vector<Outcome> refill(mesh::QuadMesh &mesh, std::vector<Patch> &patches, const Settings &settings,
                            const Progress &progress, const char *stage,
                            const std::function<refill::Goal(const Patch &)> &goal) {
    std::vector<Outcome> outcomes(patches.size());
    std::vector<std::size_t> waiting(patches.size());
    std::iota(waiting.begin(), waiting.end(), std::size_t{0});
    Numbers numbers(mesh, patches);
    const parallel::Workers workers(settings.threads);
    const reference::Reference reference = reference::reference_of(mesh, patches);
    mesh.surface = reference.surface;
    const std::size_t round = 8 * static_cast<std::size_t>(workers.count());
    std::size_t done = 0;
    while (!waiting.empty()) {
        const std::vector<std::size_t> batch = independent(mesh, patches, waiting);
        // Small rounds, so that progress and cancel are heard in time.
        for (std::size_t first = 0; first < batch.size(); first += round) {
            progress(static_cast<double>(done) / static_cast<double>(patches.size()), stage);
            const std::size_t last = std::min(batch.size(), first + round);
            std::vector<refill::Proposal> proposals(last - first);
            auto propose_one = [&](std::size_t i, std::size_t) {
                Patch region = patches[batch[first + i]];
                for (int &corner : region.corners)
                    corner = numbers.vertex(corner);
                proposals[i] = refill::propose(mesh, region, goal(region), settings, reference);
            };
            workers.run(proposals.size(), propose_one);
            for (std::size_t i = 0; i < proposals.size(); ++i, ++done) {
                refill::Proposal &proposal = proposals[i];
                const std::size_t p = batch[first + i];
                outcomes[p] = proposal.outcome;
                if (proposal.outcome.fault)
                    continue;
                // Earlier commits of the round may have renumbered what this one touches.
                proposal.window.faces = patches[p].faces;
                for (std::size_t k = 0; k < i; ++k)
                    for (const auto &[from, to] : proposals[k].moved_vertices) {
                        std::replace(proposal.window.loop.begin(), proposal.window.loop.end(), from, to);
                        std::replace(proposal.window.interior.begin(), proposal.window.interior.end(), from,
                                     to);
                    }
                const auto replaced = commit(mesh, proposal);
                proposal.moved_vertices = replaced.moved_vertices;
                numbers.follow(mesh, static_cast<int>(p), proposal, replaced, patches);
            }
        }
    }
    progress(1, stage);
    for (Patch &region : patches) {
        std::sort(region.faces.begin(), region.faces.end());
        for (int &corner : region.corners)
            corner = numbers.vertex(corner);
    }
    return outcomes;
}

} // namespace alphamst::adapt
