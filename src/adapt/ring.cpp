// Rings of faces around the core of a patch.
#include <algorithm>
#include <chrono>
#include <string>

#include "adapt/chord.h"
#include "adapt/ground.h"
#include "adapt/site.h"

namespace alphamst::adapt {
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
void require_sides(const Site &site, const std::vector<int> &corners) {
    std::vector<int> sharp;
    bool straight = true;
    for (std::size_t i = 0; i < site.window.loop.size(); ++i) {
        straight = straight && site.window.inside[i] <= 2;
        if (site.window.inside[i] == 1)
            sharp.push_back(site.window.loop[i]);
    }
    if (!straight || (!sharp.empty() && (sharp.size() < 3 || sharp.size() > 6)))
        throw Refusal{Fault::patch, "rings need a patch with 3 to 6 corners or none and straight sides; this "
                                    "one has " +
                                        std::to_string(sharp.size()) + " corners" +
                                        (straight ? "" : " and is concave somewhere")};
    if (!corners.empty() && !std::is_permutation(corners.begin(), corners.end(), sharp.begin(), sharp.end()))
        throw Refusal{Fault::patch, "the corners that were set are not the boundary vertices with one face"};
}

std::int64_t singular(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += valence != 4 ? count : 0;
    return sum;
}

// More vertices and faces come than go, so no other patch is renumbered.
Outcome insert_rings(mesh::QuadMesh &mesh, Region &patch, int n, const Settings &settings,
                     const Ground &ground) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted =
        static_cast<std::int64_t>(patch.faces.size());
    try {
        Goal goal;
        goal.faces = outcome.faces_before;
        Region without_corners = patch;
        without_corners.corners.clear();
        const Site site(mesh, without_corners, goal, settings, ground);
        const Shape shape{ringed(site.old, n), {}};
        outcome.faces_wanted = static_cast<std::int64_t>(shape.filling.quads.size());
        outcome.valences_before = outcome.valences_after = site.valences(site.old);
        outcome.singular_before = outcome.singular_after = singular(outcome.valences_before);
        outcome.quality_before = outcome.quality_after = site.old_quality;
        require_sides(site, patch.corners);
        const Laid laid = site.lay(shape);
        if (!laid.valid || laid.min_scaled_jacobian <= settings.min_quality)
            throw Refusal{Fault::geometry, "the patch with its rings could not be given a valid shape; try "
                                           "fewer rings or a rounder patch"};
        auto replaced =
            mesh.replace_disk(site.window.faces, site.window.loop, shape.filling.quads, site.lift(laid));
        std::sort(replaced.faces.begin(), replaced.faces.end());
        patch.faces = std::move(replaced.faces);
        outcome.faces_after = outcome.faces_wanted;
        outcome.valences_after = site.valences(shape.filling);
        outcome.singular_after = singular(outcome.valences_after);
        outcome.quality_after = laid.min_scaled_jacobian;
    } catch (const Refusal &refusal) {
        outcome.fault = refusal.fault;
        outcome.text = refusal.text;
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace

std::vector<Outcome> insert_chords(mesh::QuadMesh &mesh, std::vector<Region> &patches, int n,
                                   const Settings &settings, const Progress &progress) {
    std::vector<Outcome> outcomes;
    for (Region &patch : patches) {
        progress(static_cast<double>(outcomes.size()) / static_cast<double>(patches.size()), "insert");
        const Ground ground = ground_of(mesh, std::span(&patch, 1));
        if (ground.surface)
            mesh.surface = ground.surface;
        outcomes.push_back(insert_rings(mesh, patch, n, settings, ground));
    }
    progress(1, "insert");
    return outcomes;
}

} // namespace alphamst::adapt
