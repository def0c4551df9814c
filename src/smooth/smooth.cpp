#include <algorithm>
#include <chrono>
#include <iterator>
#include <numeric>
#include <unordered_map>

#include "index.h"
#include "patch/region.h"
#include "quality/metric.h"
#include "reference/feature_line.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "reference/surface_of.h"
#include "smooth/areas.h"
#include "smooth/relax.h"
#include "smooth/roll_back.h"
#include "smooth/settle.h"
#include "smooth/shaping.h"

namespace alphamst::smooth {
namespace {

// A scaled Jacobian down to which corners may close for wished sizes.
constexpr double enough = 0.5;

// Some faces and their vertices; the free ones are inside and not constrained, the sliding ones inside and on
// feature lines.
struct Part {
    Part(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
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
        for (std::size_t i = 0; i < vertices.size(); ++i)
            fixed.push_back(inside[i] != mesh.valence(vertices[i])  ? border
                            : patch::constrained(mesh, vertices[i]) ? held
                                                                    : 0);
    }

    // From now on, where the mesh has lines for that.
    void let_slide(const mesh::QuadMesh &mesh, double bend_tolerance) {
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            if (fixed[i] != held)
                continue;
            geometry::FeatureLine feature_line =
                reference::feature_line_of(mesh, vertices[i], bend_tolerance);
            if (!feature_line)
                continue;
            for (int &v : feature_line.between)
                v = local.at(v);
            feature_lines.resize(vertices.size());
            feature_lines[i] = feature_line;
            fixed[i] = 0;
        }
    }

    void put(mesh::QuadMesh &mesh, const std::function<Eigen::Vector3d(std::size_t)> &place) const {
        for (std::size_t i = 0; i < vertices.size(); ++i)
            if (!fixed[i]) {
                const Eigen::Vector3d p = place(i);
                mesh.set_point(vertices[i], {p.x(), p.y(), mesh.dim() == 2 ? 0.0 : p.z()});
            }
    }

    static constexpr char border = 1, held = 2;

    std::unordered_map<int, int> local; // vertex of the mesh -> of the part
    std::vector<int> vertices;          // of the mesh
    std::vector<std::array<int, 4>> quads;
    std::vector<char> fixed;
    std::vector<geometry::FeatureLine> feature_lines; // empty: there are none
};

// The quads that are worse than they were, and inverted or worse than any that was not. Elsewhere a quad may
// be spoiled for others that gain more; and where fewer are inverted than before, all the others may pay for
// it.
std::vector<int> spoiled(std::span<const double> before, std::span<const double> now) {
    const auto inverted = [](double quality) { return !(quality > 0); };
    double floor = 1;
    for (const double quality : before)
        if (!inverted(quality))
            floor = std::min(floor, quality);
    if (std::ranges::count_if(now, inverted) < std::ranges::count_if(before, inverted))
        floor = 0;
    std::vector<int> quads;
    for (std::size_t q = 0; q < now.size(); ++q)
        if (now[q] < before[q] && (inverted(now[q]) || now[q] < floor))
            quads.push_back(static_cast<int>(q));
    return quads;
}

std::vector<double> qualities(geometry::Quads quads, const geometry::Points &positions,
                              const geometry::Plane &plane) {
    std::vector<double> all;
    for (const auto &corners : quads) {
        geometry::Quad quad;
        for (std::size_t k = 0; k < 4; ++k)
            quad[k] = plane.to_space(positions[at(corners[k])]);
        all.push_back(quality::measure(quality::Metric::scaled_jacobian, quad, 1));
    }
    return all;
}

void smooth_flat(mesh::QuadMesh &mesh, const Part &part, const geometry::Plane &plane,
                 std::span<const double> areas, bool wished, const Settings &settings) {
    geometry::Points start;
    for (const int v : part.vertices)
        start.push_back(plane.to_plane(reference::point_of(mesh, v)));
    const std::vector<double> before = qualities(part.quads, start, plane);
    geometry::EmbedOptions options = flat_shaping(settings);
    options.area = areas;
    std::vector<char> fixed = part.fixed;
    auto positions = improve_without_spoiling(
        part.quads, fixed,
        [&](std::span<const char> held) {
            return geometry::improve(part.quads, held, start, options).positions;
        },
        [&](const geometry::Points &now) { return spoiled(before, qualities(part.quads, now, plane)); });
    if (!positions)
        return;
    if (wished)
        settle(
            part.quads, fixed, *positions,
            [&](const geometry::Points &) { return std::vector<double>(areas.begin(), areas.end()); },
            settings.size_weight, enough, options);
    part.put(mesh, [&](std::size_t i) { return plane.to_space((*positions)[i]); });
}

void smooth_on_surface(mesh::QuadMesh &mesh, const Part &part, const reference::Reference &reference,
                       std::span<const double> areas, const Settings &settings) {
    geometry::SurfacePositions start =
        reference::positions_on_surface(mesh, *reference.surface, reference.surface_triangles, part.vertices);
    reference::forget_normals(mesh, part.vertices, part.quads, start);
    const std::vector<double> before = geometry::scaled_jacobians(part.quads, start);
    const auto try_with = [&](const Part &tried) {
        geometry::SurfacePositions on_surface = start;
        geometry::EmbedOptions options = shaping(settings);
        options.feature_lines = tried.feature_lines;
        options.area = areas;
        geometry::improve(*reference.surface, tried.quads, tried.fixed, on_surface, options);
        if (!roll_back(tried.quads, start, on_surface, tried.feature_lines,
                       [&] { return spoiled(before, geometry::scaled_jacobians(tried.quads, on_surface)); }))
            return false;
        tried.put(mesh, [&](std::size_t i) { return on_surface.points[i]; });
        return true;
    };
    if (mesh.curves) {
        Part sliding = part;
        sliding.let_slide(mesh, reference::bend_tolerance(settings));
        if (!sliding.feature_lines.empty() && try_with(sliding))
            return;
    }
    try_with(part);
}

// Of some faces, so scaled that they sum up to what these have.
std::vector<double> scaled(const mesh::QuadMesh &mesh, const std::vector<int> &faces,
                           const std::vector<double> &areas) {
    std::vector<double> wanted;
    double sum = 0, area = 0;
    for (const int f : faces) {
        wanted.push_back(areas[at(f)]);
        sum += wanted.back();
        area += geometry::area_vector(reference::quad_of(mesh, f)).norm();
    }
    for (double &a : wanted)
        a *= area / sum;
    return wanted;
}

// all: [face of the mesh] wanted areas, but for a factor
Outcome smooth_faces(mesh::QuadMesh &mesh, const std::vector<int> &faces, const std::vector<double> &all,
                     const Settings &settings) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<int> moved;
    std::ranges::copy_if(faces, std::back_inserter(moved), [&](int f) { return !is_flat(mesh, f); });
    const Part part(mesh, moved);
    Outcome outcome;
    outcome.faces_before = outcome.faces_after = outcome.faces_wanted =
        static_cast<std::int64_t>(faces.size());
    for (const int v : part.vertices) {
        if (mesh.on_boundary(v))
            continue;
        ++outcome.valences_before[mesh.valence(v)];
        outcome.singular_before += mesh.valence(v) != 4;
    }
    outcome.valences_after = outcome.valences_before;
    outcome.singular_after = outcome.singular_bound = outcome.singular_before;
    outcome.quality_before = outcome.quality_after = reference::least_quality(mesh, faces);
    outcome.aspect_ratio_before = outcome.aspect_ratio_after = reference::largest_aspect_ratio(mesh, faces);
    if (moved.empty())
        return outcome;
    const double time_step = reference::time_step(mesh, faces);
    const Patch patch{faces, {}, 0};
    const reference::Reference reference = reference::reference_of(mesh, std::span(&patch, 1));
    mesh.surface = reference.surface;
    const auto plane = reference::plane_of(mesh, faces);
    // On a surface without a wish all are equal: vertices that bunch along its features spread.
    std::vector<double> areas;
    const bool wished = mesh.field(Entity::vertex, "size") != nullptr;
    if (plane || wished)
        areas = scaled(mesh, moved, all);
    if (plane)
        smooth_flat(mesh, part, *plane, areas, wished, settings);
    else
        smooth_on_surface(mesh, part, reference, areas, settings);
    outcome.quality_after = reference::least_quality(mesh, faces);
    outcome.aspect_ratio_after = reference::largest_aspect_ratio(mesh, faces);
    outcome.time_step = reference::time_step_ratio(time_step, reference::time_step(mesh, faces));
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

} // namespace

std::vector<Outcome> smooth(mesh::QuadMesh &mesh, const std::vector<Patch> *patches, const Settings &settings,
                            const Progress &progress) {
    std::vector<Outcome> outcomes;
    if (mesh.dim() == 3)
        mesh.curves = reference::curves_of(mesh);
    const std::vector<double> *sizes = mesh.field(Entity::vertex, "size");
    const std::vector<double> areas = sizes != nullptr ? wished_areas(mesh, *sizes) : local_areas(mesh);
    if (patches == nullptr) {
        progress(0, "smooth");
        std::vector<int> faces(static_cast<std::size_t>(mesh.n_faces()));
        std::iota(faces.begin(), faces.end(), 0);
        outcomes.push_back(smooth_faces(mesh, faces, areas, settings));
    } else {
        for (const Patch &patch : *patches) {
            progress(static_cast<double>(outcomes.size()) / static_cast<double>(patches->size()), "smooth");
            outcomes.push_back(smooth_faces(mesh, patch.faces, areas, settings));
        }
    }
    progress(1, "smooth");
    return outcomes;
}

} // namespace alphamst::smooth
