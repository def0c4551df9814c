#include "adapt/relax.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "adapt/tally.h"
#include "adapt/workers.h"
#include "geometry/embed.h"
#include "geometry/star.h"
#include "patch/grow.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

// A scaled Jacobian that relaxing a surface as a whole may fall to.
constexpr double least_relaxed = 0.3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double area_of(const mesh::QuadMesh &mesh, const std::array<int, 4> &q) {
    return (point_of(mesh, q[2]) - point_of(mesh, q[0]))
               .cross(point_of(mesh, q[3]) - point_of(mesh, q[1]))
               .norm() /
           2;
}

// Of each face: the mean over the faces around it, some layers deep.
std::vector<double> local_areas(const mesh::QuadMesh &mesh) {
    constexpr int layers = 4;
    std::vector<double> area;
    for (const auto &q : mesh.faces())
        area.push_back(area_of(mesh, q));
    std::vector<double> sum(at(mesh.n_vertices())), count(sum.size(), 0);
    for (const auto &q : mesh.faces())
        for (const int v : q)
            ++count[at(v)];
    for (int layer = 0; layer < layers; ++layer) {
        std::fill(sum.begin(), sum.end(), 0);
        for (std::size_t f = 0; f < area.size(); ++f)
            for (const int v : mesh.faces()[f])
                sum[at(v)] += area[f];
        for (std::size_t f = 0; f < area.size(); ++f) {
            area[f] = 0;
            for (const int v : mesh.faces()[f])
                area[f] += sum[at(v)] / count[at(v)] / 4;
        }
    }
    return area;
}

// By the density, so scaled that they sum up to the area of the mesh.
std::vector<double> wanted_areas(const mesh::QuadMesh &mesh, const Density &density) {
    std::vector<double> wanted;
    double sum = 0, area = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        wanted.push_back(1 / density.of_face(mesh, f));
        sum += wanted.back();
        area += area_of(mesh, mesh.corners(f));
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

void relax_flat(mesh::QuadMesh &mesh, const geometry::Plane &plane, std::span<const char> fixed,
                const geometry::EmbedOptions &options) {
    const auto result = geometry::improve(mesh.faces(), fixed, flatten(mesh, plane), options);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (fixed[at(v)])
            continue;
        const Eigen::Vector3d p = plane.to_space(result.positions[at(v)]);
        mesh.set_point(v, {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
    }
}

// Takes vertices back to where they started from around samples of the surface that would be too far from
// the mesh; false if some still are.
bool keep_covered(const mesh::QuadMesh &mesh, const Coverage &coverage, const geometry::Drape &start,
                  geometry::Drape &drape, std::vector<Coverage::Owner> &owners) {
    constexpr int most_rounds = 5;
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Quad> quads(all.size());
        for (std::size_t f = 0; f < quads.size(); ++f)
            for (std::size_t k = 0; k < 4; ++k)
                quads[f][k] = drape.points[at(mesh.faces()[f][k])];
        std::vector<int> missed;
        owners = *coverage.cover(all, quads, &missed);
        if (missed.empty())
            return true;
        patch::Growth growth(mesh);
        for (const int f : growth.surround(missed, 2 + round))
            for (const int v : mesh.corners(f))
                drape.put(v, {start.anchors[at(v)], start.points[at(v)], start.normals[at(v)], 0});
    }
    return false;
}

void relax_draped(mesh::QuadMesh &mesh, Ground &ground, std::span<const char> fixed,
                  const geometry::EmbedOptions &options) {
    std::vector<int> all(at(mesh.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    const geometry::Drape start = drape_of(mesh, *ground.surface, ground.anchors, all);
    geometry::Drape drape = start;
    const geometry::Judgement before = geometry::judge(mesh.faces(), start);
    geometry::improve(*ground.surface, mesh.faces(), fixed, drape, options);
    std::vector<Coverage::Owner> owners;
    if (ground.coverage && !keep_covered(mesh, *ground.coverage, start, drape, owners))
        return;
    if (geometry::judge(mesh.faces(), drape).min_scaled_jacobian <
        std::min(before.min_scaled_jacobian, least_relaxed))
        return;
    if (ground.coverage) {
        std::vector<int> faces(at(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        ground.coverage->assign(faces, owners, faces);
    }
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (fixed[at(v)])
            continue;
        const Eigen::Vector3d &p = drape.points[at(v)];
        mesh.set_point(v, {p.x(), p.y(), p.z()});
        ground.anchors[at(v)] = drape.anchors[at(v)];
    }
}

} // namespace

void relax(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
           const Settings &settings) {
    std::vector<char> fixed;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        fixed.push_back(mesh.isolated(v) || patch::pinned(mesh, v));
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh);
    geometry::EmbedOptions options;
    options.steps = settings.smooth_steps;
    options.patient = settings.patient;
    options.least_area = settings.least_area;
    options.area = area;
    const Workers workers(settings.threads);
    options.run = [&](std::size_t n, const std::function<void(std::size_t)> &work) {
        workers.run(n, [&](std::size_t i, std::size_t) { work(i); });
    };
    if (ground.plane)
        relax_flat(mesh, *ground.plane, fixed, options);
    else
        relax_draped(mesh, ground, fixed, options);
}

} // namespace alphamst::adapt
