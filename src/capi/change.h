// One operation under way: it works on a copy of the mesh, and only commit, which
// cannot fail, puts the copy in its place.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "adapt/adapt.h"
#include "capi/handles.h"
#include "capi/options.h"
#include "capi/under_way.h"
#include "reference/projection.h"

namespace alphamst::capi {

class Change {
public:
    // patches may be null. Failure: state, argument (patches of another mesh), stale,
    // cancelled. The handles themselves are not kept: a callback may destroy them.
    Change(const char *name, const amst_mesh &mesh, const amst_patches *patches);

    mesh::QuadMesh &mesh() { return *copy_; }
    std::vector<Patch> &regions() { return regions_; }
    // With the threads and the log of the context. Gives the mesh the curves of its boundary, if that may
    // change.
    Settings settings(const Options &options);
    // What is changed keeps to a surface, be it that nothing was gained and the mesh has none yet.
    bool curved() const;
    const Progress &progress() const { return under_way_.progress(); }

    // One outcome per patch, or one for the whole mesh; exact: a patch that has not the
    // wanted faces makes the result partial. in_use: options that had an effect, see unused_options.
    // Writes *report unless report is null.
    amst_status finish(const std::vector<Outcome> &outcomes, bool exact,
                       const std::vector<std::int32_t> &in_use, amst_report **report);

private:
    Report report_of(const std::vector<Outcome> &outcomes, bool exact) const;
    void write_size_errors(const std::vector<Outcome> &outcomes);
    void describe_meshes(Report &report) const;
    void write_areas(Report &report) const;
    std::string remark(const Outcome &outcome, std::size_t patch) const;
    void record_first_remark(const std::vector<Outcome> &outcomes) const;
    void log(const std::vector<Outcome> &outcomes, const std::vector<std::int32_t> &unused,
             const Report &report) const;
    reference::Project projection() const;
    void commit() noexcept;

    const char *name_;
    std::shared_ptr<Mesh> mesh_;
    std::shared_ptr<Patches> patches_;
    UnderWay under_way_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::shared_ptr<mesh::QuadMesh> copy_;
    std::vector<Patch> regions_;
    Options options_;
};

} // namespace alphamst::capi
