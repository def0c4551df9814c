#include "patch/patches.h"
#include "patch/region.h"

#include <limits>
#include <unordered_set>

namespace alphamst::patch {
namespace {

bool is_free(Taken taken, int face) { return taken.empty() || !taken[static_cast<std::size_t>(face)]; }

} // namespace

std::vector<int> rings(const mesh::QuadMesh &mesh, int vertex, int rings, Taken taken) {
    std::unordered_set<int> seen_faces, seen_vertices = {vertex};
    std::vector<int> faces, front = {vertex};
    for (int ring = 0; ring < rings && !front.empty(); ++ring) {
        const std::size_t before = faces.size();
        for (const int v : front)
            for (const int face : mesh.faces_around(v))
                if (is_free(taken, face) && seen_faces.insert(face).second)
                    faces.push_back(face);
        front.clear();
        for (std::size_t i = before; i < faces.size(); ++i)
            for (const Halfedge h : halfedges_of(mesh, faces[i]))
                if (seen_vertices.insert(from(mesh, h)).second)
                    front.push_back(from(mesh, h));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

std::vector<int> ball(const mesh::QuadMesh &mesh, const std::array<double, 3> &center, double radius,
                      Taken taken) {
    const OpenMesh::Vec3d middle(center[0], center[1], center[2]);
    std::vector<int> within;
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int face = 0; face < mesh.n_faces(); ++face) {
        const double distance = (centroid(mesh, face) - middle).norm();
        if (!is_free(taken, face) || !(distance <= radius))
            continue;
        within.push_back(face);
        if (distance < least) {
            least = distance;
            nearest = face;
        }
    }
    for (auto &part : parts(mesh, within, true))
        if (contains(part, nearest))
            return std::move(part);
    return {};
}

std::vector<int> box(const mesh::QuadMesh &mesh, const std::array<double, 3> &low,
                     const std::array<double, 3> &high, Taken taken) {
    std::vector<int> within;
    for (int face = 0; face < mesh.n_faces(); ++face) {
        if (!is_free(taken, face))
            continue;
        const OpenMesh::Vec3d p = centroid(mesh, face);
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i)
            inside = inside && p[i] >= low[i] && p[i] <= high[i];
        if (inside)
            within.push_back(face);
    }
    return largest_part(mesh, within, true);
}

} // namespace alphamst::patch
