#include "adapt/relax.h"

#include <algorithm>
#include <numeric>

#include "adapt/locate.h"
#include "adapt/rails.h"
#include "adapt/shaping.h"
#include "adapt/tally.h"
#include "adapt/workers.h"
#include "geometry/embed.h"
#include "geometry/fit.h"
#include "geometry/star.h"
#include "patch/grow.h"
#include "patch/region.h"

namespace alphamst::adapt {
namespace {

// A scaled Jacobian that relaxing a surface as a whole may fall to.
constexpr double least_relaxed = 0.3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double area_of(const mesh::QuadMesh &mesh, int face) { return area_vector(quad_of(mesh, face)).norm(); }

// Of each face: the mean over the faces around it, some layers deep.
std::vector<double> local_areas(const mesh::QuadMesh &mesh) {
    constexpr int layers = 4;
    std::vector<double> area;
    for (int f = 0; f < mesh.n_faces(); ++f)
        area.push_back(area_of(mesh, f));
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
        area += area_of(mesh, f);
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

// Of a whole mesh, with these wanted areas.
geometry::EmbedOptions whole_shaping(const Settings &settings, const Workers &workers,
                                     std::span<const double> area) {
    geometry::EmbedOptions options = shaping(settings);
    options.area = area;
    options.run = [&workers](std::size_t n, const std::function<void(std::size_t)> &work) {
        workers.run(n, [&](std::size_t i, std::size_t) { work(i); });
    };
    return options;
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

// Quads that are worse than they were, and than a relaxed one may be.
std::vector<int> spoiled(const mesh::QuadMesh &mesh, const std::vector<double> &before,
                         const geometry::Drape &drape) {
    const std::vector<double> now = geometry::scaled_jacobians(mesh.faces(), drape);
    std::vector<int> faces;
    for (std::size_t f = 0; f < now.size(); ++f)
        if (now[f] < std::min(before[f], least_relaxed))
            faces.push_back(static_cast<int>(f));
    return faces;
}

// The faces of vertices that have come past a neighbour on their rail, as when only that one was taken back.
void add_passed(const mesh::QuadMesh &mesh, const geometry::Drape &drape,
                std::span<const geometry::Rail> rails, std::vector<int> &faces) {
    for (std::size_t v = 0; v < rails.size(); ++v)
        if (rails[v] && !rails[v].holds(drape.points[v], drape.points))
            for (const int f : mesh.faces_around(static_cast<int>(v)))
                faces.push_back(f);
}

// Takes vertices back to where they started from around quads that are spoiled and around samples of the
// surface that would be too far from the mesh; false if some still are.
bool keep_good(const mesh::QuadMesh &mesh, const std::optional<Coverage> &coverage,
               const geometry::Drape &start, geometry::Drape &drape, std::vector<Coverage::Owner> &owners,
               const geometry::Run &run, std::span<const geometry::Rail> rails) {
    constexpr int most_rounds = 8;
    const std::vector<double> before = geometry::scaled_jacobians(mesh.faces(), start);
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<int> bad = spoiled(mesh, before, drape);
        add_passed(mesh, drape, rails, bad);
        if (coverage) {
            std::vector<Quad> quads(all.size());
            for (std::size_t f = 0; f < quads.size(); ++f)
                for (std::size_t k = 0; k < 4; ++k)
                    quads[f][k] = drape.points[at(mesh.faces()[f][k])];
            owners = *coverage->cover(all, quads, &bad, run);
        }
        if (bad.empty())
            return true;
        std::sort(bad.begin(), bad.end());
        bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
        patch::Growth growth(mesh);
        for (const int f : growth.surround(bad, 1 + round * (round + 1) / 2))
            for (const int v : mesh.corners(f))
                drape.put(v, {start.anchors[at(v)], start.points[at(v)], start.normals[at(v)], 0});
    }
    return false;
}

void relax_draped(mesh::QuadMesh &mesh, Ground &ground, std::vector<char> fixed,
                  geometry::EmbedOptions options) {
    const std::vector<geometry::Rail> rails = rails_of(mesh);
    for (std::size_t v = 0; v < rails.size(); ++v)
        if (rails[v])
            fixed[v] = 0;
    options.rails = rails;
    geometry::Drape start = ground.drape(mesh);
    std::vector<int> all(at(mesh.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    forget_normals(mesh, all, mesh.faces(), start);
    geometry::Drape drape = start;
    geometry::improve(*ground.surface, mesh.faces(), fixed, drape, options);
    settle(mesh, ground, start, drape, options.run, rails);
}

} // namespace

std::vector<char> immovable(const mesh::QuadMesh &mesh) {
    std::vector<char> fixed;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        fixed.push_back(mesh.isolated(v) || patch::pinned(mesh, v));
    return fixed;
}

bool settle(mesh::QuadMesh &mesh, Ground &ground, const geometry::Drape &start, geometry::Drape &drape,
            const geometry::Run &run, std::span<const geometry::Rail> rails) {
    std::vector<Coverage::Owner> owners;
    if (!keep_good(mesh, ground.coverage, start, drape, owners, run, rails))
        return false;
    if (ground.coverage) {
        std::vector<int> faces(at(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        ground.coverage->assign(faces, owners, faces);
    }
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (drape.points[at(v)] == start.points[at(v)])
            continue;
        const Eigen::Vector3d &p = drape.points[at(v)];
        mesh.set_point(v, {p.x(), p.y(), p.z()});
        ground.anchors[at(v)] = drape.anchors[at(v)];
    }
    return true;
}

void relax(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
           const Settings &settings) {
    std::vector<char> fixed = immovable(mesh);
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh);
    const Workers workers(settings.threads);
    const geometry::EmbedOptions options = whole_shaping(settings, workers, area);
    if (ground.plane)
        relax_flat(mesh, *ground.plane, fixed, options);
    else
        relax_draped(mesh, ground, std::move(fixed), options);
}

void fit(mesh::QuadMesh &mesh, Ground &ground, const std::optional<Density> &density,
         const Settings &settings) {
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh);
    const Workers workers(settings.threads);
    const geometry::EmbedOptions options = whole_shaping(settings, workers, area);
    const geometry::Drape start = ground.drape(mesh);
    geometry::Drape drape = start;
    std::vector<geometry::Sample> samples;
    for (int f = 0; ground.coverage && f < mesh.n_faces(); ++f)
        for (const int s : ground.coverage->samples(f))
            samples.push_back({ground.coverage->point(s), f});
    geometry::fit(*ground.surface, mesh.faces(), immovable(mesh), drape, options, samples);
    // The surface as a whole comes nearer; a part of it may get as far as the farthest was.
    const double tolerance = ground.coverage ? ground.coverage->tolerance() : 0;
    if (ground.coverage)
        ground.coverage->set_tolerance(std::max(tolerance, ground.coverage->largest()));
    settle(mesh, ground, start, drape, options.run);
    if (ground.coverage)
        ground.coverage->set_tolerance(tolerance);
}

} // namespace alphamst::adapt
