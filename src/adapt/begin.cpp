#include "adapt/begin.h"

#include <algorithm>
#include <cmath>

#include "adapt/chord.h"
#include "adapt/ground.h"
#include "adapt/tally.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

constexpr int seldom = 25;   // faces for each singular vertex of a nearly regular mesh, or more
constexpr double near = 0.1; // of the wanted faces: that may be missing

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

} // namespace

void begin_with_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings) {
    std::map<int, std::int64_t> valences;
    std::int64_t singular = 0;
    count(mesh, valences, singular);
    const auto faces = static_cast<double>(mesh.n_faces()), aim = static_cast<double>(wanted);
    if (!mesh.surface || mesh.dim() == 2 || static_cast<double>(singular * seldom) > faces ||
        aim < (1 + near) * faces || mesh.field(Entity::vertex, "size") != nullptr)
        return;
    mesh::QuadMesh other = mesh;
    approach_by_chords(other, wanted, {}, [](double, const char *) {});
    land(other);
    if (coverage_of(other, *mesh.surface, wanted, settings.tolerance).complete() &&
        count_inverted(other) <= count_inverted(mesh))
        mesh = std::move(other);
}

} // namespace alphamst::adapt
