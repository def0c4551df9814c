#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <numeric>
#include <unordered_map>

#include "adapt/ground.h"
#include "adapt/locate.h"
#include "geometry/embed.h"
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
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted =
        static_cast<std::int64_t>(faces.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const int v = vertices[i];
        const int valence = mesh.valence(v);
        fixed.push_back(inside[i] != valence || patch::pinned(mesh, v));
        if (mesh.on_boundary(v))
            continue;
        ++outcome.valences_before[valence];
        outcome.singular_before += valence != 4;
    }
    outcome.valences_after = outcome.valences_before;
    outcome.singular_after = outcome.singular_bound = outcome.singular_before;

    if (faces.empty())
        return outcome;
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    const Region patch{faces, {}, 0};
    const Ground ground = ground_of(mesh, std::span(&patch, 1));
    mesh.surface = ground.surface;
    if (const auto plane = plane_of(mesh, faces)) {
        geometry::Points positions;
        for (const int v : vertices)
            positions.push_back(plane->to_plane(point_of(mesh, v)));
        outcome.quality_before = geometry::shapes_of(quads, positions).min_scaled_jacobian;
        const geometry::Embedding improved = geometry::improve(quads, fixed, std::move(positions), options);
        outcome.quality_after = improved.min_scaled_jacobian;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Eigen::Vector3d p = plane->to_space(improved.positions[i]);
            if (!fixed[i])
                mesh.set_point(vertices[i], {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
        }
    } else {
        const geometry::Drape start = drape_of(mesh, *ground.surface, ground.anchors, vertices);
        geometry::Drape drape = start;
        outcome.quality_before = geometry::judge(quads, start).min_scaled_jacobian;
        outcome.quality_after =
            geometry::improve(*ground.surface, quads, fixed, drape, options).min_scaled_jacobian;
        if (outcome.quality_after < outcome.quality_before) {
            drape = start;
            outcome.quality_after = outcome.quality_before;
        }
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if (!fixed[i])
                mesh.set_point(vertices[i], {drape.points[i].x(), drape.points[i].y(), drape.points[i].z()});
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
