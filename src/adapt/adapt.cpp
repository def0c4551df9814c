#include "adapt/adapt.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "adapt/divide.h"
#include "adapt/patches.h"
#include "patch/window.h"
#include "refill/patch.h"

namespace alphamst::adapt {

namespace {

// Of the tolerances, before parts are tried: farther from the surface than that, many singular vertices more
// are the lesser evil.
constexpr std::size_t firm_tolerances = 2;

bool is_open(const Outcome &outcome) {
    return outcome.fault == Fault::no_filling || outcome.fault == Fault::geometry;
}

bool stays(const Outcome &outcome) {
    return !outcome.fault && outcome.faces_after == outcome.faces_before &&
           outcome.faces_wanted == outcome.faces_before && outcome.singular_after == outcome.singular_before;
}

// A patch with inverted faces, or a large one of many singular vertices, for which no better filling was
// found.
bool stays_bad(const Outcome &outcome) {
    // Faces; faces for a singular vertex. A patch of 887 faces in the shape of a C kept 233, in parts 114.
    constexpr std::int64_t large = 300, seldom = 12;
    const bool has_many =
        outcome.faces_before >= large && outcome.singular_after * seldom > outcome.faces_after;
    return stays(outcome) && (has_many || !(outcome.quality_after > 0));
}

// Or a ring, or a region with several holes, which has no single filling.
bool is_for_parts(const mesh::QuadMesh &mesh, const Patch &patch, const Outcome &outcome) {
    return is_open(outcome) ||
           (outcome.fault == Fault::patch && patch::defects(mesh, patch.faces) == patch::not_disk) ||
           stays_bad(outcome);
}

// What no single filling does is done in parts.
void divide(mesh::QuadMesh &mesh, std::vector<Patch> &patches, const Settings &settings,
            const Progress &progress, std::vector<Outcome> &outcomes) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
        Outcome &outcome = outcomes[p];
        if (!is_for_parts(mesh, patches[p], outcome))
            continue;
        const Outcome told = outcome;
        const std::vector<Patch> patches_before = patches;
        std::optional<mesh::QuadMesh> mesh_before;
        if (is_open(told))
            mesh_before = mesh;
        refill_in_parts(mesh, patches, p, outcome.faces_wanted, settings, progress, outcome);
        // A fault says that the patch was left exactly as it was, so it is.
        if (mesh_before && outcome.faces_after == outcome.faces_before) {
            mesh = std::move(*mesh_before);
            patches = patches_before;
            outcome = told;
            continue;
        }
        outcome.fault.reset();
        if (outcome.faces_after == outcome.faces_wanted)
            outcome.text.clear();
        else
            outcome.text += "; in parts it came to " + std::to_string(outcome.faces_after) + " faces";
    }
}

// What could not be done in parts either, farther from the surface.
void loosen(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha, const Settings &settings,
            const Progress &progress, std::vector<Outcome> &outcomes) {
    for (std::size_t p = 0; mesh.surface != nullptr && p < patches.size(); ++p) {
        if (!is_open(outcomes[p]))
            continue;
        std::vector<Patch> one{patches[p]};
        Manner manner;
        manner.tolerances = std::span(tolerances).subspan(firm_tolerances);
        manner.whole = &patches;
        outcomes[p] = refill_patches(
                          mesh, one, settings, progress, "adapt",
                          [alpha](const Patch &patch) { return goal_of(patch, alpha); }, manner)
                          .front();
        patches[p] = one.front(); // in the order of what is known of each face
    }
}

} // namespace

std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha,
                           const Settings &settings, const Progress &progress) {
    Manner manner;
    manner.tolerances = std::span(tolerances).first(firm_tolerances);
    manner.last_try = false;
    std::vector<Outcome> outcomes = refill_patches(
        mesh, patches, settings, progress, "adapt",
        [alpha](const Patch &patch) { return goal_of(patch, alpha); }, manner);
    divide(mesh, patches, settings, progress, outcomes);
    loosen(mesh, patches, alpha, settings, progress, outcomes);
    for (std::size_t p = 0; p < patches.size(); ++p)
        sort_faces(patches[p], outcomes[p]);
    return outcomes;
}

std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Patch> &patches,
                                          const Settings &settings, const Progress &progress) {
    return refill_patches(mesh, patches, settings, progress, "reduce", [](const Patch &patch) {
        refill::Goal goal;
        goal.faces = static_cast<std::int64_t>(patch.faces.size());
        goal.any_count = true;
        return goal;
    });
}

Prediction predict(const mesh::QuadMesh &mesh, const Patch &patch, double alpha, const Settings &settings) {
    // Which filling is the best only the sizes and shapes of some can tell.
    mesh::QuadMesh copy = mesh;
    copy.begun = std::make_shared<const mesh::QuadMesh>(mesh);
    std::vector<Patch> patches{patch};
    const Outcome outcome = adapt(copy, patches, alpha, settings, [](double, const char *) {}).front();
    if (outcome.fault)
        throw Failure(*outcome.fault, outcome.text);
    return {outcome.faces_after, outcome.singular_after};
}

} // namespace alphamst::adapt
