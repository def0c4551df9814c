#include "chords/faces.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "quality/corner.h"
#include "quality/metric.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "reference/surface_of.h"

namespace alphamst::chords {
namespace {

void unique(std::vector<int> &ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

} // namespace

bool upright(const geometry::Quad &quad, const std::optional<geometry::Plane> &plane) {
    if (!plane)
        return quality::measure(quality::Metric::scaled_jacobian, quad, 1) > 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector3d a = quad[(k + 1) % 4] - quad[k], b = quad[(k + 3) % 4] - quad[k];
        if (!(quality::determinant(a, b, plane->normal()) > 0))
            return false;
    }
    return true;
}

std::vector<int> faces_around(const mesh::QuadMesh &mesh, std::vector<int> vertices, int layers) {
    std::vector<int> faces;
    for (int layer = 0; layer <= layers; ++layer) {
        for (const int v : vertices)
            for (const int f : mesh.faces_around(v))
                faces.push_back(f);
        unique(faces);
        vertices.clear();
        for (const int f : faces)
            for (const int v : mesh.corners(f))
                vertices.push_back(v);
        unique(vertices);
    }
    return faces;
}

std::int64_t inverted(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    const auto plane = reference::plane_of(mesh, faces);
    return std::count_if(faces.begin(), faces.end(),
                         [&](int f) { return !upright(reference::quad_of(mesh, f), plane); });
}

OpenMesh::Vec3d place_of(const mesh::QuadMesh &mesh, const chord::Group &group) {
    OpenMesh::Vec3d sum = mesh.point(group.survivor);
    if (group.held)
        return sum;
    for (const int v : group.others)
        sum += mesh.point(v);
    return sum / static_cast<double>(group.others.size() + 1);
}

mesh::QuadMesh::Collapsed remove(mesh::QuadMesh &mesh, const chord::Chord &chord,
                                 const chord::Collapse &verdict, std::vector<int> &survivors) {
    std::vector<std::array<int, 2>> merged;
    std::vector<int> before;
    for (const chord::Group &group : verdict.groups) {
        mesh.set_point(group.survivor, place_of(mesh, group));
        before.push_back(group.survivor);
        for (const int v : group.others)
            merged.push_back({v, group.survivor});
    }
    mesh::QuadMesh::Collapsed collapsed = mesh.collapse_chord(chord.sides, merged);
    std::sort(before.begin(), before.end());
    survivors = before;
    for (const auto &[from, to] : collapsed.moved_vertices) {
        const auto found = std::lower_bound(before.begin(), before.end(), from);
        if (found != before.end() && *found == from)
            survivors[static_cast<std::size_t>(found - before.begin())] = to;
    }
    return collapsed;
}

void keep_surface(mesh::QuadMesh &mesh) {
    if (mesh.dim() != 3)
        return;
    if (mesh.surface)
        mesh.curves = reference::curves_of(mesh);
    else
        reference::reference_of(mesh);
}

Account::Account(const mesh::QuadMesh &mesh) {
    outcome_.faces_before = mesh.n_faces();
    outcome_.quality_before = reference::least_quality(mesh);
    outcome_.aspect_ratio_before = reference::largest_aspect_ratio(mesh);
    reference::count(mesh, outcome_.valences_before, outcome_.singular_before);
}

Outcome Account::close(const mesh::QuadMesh &mesh, std::int64_t wanted) {
    outcome_.faces_wanted = wanted;
    outcome_.faces_after = mesh.n_faces();
    outcome_.quality_after = reference::least_quality(mesh);
    outcome_.aspect_ratio_after = reference::largest_aspect_ratio(mesh);
    reference::count(mesh, outcome_.valences_after, outcome_.singular_after);
    outcome_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return std::move(outcome_);
}

} // namespace alphamst::chords
