// Rings of faces around the core of a patch.
#include <algorithm>
#include <chrono>
#include <string>

#include "chords/edit.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "refill/cavity.h"

namespace alphamst::chords {
namespace {

// The core inside n rings: ring k of boundary.size() vertices behind ring k - 1.
fill::Filling ringed(const fill::Filling &core, int n) {
    const int length = core.boundary;
    fill::Filling filling{length, core.vertices + n * length, {}};
    for (int ring = 0; ring < n; ++ring)
        for (int i = 0; i < length; ++i) {
            const int outer = ring * length, inner = outer + length, next = (i + 1) % length;
            filling.quads.push_back({outer + i, outer + next, inner + next, inner + i});
        }
    for (std::array<int, 4> quad : core.quads) {
        for (int &v : quad)
            v += n * length;
        filling.quads.push_back(quad);
    }
    return filling;
}

// Every boundary vertex has two faces of the patch, or one at 3 to 6 corners.
void require_sides(const refill::Cavity &cavity, const std::vector<int> &corners) {
    std::vector<int> sharp;
    bool straight = true;
    for (std::size_t i = 0; i < cavity.window.loop.size(); ++i) {
        straight = straight && cavity.window.inside[i] <= 2;
        if (cavity.window.inside[i] == 1)
            sharp.push_back(cavity.window.loop[i]);
    }
    if (!straight || (!sharp.empty() && (sharp.size() < 3 || sharp.size() > 6)))
        throw refill::Refusal{Fault::patch,
                              "rings need a patch with 3 to 6 corners or none and straight sides; this "
                              "one has " +
                                  std::to_string(sharp.size()) + " corners" +
                                  (straight ? "" : " and is concave somewhere")};
    if (!corners.empty() && !std::is_permutation(corners.begin(), corners.end(), sharp.begin(), sharp.end()))
        throw refill::Refusal{Fault::patch,
                              "the corners that were set are not the boundary vertices with one face"};
}

// More vertices and faces come than go, so no other patch is renumbered.
Outcome insert_rings(mesh::QuadMesh &mesh, Patch &patch, int n, const Settings &settings,
                     const reference::Reference &reference) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted =
        static_cast<std::int64_t>(patch.faces.size());
    outcome.quality_before = outcome.quality_after = reference::least_quality(mesh, patch.faces);
    outcome.aspect_ratio_before = outcome.aspect_ratio_after =
        reference::largest_aspect_ratio(mesh, patch.faces);
    const double time_step = reference::time_step(mesh, patch.faces);
    try {
        refill::Goal goal;
        goal.faces = outcome.faces_before;
        Patch without_corners = patch;
        without_corners.corners.clear();
        const refill::Cavity cavity(mesh, without_corners, goal, settings, reference);
        const refill::PlacedFilling shape{ringed(cavity.old, n), {}};
        outcome.faces_wanted = static_cast<std::int64_t>(shape.filling.quads.size());
        outcome.valences_before = outcome.valences_after = cavity.valences(cavity.old);
        outcome.singular_before = outcome.singular_after = reference::singular(outcome.valences_before);
        require_sides(cavity, patch.corners);
        const refill::CavityEmbedding laid = cavity.embed(shape);
        if (!laid.valid || laid.min_scaled_jacobian <= settings.min_quality)
            throw refill::Refusal{Fault::geometry,
                                  "the patch with its rings could not be given a valid shape; try "
                                  "fewer rings or a rounder patch"};
        auto replaced = mesh.replace_disk(cavity.window.faces, cavity.window.loop, shape.filling.quads,
                                          cavity.lift(laid));
        std::sort(replaced.faces.begin(), replaced.faces.end());
        patch.faces = std::move(replaced.faces);
        outcome.faces_after = outcome.faces_wanted;
        outcome.valences_after = cavity.valences(shape.filling);
        outcome.singular_after = reference::singular(outcome.valences_after);
        outcome.quality_after = reference::least_quality(mesh, patch.faces);
        outcome.aspect_ratio_after = reference::largest_aspect_ratio(mesh, patch.faces);
        outcome.time_step = reference::time_step_ratio(time_step, reference::time_step(mesh, patch.faces));
    } catch (const refill::Refusal &refusal) {
        outcome.fault = refusal.fault;
        outcome.text = refusal.text;
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace

std::vector<Outcome> insert_chords(mesh::QuadMesh &mesh, std::vector<Patch> &patches, int n,
                                   const Settings &settings, const Progress &progress) {
    std::vector<Outcome> outcomes;
    for (Patch &patch : patches) {
        progress(static_cast<double>(outcomes.size()) / static_cast<double>(patches.size()), "insert");
        const reference::Reference reference = reference::reference_of(mesh, std::span(&patch, 1));
        if (reference.surface)
            mesh.surface = reference.surface;
        outcomes.push_back(insert_rings(mesh, patch, n, settings, reference));
    }
    progress(1, "insert");
    return outcomes;
}

} // namespace alphamst::chords
