#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <numeric>
#include <unordered_map>

#include "adapt/adapt.h"
#include "geometry/embed.h"
#include "geometry/plane.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

Outcome smooth_faces(mesh::QuadMesh &mesh, const std::vector<int> &faces, const Settings &settings) {
    const auto start = std::chrono::steady_clock::now();
    std::unordered_map<int, int> local;
    std::vector<int> vertices;
    std::vector<std::array<int, 4>> quads;
    for (const int f : faces) {
        std::array<int, 4> quad = mesh.corners(f);
        for (int &v : quad) {
            const auto [it, fresh] = local.emplace(v, static_cast<int>(vertices.size()));
            if (fresh)
                vertices.push_back(v);
            v = it->second;
        }
        quads.push_back(quad);
    }
    std::vector<int> inside(vertices.size(), 0);
    for (const auto &quad : quads)
        for (const int v : quad)
            ++inside[static_cast<std::size_t>(v)];
    std::vector<char> fixed;
    std::vector<Eigen::Vector3d> points;
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted =
        static_cast<std::int64_t>(faces.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const int v = vertices[i];
        const int valence = mesh.valence(v);
        fixed.push_back(inside[i] != valence || patch::pinned(mesh, v));
        const auto &p = mesh.point(v);
        points.emplace_back(p[0], p[1], p[2]);
        if (mesh.on_boundary(v))
            continue;
        ++outcome.valences_before[valence];
        outcome.singular_before += valence != 4;
    }
    outcome.valences_after = outcome.valences_before;
    outcome.singular_after = outcome.singular_bound = outcome.singular_before;

    geometry::Plane plane;
    geometry::Points positions;
    if (!points.empty()) {
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (const auto &quad : quads)
            normal += (points[static_cast<std::size_t>(quad[2])] - points[static_cast<std::size_t>(quad[0])])
                          .cross(points[static_cast<std::size_t>(quad[3])] -
                                 points[static_cast<std::size_t>(quad[1])]);
        plane = mesh.dim() == 2 ? geometry::Plane::of_coordinates(normal.z() < 0)
                                : geometry::Plane::fit(points, normal);
        if (!plane.holds(points)) {
            outcome.fault = Fault::unsupported;
            outcome.text = "the faces are curved; this version smooths faces that lie in a plane";
            return outcome;
        }
    }
    for (const auto &p : points)
        positions.push_back(plane.to_plane(p));
    outcome.quality_before = geometry::judge(quads, positions).min_scaled_jacobian;
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    const geometry::Embedding improved = geometry::improve(quads, fixed, std::move(positions), options);
    outcome.quality_after = improved.min_scaled_jacobian;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (fixed[i])
            continue;
        const Eigen::Vector3d p = plane.to_space(improved.positions[i]);
        mesh.set_point(vertices[i], {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace

std::vector<Outcome> smooth(mesh::QuadMesh &mesh, const std::vector<Region> *patches,
                            const Settings &settings, const Progress &progress) {
    std::vector<Outcome> outcomes;
    if (patches == nullptr) {
        progress(0, "smooth");
        std::vector<int> faces(static_cast<std::size_t>(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        outcomes.push_back(smooth_faces(mesh, faces, settings));
    } else {
        for (const Region &patch : *patches) {
            progress(static_cast<double>(outcomes.size()) / static_cast<double>(patches->size()), "smooth");
            outcomes.push_back(smooth_faces(mesh, patch.faces, settings));
        }
    }
    progress(1, "smooth");
    return outcomes;
}

} // namespace alphamst::adapt
