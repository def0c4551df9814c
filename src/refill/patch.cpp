#include "refill/patch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "reference/statistics.h"
#include "refill/buffer_ring.h"
#include "refill/cavity.h"
#include "refill/choice.h"
#include "refill/respacing.h"

namespace alphamst::refill {
namespace {

// In singular vertices, of edges of the boundary that are twice as long as is wanted: who lets the boundary
// change wants that, unless it spoils the patch.
constexpr double price_of_boundary = 10;

// Least number of singular vertices that any filling of this boundary has.
std::int64_t bound(const Cavity &cavity, const mesh::QuadMesh &mesh) {
    const auto &window = cavity.window;
    std::int64_t forced = 0;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        forced += !mesh.on_boundary(window.loop[i]) && window.outside[i] >= 4;
    return forced;
}

// The faces around a patch matter where features run along its border.
std::vector<int> buffer_of(const mesh::QuadMesh &mesh, const Cavity &cavity) {
    if (!mesh.curves || !cavity.curved())
        return {};
    std::vector<int> faces;
    for (const int v : cavity.window.loop)
        for (const int f : mesh.faces_around(v))
            if (!std::binary_search(cavity.window.faces.begin(), cavity.window.faces.end(), f))
                faces.push_back(f);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

// The old quads are in ascending order of the faces, those of the patch may be in any.
std::vector<double> in_order_of(const Patch &patch, const Cavity &cavity, const std::vector<double> &values) {
    const std::vector<int> &ascending = cavity.window.faces;
    std::vector<double> ordered;
    for (const int f : patch.faces)
        ordered.push_back(values[static_cast<std::size_t>(
            std::lower_bound(ascending.begin(), ascending.end(), f) - ascending.begin())]);
    return ordered;
}

// What is there before.
void tell_present(const mesh::QuadMesh &mesh, const Patch &patch, const Cavity &cavity, Outcome &outcome) {
    outcome.valences_before = outcome.valences_after = cavity.valences(cavity.old);
    outcome.singular_before = outcome.singular_after = reference::singular(outcome.valences_before);
    outcome.singular_bound = bound(cavity, mesh);
    outcome.quality_before = outcome.quality_after = reference::least_quality(mesh, patch.faces);
    reference::tell_sizes_before(cavity.old_size_error(), outcome);
    outcome.size_errors = in_order_of(patch, cavity, outcome.size_errors);
}

// Faces, shapes and sizes of what comes in the place of the patch.
void tell_taken(const mesh::QuadMesh &mesh, const Patch &patch, const Replacement &taken,
                const SizeError &sizes, Outcome &outcome) {
    const auto &quads = taken.filling.quads;
    std::vector<OpenMesh::Vec3d> points;
    for (const Eigen::Vector3d &p : loop_points(mesh, taken.window))
        points.emplace_back(p.x(), p.y(), p.z());
    points.insert(points.end(), taken.points.begin(), taken.points.end());
    outcome.faces_after = static_cast<std::int64_t>(quads.size());
    outcome.quality_after = reference::least_quality(quads, points);
    outcome.aspect_ratio_after = reference::largest_aspect_ratio(quads, points);
    reference::tell_sizes_after(sizes, outcome);
    outcome.time_step = reference::time_step_ratio(reference::time_step(mesh, patch.faces),
                                                   reference::time_step(quads, points));
}

// Throws Refusal where there is no filling.
void fill(const mesh::QuadMesh &mesh, const Patch &patch, const Cavity &cavity, const Goal &goal,
          const Settings &settings, Proposal &proposal) {
    Outcome &outcome = proposal.outcome;
    const BufferRing buffer(mesh, cavity, buffer_of(mesh, cavity), true);
    Evaluator evaluator(mesh, cavity, buffer, settings, proposal.trace);
    Chosen best = FillingChoice(cavity, evaluator, proposal.trace, goal, settings).run();
    proposal.unchanged = !best.evaluation;
    if (proposal.unchanged)
        return;
    proposal.replacement = std::move(best.evaluation->replacement);
    proposal.buffer = buffer.faces();
    tell_taken(mesh, patch, proposal.replacement, best.evaluation->size_error, outcome);
    outcome.valences_after = std::move(best.valences);
    outcome.singular_after = reference::singular(outcome.valences_after);
    outcome.candidate = best.number;
}

struct RespacedProposal {
    Proposal proposal;
    double boundary_error; // before
};

// With the vertices on the boundary of the mesh that are wanted, or that are nearest to it; nothing if there
// is no such filling. before: what is known of the patch.
std::optional<RespacedProposal> fill_respaced(const mesh::QuadMesh &mesh, const Patch &patch,
                                              const Cavity &cavity, const Goal &goal,
                                              const Settings &settings, const Proposal &before) {
    const auto &boundary = cavity.reference().boundary;
    if (!boundary || cavity.curved())
        return std::nullopt;
    // Faces at the boundary that are longer than wide stay so.
    const reference::EdgeLength edge_length = [&](surface::CurvePlace place) {
        const Eigen::Vector3d point = boundary->curves->at(place);
        const double by_area = std::sqrt(cavity.wanted_area(point));
        return cavity.reference().sizes != nullptr
                   ? by_area
                   : std::max(by_area,
                              boundary->present_length(place) * std::sqrt(cavity.wanted_part(point)));
    };
    const Respacing respacing(mesh, cavity.window, *boundary, edge_length, settings.tolerance, patch.corners);
    for (const Respacing::Counts &counts : respacing.towards()) {
        std::optional<patch::Window> window = respacing.window(counts, true);
        if (!window)
            continue;
        try {
            Cavity respaced(mesh, patch, goal, settings, cavity.reference());
            respaced.respace(std::move(*window));
            Proposal proposal = before;
            fill(mesh, patch, respaced, goal, settings, proposal);
            if (!proposal.unchanged)
                return RespacedProposal{std::move(proposal), respacing.present_error()};
        } catch (const Refusal &) {
        }
    }
    return std::nullopt;
}

// nearest: gets other numbers of faces to try where that one cannot be had and others would do.
Proposal propose_exactly(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal,
                         const Settings &settings, const reference::Reference &reference,
                         std::vector<std::int64_t> &nearest) {
    Proposal proposal;
    Outcome &outcome = proposal.outcome;
    outcome.faces_before = outcome.faces_after = static_cast<std::int64_t>(patch.faces.size());
    outcome.faces_wanted = goal.faces;
    outcome.aspect_ratio_before = outcome.aspect_ratio_after =
        reference::largest_aspect_ratio(mesh, patch.faces);
    std::optional<Cavity> cavity;
    try {
        cavity.emplace(mesh, patch, goal, settings, reference);
        tell_present(mesh, patch, *cavity, outcome);
        std::optional<RespacedProposal> respaced =
            fill_respaced(mesh, patch, *cavity, goal, settings, proposal);
        try {
            fill(mesh, patch, *cavity, goal, settings, proposal);
        } catch (const Refusal &) {
            if (!respaced)
                throw;
        }
        if (respaced && (proposal.replacement.filling.quads.empty() ||
                         price_of(respaced->proposal.outcome) <=
                             price_of(outcome) + price_of_boundary * respaced->boundary_error))
            proposal = std::move(respaced->proposal);
    } catch (const Refusal &refusal) {
        outcome.fault = refusal.fault;
        outcome.text = refusal.text;
        const bool is_last = goal.last_try || proposal.trace.of(Refused::distance) == 0;
        if (cavity && goal.or_nearest && is_last)
            nearest = cavity->nearest_counts();
    }
    return proposal;
}

// The first whose shapes do, else the one with the best.
void take_nearest(const mesh::QuadMesh &mesh, const Patch &patch, Goal goal, const Settings &settings,
                  const reference::Reference &reference, const std::vector<std::int64_t> &nearest,
                  Proposal &proposal) {
    // Smallest scaled Jacobians: Verdict's acceptable one less what tight boundaries cost, and one that is
    // not worth a few faces less.
    constexpr double enough = 0.2, least = 0.1;
    const std::string reason = proposal.outcome.text;
    const std::int64_t wanted = goal.faces;
    const double does = std::min(enough, proposal.outcome.quality_before);
    goal.or_nearest = false; // of these there are no others
    for (const std::int64_t count : nearest) {
        goal.faces = count;
        std::vector<std::int64_t> none;
        Proposal other = propose_exactly(mesh, patch, goal, settings, reference, none);
        if (other.outcome.fault || other.outcome.faces_after == other.outcome.faces_before ||
            other.outcome.quality_after < std::min(least, does) ||
            (!proposal.outcome.fault && other.outcome.quality_after <= proposal.outcome.quality_after))
            continue;
        proposal = std::move(other);
        if (proposal.outcome.quality_after >= does)
            break;
    }
    if (proposal.outcome.fault)
        return;
    proposal.outcome.faces_wanted = wanted;
    proposal.outcome.text =
        reason + "; the nearest number of faces is " + std::to_string(proposal.outcome.faces_after);
}

} // namespace

std::int64_t wanted_faces(double alpha, std::size_t faces) {
    return std::llround(std::min(alpha * static_cast<double>(faces), 4e18));
}

Proposal propose(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
                 const reference::Reference &reference) {
    const auto start = std::chrono::steady_clock::now();
    Goal asked = goal;
    asked.sizes = true;
    std::vector<std::int64_t> nearest;
    Proposal proposal = propose_exactly(mesh, patch, asked, settings, reference, nearest);
    if (!nearest.empty())
        take_nearest(mesh, patch, asked, settings, reference, nearest, proposal);
    proposal.outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return proposal;
}

mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Replacement &replacement) {
    const patch::Window &window = replacement.window;
    std::vector<OpenMesh::Vec3d> points = window.added;
    points.insert(points.end(), replacement.points.begin(), replacement.points.end());
    return mesh.replace_disk(window.faces, window.loop, replacement.filling.quads, points, window.parents);
}

} // namespace alphamst::refill
