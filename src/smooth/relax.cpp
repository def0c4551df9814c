#include "smooth/relax.h"

#include <algorithm>
#include <numeric>

#include "geometry/embed.h"
#include "geometry/fit.h"
#include "geometry/match_areas.h"
#include "geometry/star.h"
#include "index.h"
#include "parallel/workers.h"
#include "patch/region.h"
#include "reference/feature_line.h"
#include "reference/locate.h"
#include "reference/statistics.h"
#include "smooth/roll_back.h"
#include "smooth/shaping.h"

namespace alphamst::smooth {
namespace {

// A scaled Jacobian that relaxing a surface as a whole may fall to.
constexpr double least_relaxed = 0.3;

// In the plane: of sizes against shapes. Errors of sizes fall from .55 (rms of log2) at 1/128 to .43 at .2,
// .36 at .4 and .34 at .6, where a fifth of the faces gets too long.
constexpr double size_weight = 0.4;
// At last, where the caller wishes sizes: errors fall from .43 to .31, and long faces are worth it.
constexpr double wished_size_weight = 0.7;
// Of a corner, over the wanted area of its face, that the smallest angles may cost: with .3 time steps halve.
constexpr double least_area = 0.5;

// Of quads that had as much: below, vertices go back.
constexpr double least_settled = 0.5;
constexpr int settling_rounds = 8; // three were the most that were seen to be needed

std::vector<double> scaled_jacobians(geometry::Quads quads, const geometry::Points &positions) {
    std::vector<double> least;
    for (std::size_t q = 0; q < quads.size(); ++q)
        least.push_back(geometry::shapes_of(quads.subspan(q, 1), positions).min_scaled_jacobian);
    return least;
}

double area_of(const mesh::QuadMesh &mesh, int face) {
    return geometry::area_vector(reference::quad_of(mesh, face)).norm();
}

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
std::vector<double> wanted_areas(const mesh::QuadMesh &mesh, const reference::SizingField &density) {
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
geometry::EmbedOptions whole_shaping(const Settings &settings, const parallel::Workers &workers,
                                     std::span<const double> area) {
    geometry::EmbedOptions options = shaping(settings);
    options.area = area;
    options.run = [&workers](std::size_t n, const std::function<void(std::size_t)> &work) {
        workers.run(n, [&](std::size_t i, std::size_t) { work(i); });
    };
    return options;
}

void put(mesh::QuadMesh &mesh, const geometry::Plane &plane, std::span<const char> fixed,
         const geometry::Points &positions) {
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (fixed[at(v)])
            continue;
        const Eigen::Vector3d p = plane.to_space(positions[at(v)]);
        mesh.set_point(v, {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
    }
}

void relax_flat(mesh::QuadMesh &mesh, const geometry::Plane &plane, std::span<const char> fixed,
                geometry::EmbedOptions options) {
    options.size_weight = size_weight;
    options.least_area = least_area;
    put(mesh, plane, fixed,
        geometry::improve(mesh.faces(), fixed, reference::flatten(mesh, plane), options).positions);
}

// Newton's method on all vertices at once: areas travel farther than where vertices move one by one. Where
// corners close, vertices stay.
void settle_flat(mesh::QuadMesh &mesh, const geometry::Plane &plane, const reference::SizingField &density,
                 const Settings &settings) {
    const auto wanted = [&](const geometry::Points &positions) {
        std::vector<double> areas;
        for (const auto &quad : mesh.faces()) {
            geometry::Quad corners;
            for (std::size_t k = 0; k < 4; ++k)
                corners[k] = plane.to_space(positions[at(quad[k])]);
            areas.push_back(geometry::area_vector(corners).norm() / density.weight(corners));
        }
        return areas;
    };
    geometry::EmbedOptions options = shaping(settings);
    options.least_area = least_area;
    const geometry::Points start = reference::flatten(mesh, plane);
    if (!geometry::judge(mesh.faces(), start).valid)
        return;
    const std::vector<double> before = scaled_jacobians(mesh.faces(), start);
    std::vector<char> fixed = constrained_vertices(mesh);
    for (int round = 0; round < settling_rounds; ++round) {
        const geometry::Points positions =
            geometry::match_areas(mesh.faces(), fixed, start, wanted,
                                  density.wished() ? wished_size_weight : size_weight, options)
                .positions;
        const std::vector<double> now = scaled_jacobians(mesh.faces(), positions);
        bool spoiled = false;
        for (std::size_t f = 0; f < now.size(); ++f)
            if (now[f] < std::min(before[f], least_settled)) {
                spoiled = true;
                for (const int v : mesh.faces()[f])
                    fixed[at(v)] = 1;
            }
        if (!spoiled) {
            put(mesh, plane, fixed, positions);
            return;
        }
    }
}

// Quads that are worse than they were, and than a relaxed one may be.
std::vector<int> spoiled(const mesh::QuadMesh &mesh, const std::vector<double> &before,
                         const geometry::SurfacePositions &on_surface) {
    const std::vector<double> now = geometry::scaled_jacobians(mesh.faces(), on_surface);
    std::vector<int> faces;
    for (std::size_t f = 0; f < now.size(); ++f)
        if (now[f] < std::min(before[f], least_relaxed))
            faces.push_back(static_cast<int>(f));
    return faces;
}

// Takes vertices back to where they started from around quads that are spoiled and around samples of the
// surface that would be too far from the mesh; false if some still are.
bool keep_good(const mesh::QuadMesh &mesh, const std::optional<reference::SurfaceDistance> &surface_distance,
               const geometry::SurfacePositions &start, geometry::SurfacePositions &on_surface,
               std::vector<reference::SurfaceDistance::Owner> &owners, const geometry::Run &run,
               std::span<const geometry::FeatureLine> feature_lines) {
    const std::vector<double> before = geometry::scaled_jacobians(mesh.faces(), start);
    std::vector<int> all(at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    return roll_back(mesh.faces(), start, on_surface, feature_lines, [&] {
        std::vector<int> bad = spoiled(mesh, before, on_surface);
        if (surface_distance) {
            std::vector<geometry::Quad> quads(all.size());
            for (std::size_t f = 0; f < quads.size(); ++f)
                for (std::size_t k = 0; k < 4; ++k)
                    quads[f][k] = on_surface.points[at(mesh.faces()[f][k])];
            owners = *surface_distance->cover(all, quads, &bad, run);
        }
        return bad;
    });
}

void relax_on_surface(mesh::QuadMesh &mesh, reference::Reference &reference, std::vector<char> fixed,
                      geometry::EmbedOptions options) {
    const std::vector<geometry::FeatureLine> feature_lines = reference::feature_lines_of(mesh);
    for (std::size_t v = 0; v < feature_lines.size(); ++v)
        if (feature_lines[v])
            fixed[v] = 0;
    options.feature_lines = feature_lines;
    geometry::SurfacePositions start = reference.on_surface(mesh);
    std::vector<int> all(at(mesh.n_vertices()));
    std::iota(all.begin(), all.end(), 0);
    reference::forget_normals(mesh, all, mesh.faces(), start);
    geometry::SurfacePositions on_surface = start;
    geometry::improve(*reference.surface, mesh.faces(), fixed, on_surface, options);
    accept_or_roll_back(mesh, reference, start, on_surface, options.run, feature_lines);
}

} // namespace

std::vector<char> constrained_vertices(const mesh::QuadMesh &mesh) {
    std::vector<char> fixed;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        fixed.push_back(mesh.isolated(v) || patch::constrained(mesh, v));
    return fixed;
}

bool accept_or_roll_back(mesh::QuadMesh &mesh, reference::Reference &reference,
                         const geometry::SurfacePositions &start, geometry::SurfacePositions &on_surface,
                         const geometry::Run &run, std::span<const geometry::FeatureLine> feature_lines) {
    std::vector<reference::SurfaceDistance::Owner> owners;
    if (!keep_good(mesh, reference.surface_distance, start, on_surface, owners, run, feature_lines))
        return false;
    if (reference.surface_distance) {
        std::vector<int> faces(at(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        reference.surface_distance->assign(faces, owners, faces);
    }
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (on_surface.points[at(v)] == start.points[at(v)])
            continue;
        const Eigen::Vector3d &p = on_surface.points[at(v)];
        mesh.set_point(v, {p.x(), p.y(), p.z()});
        reference.surface_triangles[at(v)] = on_surface.surface_triangles[at(v)];
    }
    return true;
}

void relax_by_sizes(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const std::optional<reference::SizingField> &density, const Settings &settings) {
    std::vector<char> fixed = constrained_vertices(mesh);
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh);
    const parallel::Workers workers(settings.threads);
    const geometry::EmbedOptions options = whole_shaping(settings, workers, area);
    if (reference.plane)
        relax_flat(mesh, *reference.plane, fixed, options);
    else
        relax_on_surface(mesh, reference, std::move(fixed), options);
}

void settle_by_sizes(mesh::QuadMesh &mesh, reference::Reference &reference,
                     const std::optional<reference::SizingField> &density, const Settings &settings) {
    relax_by_sizes(mesh, reference, density, settings);
    if (reference.plane && density)
        settle_flat(mesh, *reference.plane, *density, settings);
}

void fit_to_surface(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const std::optional<reference::SizingField> &density, const Settings &settings) {
    const std::vector<double> area = density ? wanted_areas(mesh, *density) : local_areas(mesh);
    const parallel::Workers workers(settings.threads);
    const geometry::EmbedOptions options = whole_shaping(settings, workers, area);
    const geometry::SurfacePositions start = reference.on_surface(mesh);
    geometry::SurfacePositions on_surface = start;
    std::vector<geometry::Sample> samples;
    for (int f = 0; reference.surface_distance && f < mesh.n_faces(); ++f)
        for (const int s : reference.surface_distance->samples(f))
            samples.push_back({reference.surface_distance->point(s), f});
    geometry::fit(*reference.surface, mesh.faces(), constrained_vertices(mesh), on_surface, options, samples);
    // The surface as a whole comes nearer; a part of it may get as far as the farthest was.
    const double tolerance = reference.surface_distance ? reference.surface_distance->tolerance() : 0;
    if (reference.surface_distance)
        reference.surface_distance->set_tolerance(std::max(tolerance, reference.surface_distance->largest()));
    accept_or_roll_back(mesh, reference, start, on_surface, options.run);
    if (reference.surface_distance)
        reference.surface_distance->set_tolerance(tolerance);
}

} // namespace alphamst::smooth
