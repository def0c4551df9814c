#include "capi/change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "capi/guard.h"
#include "index.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "transfer/carry.h"

namespace alphamst::capi {
namespace {

Report::Row row_of(const Outcome &outcome, bool exact) {
    Report::Row row;
    row.status = outcome.fault ? status_of(*outcome.fault)
                 : exact && outcome.faces_after != outcome.faces_wanted
                     ? static_cast<amst_status>(AMST_PARTIAL)
                     : static_cast<amst_status>(AMST_OK);
    row.faces_before = outcome.faces_before;
    row.faces_after = outcome.faces_after;
    row.faces_wanted = outcome.faces_wanted;
    row.singular_before = outcome.singular_before;
    row.singular_after = outcome.singular_after;
    row.singular_bound = outcome.singular_bound;
    row.candidate = outcome.candidate;
    row.quality_before = outcome.quality_before;
    row.quality_after = outcome.quality_after;
    row.seconds = outcome.seconds;
    row.size_error_before = outcome.size_error_before;
    row.size_error_after = outcome.size_error_after;
    row.least_area_before = outcome.least_area_before;
    row.least_area_after = outcome.least_area_after;
    row.shortest_edge_before = outcome.shortest_edge_before;
    row.shortest_edge_after = outcome.shortest_edge_after;
    row.aspect_ratio_before = outcome.aspect_ratio_before;
    row.aspect_ratio_after = outcome.aspect_ratio_after;
    row.time_step = outcome.time_step;
    row.valences_before = outcome.valences_before;
    row.valences_after = outcome.valences_after;
    return row;
}

// Counts are added up, qualities, areas and edges are the smallest, aspect ratios the largest, the candidate
// is the latest.
void include(Report::Row &all, const Report::Row &row, bool first) {
    if (row.status != AMST_OK)
        all.status = AMST_PARTIAL;
    all.faces_before += row.faces_before;
    all.faces_after += row.faces_after;
    all.faces_wanted += row.faces_wanted;
    all.singular_bound += row.singular_bound;
    all.candidate = std::max(all.candidate, row.candidate);
    all.quality_before = first ? row.quality_before : std::min(all.quality_before, row.quality_before);
    all.quality_after = first ? row.quality_after : std::min(all.quality_after, row.quality_after);
    all.aspect_ratio_before = std::max(all.aspect_ratio_before, row.aspect_ratio_before);
    all.aspect_ratio_after = std::max(all.aspect_ratio_after, row.aspect_ratio_after);
    // These pass over what is NaN.
    all.least_area_before = std::fmin(all.least_area_before, row.least_area_before);
    all.least_area_after = std::fmin(all.least_area_after, row.least_area_after);
    all.shortest_edge_before = std::fmin(all.shortest_edge_before, row.shortest_edge_before);
    all.shortest_edge_after = std::fmin(all.shortest_edge_after, row.shortest_edge_after);
}

// [edges] The origin of each that has the same vertices as that; -1 for the others, which may be pieces of
// it.
std::vector<std::int32_t> same_edges(const mesh::QuadMesh &before, const mesh::QuadMesh &after) {
    std::vector<std::int32_t> origin = after.edge_origin;
    for (std::size_t e = 0; e < origin.size(); ++e) {
        std::array<int, 2> ends = after.edge_vertices(static_cast<int>(e));
        for (int &v : ends)
            v = after.vertex_origin[at(v)];
        std::sort(ends.begin(), ends.end());
        if (origin[e] >= 0 && ends != before.edge_vertices(origin[e]))
            origin[e] = -1;
    }
    return origin;
}

// [faces] Likewise.
std::vector<std::int32_t> same_faces(const mesh::QuadMesh &before, const mesh::QuadMesh &after) {
    std::vector<std::int32_t> origin = after.face_origin;
    for (std::size_t f = 0; f < origin.size(); ++f) {
        std::array<int, 4> corners = after.corners(static_cast<int>(f));
        for (int &v : corners)
            v = after.vertex_origin[at(v)];
        if (origin[f] >= 0 && corners != before.corners(origin[f]))
            origin[f] = -1;
    }
    return origin;
}

// Root mean square over the faces of the patches that have such an error; NaN if none has.
double rms(const std::vector<Outcome> &outcomes, double Outcome::*error, std::int64_t Outcome::*faces) {
    double sum = 0, weight = 0;
    for (const Outcome &outcome : outcomes) {
        const double one = outcome.*error;
        if (std::isnan(one))
            continue;
        sum += static_cast<double>(outcome.*faces) * one * one;
        weight += static_cast<double>(outcome.*faces);
    }
    return std::sqrt(sum / weight);
}

// Whatever went wrong before, nobody gets a mesh with such a vertex.
void require_finite(const mesh::QuadMesh &mesh) {
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const double coordinate : mesh.point(v))
            if (!std::isfinite(coordinate))
                throw Failure(
                    Fault::internal,
                    "vertex {} would have got a coordinate that is not a finite number, which is a bug; "
                    "the mesh is as it was",
                    Entity::vertex, {v});
}

} // namespace

Change::Change(const char *name, const amst_mesh &mesh, const amst_patches *patches)
    : name_(name), mesh_(mesh.impl), patches_(patches == nullptr ? nullptr : patches->impl),
      under_way_(mesh_->context) {
    if (patches_ != nullptr) {
        if (patches_->mesh != mesh_)
            throw Failure(Fault::argument, "the patches are of another mesh");
        patches_->require_current();
        regions_ = patches_->regions;
    }
    progress()(0, "start");
    copy_ = std::make_shared<mesh::QuadMesh>(*mesh_->current);
    copy_->reset_origins();
    copy_->begun = mesh_->current;
}

bool Change::curved() const {
    if (copy_->dim() == 2 || copy_->surface != nullptr)
        return copy_->dim() == 3;
    if (patches_ == nullptr)
        return !reference::plane_of(*copy_);
    return std::ranges::any_of(regions_, [this](const Patch &patch) {
        return !patch.faces.empty() && !reference::plane_of(*copy_, patch.faces);
    });
}

Settings Change::settings(const Options &options) {
    options_ = options;
    const Context &context = *mesh_->context;
    Settings settings = settings_of(options, context.threads);
    if (context.log != nullptr)
        settings.log = std::make_shared<const Log>(Log{
            context.log_level, [this](int level, const std::string &message) {
                mesh_->context->say(level, std::string(name_) + ": " + message); // it may have changed since
            }});
    if (settings.edit_boundary)
        reference::keep_boundary(*copy_, projection(), settings.tolerance);
    return settings;
}

// Empty if the caller set none.
reference::Project Change::projection() const {
    if (mesh_->projection == nullptr)
        return {};
    return [fn = mesh_->projection, user = mesh_->projection_user, dim = at(copy_->dim())](
               std::span<const std::int32_t> markers, const std::vector<Eigen::Vector3d> &points) {
        std::vector<double> given, found(dim * points.size(), std::numeric_limits<double>::quiet_NaN());
        for (const Eigen::Vector3d &p : points)
            given.insert(given.end(), p.data(), p.data() + dim);
        const Stop none(nullptr);
        if (const std::int32_t status = fn(user, static_cast<std::int64_t>(points.size()), markers.data(),
                                           given.data(), found.data());
            status != 0)
            throw Failure(Fault::projection,
                          "the projection of the boundary returned " + std::to_string(status));
        std::vector<Eigen::Vector3d> projected(points.size(), Eigen::Vector3d::Zero());
        for (std::size_t i = 0; i < projected.size(); ++i)
            std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(i * dim), dim, projected[i].data());
        return projected;
    };
}

Report Change::report_of(const std::vector<Outcome> &outcomes, bool exact) const {
    Report report;
    report.index_base = mesh_->context->index_base;
    bool first = true;
    for (const Outcome &outcome : outcomes) {
        Report::Row row = row_of(outcome, exact);
        include(report.all, row, first);
        first = false;
        if (patches_ != nullptr)
            report.patches.push_back(std::move(row));
    }
    report.all.size_error_before = rms(outcomes, &Outcome::size_error_before, &Outcome::faces_before);
    report.all.size_error_after = rms(outcomes, &Outcome::size_error_after, &Outcome::faces_after);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    report.all.seconds = spent.count();
    return report;
}

void Change::write_size_errors(const std::vector<Outcome> &outcomes) {
    const mesh::Field *field = copy_->fields.find(Entity::face, size_error_field);
    if (field == nullptr || field->components != 1)
        return;
    auto renewed = std::make_shared<mesh::Field>(*field);
    for (std::size_t p = 0; p < outcomes.size(); ++p) {
        const std::vector<double> &errors = outcomes[p].size_errors;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const std::size_t face = patches_ == nullptr ? i : static_cast<std::size_t>(regions_[p].faces[i]);
            if (std::isfinite(errors[i])) // as all values of fields are
                renewed->values[face] = errors[i];
        }
    }
    copy_->fields.set(std::move(renewed));
}

void Change::describe_meshes(Report &report) const {
    reference::count(*mesh_->current, report.all.valences_before, report.all.singular_before);
    reference::count(*copy_, report.all.valences_after, report.all.singular_after);
    report.all.time_step =
        reference::time_step_ratio(reference::time_step(*mesh_->current), reference::time_step(*copy_));
    report.vertices = {copy_->n_vertices(), copy_->vertex_origin};
    report.edges = {copy_->n_edges(), same_edges(*mesh_->current, *copy_)};
    report.faces = {copy_->n_faces(), same_faces(*mesh_->current, *copy_)};
}

// Why it is not what was asked for; empty if it is.
std::string Change::remark(const Outcome &outcome, std::size_t patch) const {
    if (outcome.text.empty())
        return {};
    const int base = mesh_->context->index_base;
    const std::string what = patches_ == nullptr
                                 ? std::string("mesh")
                                 : "patch " + std::to_string(patch + static_cast<std::size_t>(base));
    return what + (outcome.fault ? " was left: " : ": ") + outcome.text;
}

// amst_last_error has the words of the first that is not what was asked for.
void Change::record_first_remark(const std::vector<Outcome> &outcomes) const {
    for (std::size_t p = 0; p < outcomes.size(); ++p)
        if (const std::string text = remark(outcomes[p], p); !text.empty()) {
            record_remark(text, patches_ == nullptr ? -1 : static_cast<int>(p), mesh_->context->index_base);
            return;
        }
}

void Change::log(const std::vector<Outcome> &outcomes, const std::vector<std::int32_t> &unused,
                 const Report &report) const {
    const Context &context = *mesh_->context;
    const auto say = [&](std::int32_t level, const std::string &message) { context.say(level, message); };
    for (std::size_t p = 0; p < outcomes.size(); ++p)
        if (const std::string text = remark(outcomes[p], p); !text.empty())
            say(AMST_LOG_WARNING, std::string(name_) + ": " + text);
    for (const std::int32_t key : unused)
        say(AMST_LOG_WARNING,
            std::string(name_) + ": " + option_name(key) + " was set and has no effect on this call");
    say(AMST_LOG_INFO, std::string(name_) + ": " + std::to_string(report.all.faces_before) +
                           " faces before, " + std::to_string(report.all.faces_after) + " after, in " +
                           std::to_string(report.all.seconds) + " s");
}

void Change::write_areas(Report &report) const {
    const auto area = [](const mesh::QuadMesh &mesh, std::span<const int> faces) {
        double sum = 0;
        for (const int f : faces)
            sum += quality::measure(quality::Metric::area, reference::quad_of(mesh, f), 0);
        return sum;
    };
    const auto all = [](const mesh::QuadMesh &mesh) {
        std::vector<int> faces(at(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        return faces;
    };
    report.all.area_gained = area(*copy_, all(*copy_)) - area(*mesh_->current, all(*mesh_->current));
    for (std::size_t p = 0; p < report.patches.size(); ++p)
        report.patches[p].area_gained =
            area(*copy_, regions_[p].faces) - area(*mesh_->current, patches_->regions[p].faces);
}

amst_status Change::finish(const std::vector<Outcome> &outcomes, bool exact,
                           const std::vector<std::int32_t> &in_use, amst_report **report) {
    if (const reference::Project project = projection(); project && options_.edit_boundary)
        reference::project_new_vertices(*copy_, project, settings_of(options_, 1).tolerance);
    transfer::carry(*mesh_->current, *copy_, progress());
    write_size_errors(outcomes);
    auto made = std::make_unique<amst_report>(amst_report{report_of(outcomes, exact)});
    if (report != nullptr)
        describe_meshes(made->impl);
    if (options_.edit_boundary)
        write_areas(made->impl);
    const std::vector<std::int32_t> unused = unused_options(options_, in_use);
    if (!unused.empty())
        made->impl.all.unused_option = unused.front();
    log(outcomes, unused, made->impl);
    require_finite(*copy_);
    progress()(1, "commit"); // last, so that a log function can cancel, too
    const amst_status status = made->impl.all.status;
    if (status == AMST_PARTIAL)
        record_first_remark(outcomes);
    commit();
    if (report != nullptr)
        *report = made.release();
    return status;
}

void Change::commit() noexcept {
    const bool changed = transfer::reconnected(*mesh_->current, *copy_);
    copy_->begun.reset();
    mesh_->current = std::move(copy_);
    if (!changed)
        return;
    mesh_->revision = ++mesh_->last_revision;
    if (patches_ != nullptr) {
        patches_->regions.swap(regions_);
        patches_->revision = mesh_->revision;
    }
}

} // namespace alphamst::capi
