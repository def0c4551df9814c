#include "adapt/chord_prepass.h"

#include <algorithm>
#include <cmath>

#include "chords/edit.h"
#include "patch/region.h"
#include "reference/feature_line.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "smooth/relax.h"

namespace alphamst::adapt {
namespace {

constexpr int seldom = 25;   // faces for each singular vertex of a nearly regular mesh, or more
constexpr double near = 0.1; // of the wanted faces: that may be missing
// Of the faces go before all is relaxed; where that does not come right half of that is tried, and so on.
constexpr double step = 0.15, least_step = 0.01;

void silent(double /*fraction*/, const char * /*stage*/) {}

// Vertices that came to lie off the surface or their curve go back to it.
void land(mesh::QuadMesh &mesh) {
    reference::keep_to_curves(mesh);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && !patch::constrained(mesh, v)) {
            const Eigen::Vector3d p = reference::spot_of(mesh, *mesh.surface, v).point;
            mesh.set_point(v, {p.x(), p.y(), p.z()});
        }
}

std::int64_t count_inverted(mesh::QuadMesh &mesh) {
    const std::vector<double> quality = reference::reference_of(mesh).scaled_jacobians(mesh);
    return std::count_if(quality.begin(), quality.end(), [](double q) { return !(q > 0); });
}

// Vertices that may slide along a feature may go from it, too: it stays where it is either way.
bool spared(const mesh::QuadMesh &mesh, int vertex) {
    return static_cast<bool>(reference::feature_line_of(mesh, vertex));
}

bool uncovers_or_inverts(mesh::QuadMesh &other, const reference::SurfaceDistance &surface_distance,
                         mesh::QuadMesh &before) {
    return !surface_distance.complete() || count_inverted(other) > count_inverted(before);
}

// In steps, as chords say nothing of shapes; the last of them that comes right is the answer.
void coarsen_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules,
                       const Settings &settings, const Progress &progress) {
    for (double part = step; part > least_step;) {
        mesh::QuadMesh other = mesh;
        const auto next = static_cast<std::int64_t>((1 - part) * other.n_faces());
        progress(0, "chords");
        chords::approach_by_chords(other, std::max(wanted, next), rules, chords::Order::narrowest, silent);
        if (other.n_faces() == mesh.n_faces())
            return;
        land(other);
        reference::Reference reference = reference::reference_of(other);
        reference.surface_distance =
            reference::surface_distance_of(other, *other.surface, wanted, settings.tolerance);
        if (uncovers_or_inverts(other, *reference.surface_distance, mesh)) {
            part /= 2;
            continue;
        }
        smooth::relax_by_sizes(other, reference, std::nullopt, settings);
        mesh = std::move(other);
    }
}

void refine_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules,
                      const Settings &settings, const Progress &progress) {
    mesh::QuadMesh other = mesh;
    progress(0, "chords");
    chords::approach_by_chords(other, wanted, rules, chords::Order::shortest, silent);
    land(other);
    if (!uncovers_or_inverts(
            other, reference::surface_distance_of(other, *mesh.surface, wanted, settings.tolerance), mesh))
        mesh = std::move(other);
}

} // namespace

void chord_prepass(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings,
                   const Progress &progress) {
    std::map<int, std::int64_t> valences;
    std::int64_t singular = 0;
    reference::count(mesh, valences, singular);
    const auto faces = static_cast<double>(mesh.n_faces()), aim = static_cast<double>(wanted);
    const bool regular = singular * seldom <= mesh.n_faces() || reference::fewest_singular(valences);
    if (!mesh.surface || mesh.dim() == 2 || !regular || mesh.field(Entity::vertex, "size") != nullptr)
        return;
    chord::Rules rules;
    rules.boundary = settings.edit_boundary;
    if (!settings.edit_boundary)
        rules.spared = spared;
    if (aim >= (1 + near) * faces)
        refine_by_chords(mesh, wanted, rules, settings, progress);
    else if (aim <= (1 - near) * faces)
        coarsen_by_chords(mesh, wanted, rules, settings, progress);
}

} // namespace alphamst::adapt
