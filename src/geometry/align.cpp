#include "geometry/align.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/star.h"
#include "index.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

constexpr double careful = 0.4; // scaled Jacobian: worse ones are not made by moving a vertex
constexpr double part = 0.5;    // of the way to where a vertex should be, in a step

// Corners of the square of this area around the middle of the quad, along the direction; of the four ways
// to name them the one nearest to the corners of the quad.
std::array<Vector3d, 4> square(const std::array<int, 4> &quad, const SurfacePositions &on_surface,
                               const Vector3d &direction, double area) {
    Vector3d middle = Vector3d::Zero();
    for (const int v : quad)
        middle += on_surface.points[at(v)] / 4;
    const Vector3d normal = (on_surface.points[at(quad[2])] - on_surface.points[at(quad[0])])
                                .cross(on_surface.points[at(quad[3])] - on_surface.points[at(quad[1])])
                                .normalized();
    const Vector3d along = (direction - direction.dot(normal) * normal).normalized() * std::sqrt(area) / 2;
    const Vector3d across = normal.cross(along);
    const std::array<Vector3d, 4> corners = {middle - along - across, middle + along - across,
                                             middle + along + across, middle - along + across};
    std::array<Vector3d, 4> best = corners;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t turn = 0; turn < 4; ++turn) {
        std::array<Vector3d, 4> turned;
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            turned[k] = corners[(k + turn) % 4];
            sum += (turned[k] - on_surface.points[at(quad[k])]).squaredNorm();
        }
        if (sum < least) {
            least = sum;
            best = turned;
        }
    }
    return best;
}

double worst_around(const Stars &stars, Quads quads, const SurfacePositions &on_surface, int vertex) {
    double worst = 1;
    for (const Sector &s : stars.at(vertex))
        worst = std::min(worst, least_jacobian(quads[at(s.quad)], on_surface));
    return worst;
}

// Where each vertex should be.
std::vector<Vector3d> goals(Quads quads, const SurfacePositions &on_surface,
                            std::span<const Vector3d> directions, std::span<const double> areas) {
    std::vector<Vector3d> sum(on_surface.points.size(), Vector3d::Zero());
    std::vector<double> count(on_surface.points.size(), 0);
    for (std::size_t q = 0; q < quads.size(); ++q) {
        const std::array<Vector3d, 4> corners = square(quads[q], on_surface, directions[q], areas[q]);
        for (std::size_t k = 0; k < 4; ++k)
            if (corners[k].allFinite()) {
                sum[at(quads[q][k])] += corners[k];
                ++count[at(quads[q][k])];
            }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
        sum[v] = count[v] > 0 ? Vector3d(sum[v] / count[v]) : on_surface.points[v];
    return sum;
}

} // namespace

void align(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
           std::span<const Vector3d> directions, SurfacePositions &on_surface, const EmbedOptions &options) {
    std::vector<double> areas(options.area.begin(), options.area.end());
    if (areas.empty())
        areas.assign(quads.size(), total_area(quads, on_surface) / static_cast<double>(quads.size()));
    const Stars stars(quads, static_cast<int>(on_surface.points.size()));
    for (int step = 0; step < options.steps; ++step) {
        const std::vector<Vector3d> goal = goals(quads, on_surface, directions, areas);
        for (int v = 0; v < static_cast<int>(on_surface.points.size()); ++v) {
            if (fixed[at(v)] || stars.at(v).empty())
                continue;
            const surface::Spot old{on_surface.surface_triangles[at(v)], on_surface.points[at(v)],
                                    on_surface.normals[at(v)], 0};
            const double before = worst_around(stars, quads, on_surface, v);
            on_surface.put(v, surface.follow(old.point + part * (goal[at(v)] - old.point), old.triangle));
            if (const double now = worst_around(stars, quads, on_surface, v);
                now < careful && !(now >= before))
                on_surface.put(v, old);
        }
    }
}

} // namespace alphamst::geometry
