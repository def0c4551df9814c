#include "smooth/relax.h"

#include <algorithm>
#include <numeric>

#include "geometry/embed.h"
#include "geometry/fit.h"
#include "geometry/star.h"
#include "index.h"
#include "parallel/workers.h"
#include "patch/region.h"
#include "reference/feature_line.h"
#include "reference/locate.h"
#include "reference/statistics.h"
#include "smooth/areas.h"
#include "smooth/roll_back.h"
#include "smooth/settle.h"
#include "smooth/shaping.h"

namespace alphamst::smooth {
namespace {

// A scaled Jacobian that relaxing a surface as a whole may fall to.
constexpr double least_relaxed = 0.3;

// Of the weight of sizes, in the end where nobody wishes any: with .57 errors of lakes fall to .34 (rms of
// log2) instead of .38, and on a graded coast five of a hundred faces more get too long.
constexpr double settled_part = 3.0 / 7;
// Of scaled Jacobians in the end, of quads that had as much.
constexpr double least_settled = 0.5;

// Of a whole mesh, with these wanted areas.
geometry::EmbedOptions whole_shaping(geometry::EmbedOptions options, const parallel::Workers &workers,
                                     std::span<const double> area) {
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
                const geometry::EmbedOptions &options) {
    put(mesh, plane, fixed,
        geometry::improve(mesh.faces(), fixed, reference::flatten(mesh, plane), options).positions);
}

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
    const std::vector<char> fixed = constrained_vertices(mesh);
    geometry::Points positions = reference::flatten(mesh, plane);
    settle(mesh.faces(), fixed, positions, wanted,
           (density.wished() ? 1 : settled_part) * settings.size_weight, least_settled,
           flat_shaping(settings));
    put(mesh, plane, fixed, positions);
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
                      geometry::EmbedOptions options, double bend_tolerance) {
    const std::vector<geometry::FeatureLine> feature_lines =
        reference::feature_lines_of(mesh, bend_tolerance);
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
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (is_flat(mesh, f))
            for (const int v : mesh.corners(f))
                fixed[at(v)] = 1;
    return fixed;
}

bool is_flat(const mesh::QuadMesh &mesh, int face) {
    const std::array<int, 4> quad = mesh.corners(face);
    for (std::size_t k = 0; k < 4; ++k)
        if (mesh.point(quad[k]) == mesh.point(quad[(k + 1) % 4]))
            return true;
    return false;
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
    const geometry::EmbedOptions options =
        whole_shaping(reference.plane ? flat_shaping(settings) : shaping(settings), workers, area);
    if (reference.plane)
        relax_flat(mesh, *reference.plane, fixed, options);
    else
        relax_on_surface(mesh, reference, std::move(fixed), options, reference::bend_tolerance(settings));
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
    const geometry::EmbedOptions options = whole_shaping(shaping(settings), workers, area);
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
