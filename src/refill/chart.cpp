#include "refill/chart.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <utility>

#include "geometry/parametrise.h"
#include "geometry/plane.h"
#include "index.h"

namespace alphamst::refill {
namespace {

namespace index = boost::geometry::index;
using Eigen::Vector2d;
using Point = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using Box = boost::geometry::model::box<Point>;
using Entry = std::pair<Box, int>;

double twice_area(const Vector2d &a, const Vector2d &b, const Vector2d &c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// Barycentric; those of a triangle without area are its first corner.
Eigen::Vector3d weights_of(const std::array<int, 3> &triangle, const geometry::Points &p, const Vector2d &x) {
    const Vector2d &a = p[at(triangle[0])], &b = p[at(triangle[1])], &c = p[at(triangle[2])];
    const double area = twice_area(a, b, c);
    if (!(area > 0))
        return {1, 0, 0};
    return {twice_area(x, b, c) / area, twice_area(a, x, c) / area, twice_area(a, b, x) / area};
}

} // namespace

struct Chart::Tree {
    index::rtree<Entry, index::rstar<16>> boxes;
};

Chart::Chart(const fill::Filling &old, const geometry::SurfacePositions &on_surface, ChartKind kind)
    : old_(old), on_surface_(on_surface) {
    for (int i = 0; i < old.boundary; ++i)
        lengths_.push_back((on_surface.points[at((i + 1) % old.boundary)] - on_surface.points[at(i)]).norm());
    if (!lay(kind))
        positions_ = geometry::embed_on_circle(old.quads, old.boundary, old.vertices, lengths_);
    link();
}

// False where every map folds that was wanted or could stand in for it.
bool Chart::lay(ChartKind kind) {
    const geometry::Disk disk{old_.quads, old_.boundary, on_surface_.points};
    if (kind == ChartKind::plane_or_circle) {
        round_ = !project();
        return !round_;
    }
    if (kind == ChartKind::conformal) {
        round_ = !take(geometry::conformal(disk));
        if (!round_)
            return true;
    }
    if (kind == ChartKind::low_stretch && take(geometry::low_stretch_on_circle(disk)))
        return true;
    return take(geometry::mean_value_on_circle(disk));
}

bool Chart::take(geometry::Points positions) {
    if (positions.empty() || !geometry::is_bijective(old_.quads, old_.boundary, positions))
        return false;
    positions_ = std::move(positions);
    return true;
}

// False where the surface turns too far for that.
bool Chart::project() {
    constexpr double least_cosine = 0.5;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d &normal : on_surface_.normals)
        mean += normal;
    mean.normalize();
    if (!std::all_of(on_surface_.normals.begin(), on_surface_.normals.end(),
                     [&](const Eigen::Vector3d &normal) { return normal.dot(mean) > least_cosine; }))
        return false;
    const geometry::Plane plane = geometry::Plane::fit(on_surface_.points, mean);
    if (!(plane.normal().dot(mean) > std::sqrt(0.75)))
        return false;
    geometry::Points positions;
    for (const Eigen::Vector3d &p : on_surface_.points)
        positions.push_back(plane.to_plane(p));
    return take(std::move(positions));
}

void Chart::link() {
    std::vector<Entry> entries;
    for (const auto &q : old_.quads)
        for (const auto &t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
            Vector2d low = positions_[at(t[0])], high = low;
            for (const int v : t) {
                low = low.cwiseMin(positions_[at(v)]);
                high = high.cwiseMax(positions_[at(v)]);
            }
            entries.emplace_back(Box(Point(low.x(), low.y()), Point(high.x(), high.y())),
                                 static_cast<int>(triangles_.size()));
            triangles_.push_back(t);
        }
    tree_ = std::make_unique<const Tree>(Tree{{entries.begin(), entries.end()}});
}

Chart::~Chart() = default;
Chart::Chart(Chart &&) noexcept = default;

geometry::Embedding Chart::place(const fill::Filling &filling, const geometry::EmbedOptions &options) const {
    if (!round_)
        return geometry::embed(filling.quads, filling.boundary, filling.vertices, positions_, options);
    geometry::Embedding embedding;
    embedding.valid = true;
    embedding.positions =
        geometry::embed_on_circle(filling.quads, filling.boundary, filling.vertices, lengths_);
    return embedding;
}

surface::Spot Chart::lift(const surface::Surface &surface, const Vector2d &position) const {
    // In the triangle or, by rounding, next to it; of several the one that holds it best.
    int best = -1;
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    auto look = [&](int t) {
        const Eigen::Vector3d w = weights_of(triangles_[at(t)], positions_, position);
        if (best < 0 || std::pair(w.minCoeff(), -t) > std::pair(weights.minCoeff(), -best)) {
            best = t;
            weights = w;
        }
    };
    const Point point(position.x(), position.y());
    for (auto e = tree_->boxes.qbegin(index::intersects(point)); e != tree_->boxes.qend(); ++e)
        look(e->second);
    if (best < 0)
        for (auto e = tree_->boxes.qbegin(index::nearest(point, 4)); e != tree_->boxes.qend(); ++e)
            look(e->second);
    weights = weights.cwiseMax(0.0);
    weights /= weights.sum();
    const auto &corners = triangles_[at(best)];
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        x += weights[static_cast<Eigen::Index>(k)] * on_surface_.points[at(corners[k])];
        if (weights[static_cast<Eigen::Index>(k)] > weights[static_cast<Eigen::Index>(nearest)])
            nearest = k;
    }
    return surface.follow(x, on_surface_.surface_triangles[at(corners[nearest])]);
}

} // namespace alphamst::refill
