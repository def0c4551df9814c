#include <algorithm>

#include "adapt/off_size.h"
#include "capi/change.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/limits.h"
#include "chords/edit.h"
#include "reference/reference.h"
#include "smooth/smooth.h"

using namespace alphamst;
using namespace alphamst::capi;

namespace {

// Options that count wherever fillings are chosen, and those that do in space alone, or where the boundary
// may change.
std::vector<std::int32_t> for_fillings(bool curved, bool edits_boundary) {
    std::vector<std::int32_t> keys{AMST_OPT_CANDIDATES, AMST_OPT_NODE_LIMIT,  AMST_OPT_MIN_QUALITY,
                                   AMST_OPT_EFFORT,     AMST_OPT_SIZE_WEIGHT, AMST_OPT_TRANSITION,
                                   AMST_OPT_LEAST_SIZE};
    if (curved)
        keys.insert(keys.end(), {AMST_OPT_ALIGN, AMST_OPT_CHART, AMST_OPT_TOLERANCE});
    else if (edits_boundary)
        keys.insert(keys.end(), {AMST_OPT_EDIT_BOUNDARY, AMST_OPT_TOLERANCE});
    return keys;
}

std::vector<std::int32_t> for_whole_mesh(const mesh::QuadMesh &mesh, bool curved, const Settings &settings) {
    std::vector<std::int32_t> keys = for_fillings(curved, settings.edit_boundary);
    keys.push_back(AMST_OPT_STRATEGY);
    if (!adapt::goes_by_band(mesh, settings))
        keys.push_back(AMST_OPT_STARTS);
    if (curved)
        keys.push_back(AMST_OPT_EDIT_BOUNDARY);
    else if (mesh.field(Entity::vertex, "size") != nullptr)
        keys.push_back(AMST_OPT_SIZE_BAND);
    return keys;
}

// Whole meshes that are reduced: chords come in amst_adapt alone, but vertices slide.
std::vector<std::int32_t> for_reduction(bool curved, bool edits_boundary, bool whole) {
    std::vector<std::int32_t> keys = for_fillings(curved, edits_boundary);
    if (whole)
        keys.push_back(AMST_OPT_STARTS);
    if (curved && whole)
        keys.push_back(AMST_OPT_EDIT_BOUNDARY);
    return keys;
}

// Sizes are weighed only where what moves is plane, be it on a curved mesh.
std::vector<std::int32_t> for_smoothing(const mesh::QuadMesh &mesh, const std::vector<Patch> *patches,
                                        bool edits_boundary) {
    const bool any = patches == nullptr
                         ? mesh.n_faces() > 0 && reference::plane_of(mesh)
                         : std::ranges::any_of(*patches, [&](const Patch &patch) {
                               return !patch.faces.empty() && reference::plane_of(mesh, patch.faces);
                           });
    std::vector<std::int32_t> keys;
    if (any)
        keys.push_back(AMST_OPT_SIZE_WEIGHT);
    if (edits_boundary && mesh.dim() == 3)
        keys.insert(keys.end(), {AMST_OPT_EDIT_BOUNDARY, AMST_OPT_TOLERANCE});
    return keys;
}

std::vector<std::int32_t> for_chords(const mesh::QuadMesh &mesh) {
    std::vector<std::int32_t> keys = for_smoothing(mesh, nullptr, false);
    keys.insert(keys.end(), {AMST_OPT_STRATEGY, AMST_OPT_EDIT_BOUNDARY});
    return keys;
}

} // namespace

// Options are copied before a change starts: from then on a callback may destroy any handle.

amst_status amst_adapt(amst_mesh *mesh, amst_patches *patches, double alpha, const amst_options *options,
                       amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        require_real(alpha, 0, true, "alpha");
        const Options chosen = options_of(options);
        Change change("adapt", *mesh, patches);
        if (patches == nullptr)
            require_wanted(change.mesh().n_faces(), alpha);
        else
            require_wanted(change.mesh().n_faces(), change.regions(), alpha);
        const Settings settings = change.settings(chosen);
        std::vector<Outcome> outcomes;
        const bool by_chords = patches == nullptr && chosen.by_chords;
        if (by_chords)
            outcomes = {chords::adapt_chords(change.mesh(), alpha, max_faces, rules_of(chosen), settings,
                                             change.progress())};
        else if (patches == nullptr)
            outcomes = {adapt::adapt_whole(change.mesh(), alpha, settings, change.progress())};
        else
            outcomes = adapt::adapt(change.mesh(), change.regions(), alpha, settings, change.progress());
        std::vector<std::int32_t> in_use;
        if (by_chords)
            in_use = for_chords(change.mesh());
        else if (patches == nullptr)
            in_use = for_whole_mesh(change.mesh(), change.curved(), settings);
        else
            in_use = for_fillings(change.curved(), settings.edit_boundary);
        return change.finish(outcomes, true, in_use, report);
    });
}

amst_status amst_reduce_singularities(amst_mesh *mesh, amst_patches *patches, const amst_options *options,
                                      amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("reduce_singularities", *mesh, patches);
        const Settings settings = change.settings(chosen);
        std::vector<Outcome> outcomes;
        if (patches == nullptr)
            outcomes = {adapt::reduce_whole(change.mesh(), settings, change.progress())};
        else
            outcomes =
                adapt::reduce_singularities(change.mesh(), change.regions(), settings, change.progress());
        return change.finish(outcomes, false,
                             for_reduction(change.curved(), settings.edit_boundary, patches == nullptr),
                             report);
    });
}

amst_status amst_smooth(amst_mesh *mesh, const amst_patches *patches, const amst_options *options,
                        amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("smooth", *mesh, patches);
        const Settings settings = change.settings(chosen);
        const std::vector<Patch> *regions = patches == nullptr ? nullptr : &change.regions();
        const std::vector<Outcome> outcomes =
            smooth::smooth(change.mesh(), regions, settings, change.progress());
        return change.finish(outcomes, false, for_smoothing(change.mesh(), regions, settings.edit_boundary),
                             report);
    });
}

amst_status amst_clean(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("clean", *mesh, nullptr);
        const Settings settings = change.settings(chosen);
        const Outcome outcome = adapt::clean(change.mesh(), settings, change.progress());
        std::vector<std::int32_t> in_use = for_fillings(false, false);
        if (change.curved())
            in_use.push_back(AMST_OPT_CHART);
        return change.finish({outcome}, false, in_use, report);
    });
}
