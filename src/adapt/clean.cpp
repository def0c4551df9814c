#include <algorithm>
#include <chrono>

#include "geometry/embed.h"
#include "patch/patches.h"
#include "reference/statistics.h"
#include "refill/patch.h"

namespace alphamst::adapt {
namespace {

bool bad(int valence) { return valence < 3 || valence > 5; }

std::int64_t bad_count(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += bad(valence) ? count : 0;
    return sum;
}

// The two faces of a doublet become one, if that one is convex or its place curved.
bool merge_doublet(mesh::QuadMesh &mesh, int v) {
    const std::vector<int> faces = mesh.faces_around(v);
    if (mesh.valence(v) != 2 || patch::defects(mesh, faces) != 0)
        return false;
    const patch::Window window = patch::make_window(mesh, faces);
    const std::vector<std::array<int, 4>> quad{{0, 1, 2, 3}};
    if (window.loop.size() != 4)
        return false;
    if (mesh.dim() == 2) {
        geometry::Points corners;
        for (const int w : window.loop)
            corners.emplace_back(mesh.point(w)[0], mesh.point(w)[1]);
        if (!geometry::judge(quad, corners).valid)
            return false;
    }
    mesh.replace_disk(window.faces, window.loop, quad, {});
    return true;
}

// Refills growing windows around v until one has fewer bad valences.
bool refill_around(mesh::QuadMesh &mesh, int v, const Settings &settings) {
    const std::vector<char> none(static_cast<std::size_t>(mesh.n_faces()), 0);
    for (int rings = 1; rings <= 4; ++rings) {
        Patch region;
        region.faces = patch::repair(mesh, patch::rings(mesh, v, rings, none), none);
        if (region.faces.empty())
            continue;
        refill::Goal goal;
        goal.faces = static_cast<std::int64_t>(region.faces.size());
        goal.any_count = true;
        goal.forbid_old = true;
        const reference::Reference reference = reference::reference_of(mesh, std::span(&region, 1));
        mesh.surface = reference.surface;
        const refill::Proposal proposal = refill::propose(mesh, region, goal, settings, reference);
        if (proposal.outcome.fault || proposal.unchanged ||
            bad_count(proposal.outcome.valences_after) >= bad_count(proposal.outcome.valences_before))
            continue;
        commit(mesh, proposal.replacement);
        return true;
    }
    return false;
}

} // namespace

Outcome clean(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    outcome.faces_before = outcome.faces_wanted = mesh.n_faces();
    outcome.quality_before = reference::least_quality(mesh);
    outcome.aspect_ratio_before = reference::largest_aspect_ratio(mesh);
    reference::count(mesh, outcome.valences_before, outcome.singular_before);
    // Each pass goes over all vertices; what one repair makes possible for another waits for the next.
    const std::int64_t first = std::max<std::int64_t>(1, bad_count(outcome.valences_before));
    for (std::int64_t left = bad_count(outcome.valences_before), before = left + 1;
         left > 0 && left < before;) {
        before = left;
        progress(1 - static_cast<double>(left) / static_cast<double>(first), "clean");
        for (int v = 0; v < mesh.n_vertices(); ++v)
            if (!mesh.isolated(v) && !mesh.on_boundary(v) && bad(mesh.valence(v)) && !merge_doublet(mesh, v))
                refill_around(mesh, v, settings);
        std::map<int, std::int64_t> valences;
        std::int64_t singular = 0;
        reference::count(mesh, valences, singular);
        left = bad_count(valences);
    }
    progress(1, "clean");
    outcome.faces_after = mesh.n_faces();
    outcome.quality_after = reference::least_quality(mesh);
    outcome.aspect_ratio_after = reference::largest_aspect_ratio(mesh);
    reference::count(mesh, outcome.valences_after, outcome.singular_after);
    outcome.singular_bound = 0;
    if (bad_count(outcome.valences_after) > 0) {
        outcome.fault = Fault::no_filling;
        outcome.text =
            std::to_string(bad_count(outcome.valences_after)) +
            " vertices keep a valence below 3 or above 5; no valid refilling of their surroundings was found";
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace alphamst::adapt
