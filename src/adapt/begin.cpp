#include "adapt/begin.h"

#include <algorithm>
#include <cmath>

#include "adapt/chord.h"
#include "adapt/ground.h"
#include "adapt/tally.h"
#include "mesh/feature.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

constexpr int seldom = 25;   // faces for each singular vertex of a nearly regular mesh, or more
constexpr double near = 0.1; // of the wanted faces: that may be missing
constexpr double sharp = 40; // degrees

// Where the caller named no features, chords keep sharp edges as if he had.
class SharpEdges {
public:
    explicit SharpEdges(mesh::QuadMesh &mesh) : mesh_(mesh) {
        constexpr std::uint8_t named = mesh::feature | mesh::corner;
        const auto is_named = [](std::uint8_t flags) { return (flags & named) != 0; };
        if (std::any_of(mesh.edge_flags.begin(), mesh.edge_flags.end(), is_named) ||
            std::any_of(mesh.vertex_flags.begin(), mesh.vertex_flags.end(), is_named))
            return;
        const mesh::Features found = mesh::find_features(mesh, sharp);
        mark(mesh.edge_flags, mesh.n_edges(), found.edges, mesh::feature);
        mark(mesh.vertex_flags, mesh.n_vertices(), found.corners, mesh::corner);
        marked_ = true;
    }
    ~SharpEdges() {
        if (!marked_)
            return;
        for (std::uint8_t &flags : mesh_.edge_flags)
            flags &= static_cast<std::uint8_t>(~mesh::feature);
        for (std::uint8_t &flags : mesh_.vertex_flags)
            flags &= static_cast<std::uint8_t>(~mesh::corner);
    }
    SharpEdges(const SharpEdges &) = delete;
    SharpEdges &operator=(const SharpEdges &) = delete;

private:
    static void mark(std::vector<std::uint8_t> &flags, int n, const std::vector<int> &ids,
                     std::uint8_t flag) {
        flags.resize(static_cast<std::size_t>(n));
        for (const int id : ids)
            flags[static_cast<std::size_t>(id)] |= flag;
    }

    mesh::QuadMesh &mesh_;
    bool marked_ = false;
};

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

void begin_with_chords(mesh::QuadMesh &mesh, std::int64_t wanted) {
    std::map<int, std::int64_t> valences;
    std::int64_t singular = 0;
    count(mesh, valences, singular);
    const auto faces = static_cast<double>(mesh.n_faces()), aim = static_cast<double>(wanted);
    if (!mesh.surface || mesh.dim() == 2 || static_cast<double>(singular * seldom) > faces ||
        aim < (1 + near) * faces)
        return;
    mesh::QuadMesh other = mesh;
    {
        const SharpEdges kept(other);
        approach_by_chords(other, wanted, {}, [](double, const char *) {});
    }
    land(other);
    if (coverage_of(other, *mesh.surface, wanted).complete() && count_inverted(other) <= count_inverted(mesh))
        mesh = std::move(other);
}

} // namespace alphamst::adapt
