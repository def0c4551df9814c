#include "capi/change.h"
#include "capi/guard.h"
#include "capi/handles.h"
#include "capi/limits.h"
#include "chords/edit.h"
#include "smooth/smooth.h"

using namespace alphamst;
using namespace alphamst::capi;

// Options are copied before a change starts: from then on a callback may destroy any handle.

amst_status amst_adapt(amst_mesh *mesh, amst_patches *patches, double alpha, const amst_options *options,
                       amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        require_real(alpha, 0, true, "alpha");
        const Options chosen = options_of(options);
        Change change("adapt", *mesh, patches);
        const Settings settings = settings_of(chosen, change.threads());
        std::vector<Outcome> outcomes;
        if (patches == nullptr && chosen.strategy == 1)
            outcomes = {chords::adapt_chords(change.mesh(), alpha, max_faces, rules_of(chosen), settings,
                                             change.progress())};
        else if (patches == nullptr)
            outcomes = {adapt::adapt_whole(change.mesh(), alpha, settings, change.progress())};
        else
            outcomes = adapt::adapt(change.mesh(), change.regions(), alpha, settings, change.progress());
        return change.finish(outcomes, true, report);
    });
}

amst_status amst_reduce_singularities(amst_mesh *mesh, amst_patches *patches, const amst_options *options,
                                      amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("reduce_singularities", *mesh, patches);
        const Settings settings = settings_of(chosen, change.threads());
        std::vector<Outcome> outcomes;
        if (patches == nullptr)
            outcomes = {adapt::reduce_whole(change.mesh(), settings, change.progress())};
        else
            outcomes =
                adapt::reduce_singularities(change.mesh(), change.regions(), settings, change.progress());
        return change.finish(outcomes, false, report);
    });
}

amst_status amst_smooth(amst_mesh *mesh, const amst_patches *patches, const amst_options *options,
                        amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("smooth", *mesh, patches);
        const Settings settings = settings_of(chosen, change.threads());
        const std::vector<Patch> *regions = patches == nullptr ? nullptr : &change.regions();
        return change.finish(smooth::smooth(change.mesh(), regions, settings, change.progress()), false,
                             report);
    });
}

amst_status amst_clean(amst_mesh *mesh, const amst_options *options, amst_report **report) {
    return guarded(index_base(mesh), [&] {
        required(mesh, "mesh");
        const Options chosen = options_of(options);
        Change change("clean", *mesh, nullptr);
        const Settings settings = settings_of(chosen, change.threads());
        return change.finish({adapt::clean(change.mesh(), settings, change.progress())}, false, report);
    });
}
