#include "geometry/surface_positions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "geometry/relax.h"
#include "geometry/sweep.h"
#include "geometry/unfold.h"
#include "index.h"
#include "quality/corner.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double size_weight = 0.6; // against shape: areas tell where the surface bends
constexpr double tight = 0.1;       // corners that are hardly positive: determinant over the wanted area
constexpr double careful = 0.4;     // scaled Jacobian: worse ones around a vertex are not made by moving it

// The corners of a quad: edge k leaves corner k; the normals are that of the surface and its own.
struct Corners {
    Vector3d edge[4], normal = Vector3d::Zero(), own;
    double square[4]; // of the edges

    Corners(const std::array<int, 4> &quad, const SurfacePositions &on_surface) {
        for (std::size_t k = 0; k < 4; ++k) {
            edge[k] = on_surface.points[at(quad[(k + 1) % 4])] - on_surface.points[at(quad[k])];
            square[k] = edge[k].squaredNorm();
            normal += on_surface.normals[at(quad[k])];
        }
        own = (edge[0] - edge[2]).cross(edge[1] - edge[3]).normalized();
        if (normal.isZero(0))
            normal = own;
        normal.normalize();
    }

    double determinant(std::size_t k) const {
        const Vector3d &before = edge[(k + 3) % 4], &next = edge[k];
        return std::min(quality::determinant(before, next, normal), quality::determinant(before, next, own));
    }

    // The smallest scaled Jacobian.
    double sine() const {
        double worst = 1; // s |s|
        for (std::size_t k = 0; k < 4; ++k) {
            // Not std::min: a NaN has to win.
            if (const double s = quality::signed_square(determinant(k), square[(k + 3) % 4] * square[k]);
                !(s >= worst))
                worst = s;
        }
        return quality::of_signed_square(worst);
    }
};

// Half the cross product of the diagonals.
Vector3d area_vector(const std::array<int, 4> &quad, const SurfacePositions &on_surface) {
    return (on_surface.points[at(quad[2])] - on_surface.points[at(quad[0])])
               .cross(on_surface.points[at(quad[3])] - on_surface.points[at(quad[1])]) /
           2;
}

// Of the quads themselves, weighted by their areas; not of length one.
std::vector<Vector3d> vertex_normals(Quads quads, const SurfacePositions &on_surface) {
    std::vector<Vector3d> normals(on_surface.points.size(), Vector3d::Zero());
    for (const auto &q : quads) {
        const Vector3d area = area_vector(q, on_surface);
        for (const int v : q)
            normals[at(v)] += area;
    }
    return normals;
}

// Smallest scaled Jacobian of the corners against the mean of the normals at the vertices.
double sine_against(const std::array<int, 4> &quad, const SurfacePositions &on_surface,
                    const std::vector<Vector3d> &normals) {
    Vector3d edge[4], normal = Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
        edge[k] = on_surface.points[at(quad[(k + 1) % 4])] - on_surface.points[at(quad[k])];
        normal += normals[at(quad[k])].normalized();
    }
    normal.normalize();
    double sine = 1;
    for (std::size_t k = 0; k < 4; ++k)
        if (const double s = quality::scaled_jacobian(edge[(k + 3) % 4], edge[k], normal); !(s >= sine))
            sine = s;
    return sine;
}

// The star of a vertex in the plane that touches the surface there; the vertex is the origin.
struct TangentStar {
    std::vector<Sector> sectors;
    Points points;
    Vector3d along, across;
    const FeatureLine *feature_line = nullptr; // that the vertex is on; then the plane is unfolded about it

    // Of the surface as coarsely as the quads see it: where it bends within one, a normal at a point
    // tells little.
    static Vector3d normal_of(const Problem &problem, const SurfacePositions &on_surface, int vertex) {
        Vector3d sum = Vector3d::Zero();
        for (const Sector &s : problem.stars.at(vertex))
            sum += on_surface.normals[at(vertex)] + on_surface.normals[at(s.next)];
        const double length = sum.norm();
        return length > 0 ? Vector3d(sum / length) : on_surface.normals[at(vertex)];
    }

    Freedom freedom() const { return feature_line ? Freedom::line : Freedom::plane; }

    void lay(const Problem &problem, const SurfacePositions &on_surface, int vertex,
             std::span<const FeatureLine> feature_lines) {
        const Vector3d &origin = on_surface.points[at(vertex)];
        feature_line =
            !feature_lines.empty() && feature_lines[at(vertex)] ? &feature_lines[at(vertex)] : nullptr;
        if (feature_line) {
            unfold(problem.stars.at(vertex), on_surface.points, vertex, *feature_line, sectors, points);
            along = (on_surface.points[at(feature_line->between[1])] -
                     on_surface.points[at(feature_line->between[0])])
                        .normalized();
            across.setZero();
            return;
        }
        const Vector3d normal = normal_of(problem, on_surface, vertex);
        along = normal.unitOrthogonal();
        across = normal.cross(along);
        sectors.clear();
        points.assign(1, Vector2d::Zero());
        for (const Sector &s : problem.stars.at(vertex)) {
            const int first = static_cast<int>(points.size());
            for (const int w : {s.next, s.opposite, s.previous}) {
                const Vector3d away = on_surface.points[at(w)] - origin;
                points.emplace_back(away.dot(along), away.dot(across));
            }
            sectors.push_back({first, first + 1, first + 2, s.quad});
        }
    }
};

class Mover {
public:
    Mover(const surface::Surface &surface, const Problem &problem, SurfacePositions &on_surface,
          const EmbedOptions &options)
        : surface_(surface), problem_(problem), on_surface_(on_surface), options_(options),
          awake_(on_surface.points.size()) {
        std::transform(problem.fixed.begin(), problem.fixed.end(), awake_.begin(),
                       [](char fixed) { return static_cast<char>(!fixed); });
    }

    // Sweeps of the barrier over the vertices that still move.
    void sweep_all() {
        std::vector<std::vector<int>> classes;
        if (options_.run)
            classes = colour(problem_);
        const int n = static_cast<int>(on_surface_.points.size());
        for (step_ = 0; step_ < options_.steps; ++step_)
            if (!sweep(n, classes, options_, [this](int v) { return move(v); }))
                break;
    }

    // Raises the worst corners until the smallest scaled Jacobian no longer rises.
    void sharpen() {
        sharpen_worst(
            problem_, options_.steps,
            [this](std::size_t q) { return least_jacobian(problem_.quads[q], on_surface_); },
            [this](int v, double floor) { turn(v, floor); });
    }

private:
    // Smallest determinant in the star over the wanted area.
    double least_determinant(const TangentStar &star) const {
        double least = std::numeric_limits<double>::infinity();
        const auto &p = star.points;
        for (const Sector &s : star.sectors) {
            const Vector2d a = p[at(s.next)] - p[0], b = p[at(s.previous)] - p[0],
                           u = p[at(s.opposite)] - p[at(s.next)], w = p[at(s.opposite)] - p[at(s.previous)];
            least = std::min(least, std::min({quality::determinant(a, b), quality::determinant(a, u),
                                              quality::determinant(w, b)}) /
                                        problem_.area[at(s.quad)]);
        }
        return least;
    }

    // True if the vertex moved far. Vertices without a common quad may be moved at the same time.
    bool move(int v) {
        const auto sectors = problem_.stars.at(v);
        if (!awake_[at(v)] || problem_.fixed[at(v)] || sectors.empty())
            return false;
        awake_[at(v)] = 0;
        thread_local TangentStar star;
        star.lay(problem_, on_surface_, v, options_.feature_lines);
        const double least = least_determinant(star);
        Barrier barrier{.theta = options_.size_weight.value_or(size_weight), .area = problem_.area};
        double distance = 0;
        if (!(least > tight)) {
            barrier.epsilon = std::max(0.3 * std::max(0.0, -least), softest * std::pow(0.5, step_) + 1e-3);
            distance = relax(barrier, star.sectors, star.points, 0, no_floor, star.freedom());
            barrier.epsilon = 0;
        }
        if (least_determinant(star) > 0)
            distance =
                std::max(distance, relax(barrier, star.sectors, star.points, 0, no_floor, star.freedom()));
        if (!land(v, star, least) || distance <= still * still * problem_.area[at(sectors[0].quad)])
            return false;
        awake_[at(v)] = 1;
        for (const Sector &s : sectors)
            for (const int w : {s.next, s.opposite, s.previous})
                std::atomic_ref(awake_[at(w)]).store(1, std::memory_order_relaxed);
        return true;
    }

    void turn(int v, double floor) {
        thread_local TangentStar star;
        const auto sectors = problem_.stars.at(v);
        if (sectors.empty())
            return;
        star.lay(problem_, on_surface_, v, options_.feature_lines);
        const double least = least_determinant(star);
        // Sliding is a short cut to better angles: the sides on a feature shrink to nothing. So no corner is
        // squeezed there that the sweeps would open again.
        const double smallest =
            star.feature_line ? std::max(tight, options_.least_area) : options_.least_area;
        if (least > 0 && geometry::sharpen(star.sectors, star.points, 0, floor,
                                           smallest * problem_.area[at(sectors[0].quad)], star.freedom()) > 0)
            land(v, star, least);
    }

    // Takes the vertex from its tangent plane to the surface. False, and nothing done, if that turned a
    // corner over.
    bool land(int v, TangentStar &star, double least) {
        if (star.points[0].squaredNorm() == 0)
            return false;
        const Vector3d from = on_surface_.points[at(v)];
        const Vector3d flat = from + star.points[0].x() * star.along + star.points[0].y() * star.across;
        const surface::Spot spot = star.feature_line
                                       ? spot_on(*star.feature_line, flat, v)
                                       : surface_.follow(flat, on_surface_.surface_triangles[at(v)]);
        if (star.feature_line && (!star.feature_line->holds(spot.point, on_surface_.points) ||
                                  star.feature_line->squeezes(from, spot.point, on_surface_.points)))
            return false;
        const Vector3d way = spot.point - from;
        star.points[0] = {way.dot(star.along), way.dot(star.across)};
        if (const double now = least_determinant(star); !(now > 0) && now < least)
            return false;
        // The corners as they are judged, each against its own quad.
        const surface::Spot old{on_surface_.surface_triangles[at(v)], from, on_surface_.normals[at(v)], 0};
        on_surface_.put(v, spot);
        const double now = worst_around(v);
        if (now >= careful)
            return true;
        on_surface_.put(v, old);
        if (const double before = worst_around(v); before > 0 && now < before)
            return false;
        on_surface_.put(v, spot);
        return true;
    }

    // On the line to the last bit, wherever the surface is.
    surface::Spot spot_on(const FeatureLine &feature_line, const Vector3d &p, int v) const {
        const Vector3d point = feature_line.at(feature_line.place(p));
        return {surface_.follow(point, on_surface_.surface_triangles[at(v)]).triangle, point,
                on_surface_.normals[at(v)], 0};
    }

    double worst_around(int v) const {
        double worst = 1;
        for (const Sector &s : problem_.stars.at(v))
            worst = std::min(worst, least_jacobian(problem_.quads[at(s.quad)], on_surface_));
        return worst;
    }

    const surface::Surface &surface_;
    const Problem &problem_;
    SurfacePositions &on_surface_;
    const EmbedOptions &options_;
    int step_ = 0;
    std::vector<char> awake_;
};

} // namespace

void SurfacePositions::add(const surface::Spot &spot) {
    points.push_back(spot.point);
    normals.push_back(spot.normal);
    surface_triangles.push_back(spot.triangle);
}

void SurfacePositions::put(int vertex, const surface::Spot &spot) {
    points[at(vertex)] = spot.point;
    normals[at(vertex)] = spot.normal;
    surface_triangles[at(vertex)] = spot.triangle;
}

double least_jacobian(const std::array<int, 4> &quad, const SurfacePositions &on_surface) {
    return Corners(quad, on_surface).sine();
}

double total_area(Quads quads, const SurfacePositions &on_surface) {
    double area = 0;
    for (const auto &q : quads)
        area += area_vector(q, on_surface).norm();
    return area;
}

std::vector<double> scaled_jacobians(Quads quads, const SurfacePositions &on_surface) {
    const std::vector<Vector3d> normals = vertex_normals(quads, on_surface);
    std::vector<double> result;
    result.reserve(quads.size());
    for (const auto &quad : quads)
        result.push_back(std::min(least_jacobian(quad, on_surface), sine_against(quad, on_surface, normals)));
    return result;
}

Judgement judge(Quads quads, const SurfacePositions &on_surface) {
    Judgement result;
    result.valid = true;
    if (quads.empty())
        return result;
    result = {std::numeric_limits<double>::infinity(), 1, 1, 0, 0, false};
    const std::vector<Vector3d> normals = vertex_normals(quads, on_surface);
    for (const auto &quad : quads) {
        const Corners corners(quad, on_surface);
        const double sine = std::min(corners.sine(), sine_against(quad, on_surface, normals));
        double shape = 1;
        for (std::size_t k = 0; k < 4; ++k) {
            const double d = corners.determinant(k);
            const double squares = corners.square[(k + 3) % 4] + corners.square[k];
            if (!(d >= result.min_determinant))
                result.min_determinant = d;
            if (const double s = quality::corner_shape(d, squares); !(s >= shape))
                shape = s;
        }
        if (!(sine >= result.min_scaled_jacobian))
            result.min_scaled_jacobian = sine;
        if (!(shape >= result.min_shape))
            result.min_shape = shape;
        result.inverted += !(sine > 0);
        result.poor += !acceptable(sine, shape);
    }
    result.valid = result.min_determinant > 0 && result.min_scaled_jacobian > 0;
    return result;
}

Judgement improve(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
                  SurfacePositions &on_surface, const EmbedOptions &options) {
    const double area = total_area(quads, on_surface);
    if (!(area > 0) || !std::isfinite(area))
        return judge(quads, on_surface);
    std::vector<double> wanted(options.area.begin(), options.area.end());
    wanted.resize(quads.size(), area / static_cast<double>(quads.size()));
    const Stars stars(quads, static_cast<int>(on_surface.points.size()));
    const Problem problem{quads, stars, fixed, wanted};
    Mover mover(surface, problem, on_surface, options);
    mover.sweep_all();
    mover.sharpen();
    return judge(quads, on_surface);
}

} // namespace alphamst::geometry
