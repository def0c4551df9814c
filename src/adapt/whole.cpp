// Whole meshes: a start by chords, then the stages; once or twice more with less room where there would be
// more singular vertices than before.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <tuple>

#include "adapt/chord_prepass.h"
#include "adapt/schedule.h"
#include "reference/feature_line.h"
#include "reference/statistics.h"
#include "refill/propose.h"

namespace alphamst::adapt {
namespace {

// Singular vertices that there may be on the way, for each at first, where a first try left more.
constexpr double some_room = 1.5, no_room = 1;

void describe(const mesh::QuadMesh &mesh, const reference::Reference &reference,
              std::map<int, std::int64_t> &valences, std::int64_t &singular, double &quality) {
    valences.clear();
    singular = 0;
    reference::count(mesh, valences, singular);
    const std::vector<double> each = reference.scaled_jacobians(mesh);
    quality = *std::min_element(each.begin(), each.end());
}

bool rose(const Outcome &outcome) { return outcome.singular_after > outcome.singular_before; }

Outcome rework(mesh::QuadMesh &mesh, double alpha, bool exact, const Settings &settings,
               const Progress &progress) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = mesh.n_faces();
    outcome.faces_wanted = refill::wanted_faces(alpha, static_cast<std::size_t>(mesh.n_faces()));
    if (mesh.n_faces() == 0)
        return outcome;
    reference::straighten(mesh);
    describe(mesh, reference::reference_of(mesh), outcome.valences_before, outcome.singular_before,
             outcome.quality_before);
    // Stages come more than once; what was told does not fall.
    const Progress tell = [&progress, told = 0.0](double fraction, const char *stage) mutable {
        told = std::max(told, fraction);
        progress(told, stage);
    };
    std::optional<reference::CrossField> cross_field;
    if (settings.align && mesh.surface)
        cross_field.emplace(mesh);
    chord_prepass(mesh, outcome.faces_wanted, settings, tell);

    const auto attempt = [&](mesh::QuadMesh &tried, std::optional<double> room) {
        reference::Reference reference = reference::reference_of(tried);
        if (reference.surface)
            reference.surface_distance = reference::surface_distance_of(
                tried, *reference.surface, outcome.faces_wanted, settings.tolerance);
        run_schedule(tried, reference, {outcome.faces_wanted, exact, room}, cross_field, settings, tell);
        Outcome result = outcome;
        result.faces_after = tried.n_faces();
        describe(tried, reference, result.valences_after, result.singular_after, result.quality_after);
        return result;
    };
    const auto missing = [&](const Outcome &of) {
        return exact ? std::abs(of.faces_after - of.faces_wanted) : 0;
    };
    // Sizes that are asked for need singular vertices, and in a plane the boundary does.
    std::optional<mesh::QuadMesh> begun;
    if (mesh.surface && mesh.dim() == 3 && mesh.field(Entity::vertex, "size") == nullptr)
        begun = mesh;
    outcome = attempt(mesh, std::nullopt);
    std::string limit;
    for (const double room : {some_room, no_room}) {
        if (!begun || !rose(outcome) || (room == no_room && missing(outcome) == 0))
            break;
        mesh::QuadMesh tried = *begun;
        const Outcome result = attempt(tried, room);
        // The number of faces comes first; where it cannot be had, no singular vertices are made for it.
        const auto rank = [&](const Outcome &of) {
            return std::tuple(missing(of) != 0, rose(of), missing(of), of.singular_after);
        };
        if (rank(result) < rank(outcome)) {
            outcome = result;
            mesh = std::move(tried);
            limit = " that would not leave more singular vertices than there were";
            if (mesh.curves && !settings.edit_boundary)
                limit += ", features having all their vertices but where they are straight";
        }
    }
    if (missing(outcome) != 0)
        outcome.text = "the mesh has " + std::to_string(outcome.faces_after) + " faces where " +
                       std::to_string(outcome.faces_wanted) +
                       " were wanted; no valid filling with more or fewer was found" + limit;
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace

Outcome adapt_whole(mesh::QuadMesh &mesh, double alpha, const Settings &settings, const Progress &progress) {
    return rework(mesh, alpha, true, settings, progress);
}

Outcome reduce_whole(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress) {
    return rework(mesh, 1, false, settings, progress);
}

} // namespace alphamst::adapt
