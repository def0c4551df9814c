#include "adapt/begin.h"

#include <algorithm>
#include <cmath>

#include "adapt/chord.h"
#include "adapt/ground.h"
#include "adapt/rails.h"
#include "adapt/relax.h"
#include "adapt/tally.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

constexpr int seldom = 25;   // faces for each singular vertex of a nearly regular mesh, or more
constexpr double near = 0.1; // of the wanted faces: that may be missing
// Of the faces go before all is relaxed; where that does not come right half of that is tried, and so on.
constexpr double step = 0.15, least_step = 0.01;

void silent(double /*fraction*/, const char * /*stage*/) {}

// Vertices that came to lie off the surface go back to it.
void land(mesh::QuadMesh &mesh) {
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && !patch::pinned(mesh, v)) {
            const Eigen::Vector3d p = spot_of(mesh, *mesh.surface, v).point;
            mesh.set_point(v, {p.x(), p.y(), p.z()});
        }
}

std::int64_t count_inverted(mesh::QuadMesh &mesh) {
    const std::vector<double> quality = ground_of(mesh).scaled_jacobians(mesh);
    return std::count_if(quality.begin(), quality.end(), [](double q) { return !(q > 0); });
}

// Vertices that may slide along a feature may go from it, too: it stays where it is either way.
bool spared(const mesh::QuadMesh &mesh, int vertex) { return static_cast<bool>(rail_of(mesh, vertex)); }

bool uncovers_or_inverts(mesh::QuadMesh &other, const Coverage &coverage, mesh::QuadMesh &before) {
    return !coverage.complete() || count_inverted(other) > count_inverted(before);
}

// In steps, as chords say nothing of shapes; the last of them that comes right is the answer.
void coarsen_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules,
                       const Settings &settings, const Progress &progress) {
    for (double part = step; part > least_step;) {
        mesh::QuadMesh other = mesh;
        const auto next = static_cast<std::int64_t>((1 - part) * other.n_faces());
        progress(0, "chords");
        approach_by_chords(other, std::max(wanted, next), rules, Order::narrowest, silent);
        if (other.n_faces() == mesh.n_faces())
            return;
        land(other);
        Ground ground = ground_of(other);
        ground.coverage = coverage_of(other, *other.surface, wanted, settings.tolerance);
        if (uncovers_or_inverts(other, *ground.coverage, mesh)) {
            part /= 2;
            continue;
        }
        relax(other, ground, std::nullopt, settings);
        mesh = std::move(other);
    }
}

void refine_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules,
                      const Settings &settings, const Progress &progress) {
    mesh::QuadMesh other = mesh;
    progress(0, "chords");
    approach_by_chords(other, wanted, rules, Order::shortest, silent);
    land(other);
    if (!uncovers_or_inverts(other, coverage_of(other, *mesh.surface, wanted, settings.tolerance), mesh))
        mesh = std::move(other);
}

} // namespace

void begin_with_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings,
                       const Progress &progress) {
    std::map<int, std::int64_t> valences;
    std::int64_t singular = 0;
    count(mesh, valences, singular);
    const auto faces = static_cast<double>(mesh.n_faces()), aim = static_cast<double>(wanted);
    if (!mesh.surface || mesh.dim() == 2 || static_cast<double>(singular * seldom) > faces ||
        mesh.field(Entity::vertex, "size") != nullptr)
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
