#include "surface/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "disjoint_sets.h"
#include "failure.h"
#include "index.h"
#include "surface/boxes.h"
#include "surface/triangle.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

const double cos_crease = std::cos(40 * std::numbers::pi / 180);
const double cos_agreement = std::cos(75 * std::numbers::pi / 180);

} // namespace

struct Surface::Tree {
    BoxTree boxes;
};

// The nearest place of one triangle.
struct Surface::Near {
    int triangle = -1;
    Closest place;

    // Nearer, or as near and of smaller id: a strict order, so every descent ends.
    bool before(const Near &other) const {
        return std::pair(place.squared, triangle) < std::pair(other.place.squared, other.triangle);
    }
};

Surface::Surface(std::vector<Vector3d> points, std::vector<std::array<int, 3>> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)) {
    check();
    link();
    find_normals();
    std::vector<BoxEntry> entries;
    entries.reserve(triangles_.size());
    for (const auto &[a, b, c] : triangles_) {
        const std::array corners{points_[at(a)], points_[at(b)], points_[at(c)]};
        entries.emplace_back(box_of(corners), static_cast<int>(entries.size()));
    }
    tree_.reset(new Tree{BoxTree(entries)});
}

Surface::~Surface() = default;

void Surface::check() const {
    if (triangles_.empty())
        throw Failure(Fault::range, "a surface needs at least one triangle");
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (!points_[i].allFinite())
            throw Failure(Fault::not_finite,
                          "point {} of the surface has a coordinate that is infinite or not a number; give "
                          "it a finite one",
                          Entity::none, {static_cast<std::int64_t>(i)});
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (const int i : triangles_[t])
            if (i < 0 || at(i) >= points_.size())
                throw Failure(Fault::range,
                              "triangle {} of the surface has corner {}, but there are " +
                                  std::to_string(points_.size()) +
                                  " points; correct the corner or add the point",
                              Entity::none, {static_cast<std::int64_t>(t), i});
}

void Surface::link() {
    begin_.assign(points_.size() + 1, 0);
    for (const auto &triangle : triangles_)
        for (const int i : triangle)
            ++begin_[at(i) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    around_.resize(begin_.back());
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (const int i : triangles_[t])
            around_[end[at(i)]++] = static_cast<int>(t);
}

void Surface::find_normals() {
    normals_.reserve(triangles_.size());
    for (const auto &[a, b, c] : triangles_)
        normals_.push_back(unit_normal(points_[at(a)], points_[at(b)], points_[at(c)]));
    const Vector3d none = Vector3d::Zero();
    corner_normals_.assign(triangles_.size(), {none, none, none});
    for (int point = 0; point < static_cast<int>(points_.size()); ++point)
        find_corner_normals(point);
}

// Those of the corners at one point: triangles with a smooth edge between them share one.
void Surface::find_corner_normals(int point) {
    const std::span<const int> fan = triangles_around(point);
    std::vector<std::pair<int, std::size_t>> edges; // the other point, the place in the fan
    for (std::size_t i = 0; i < fan.size(); ++i)
        for (const int other : triangles_[at(fan[i])])
            if (other != point)
                edges.emplace_back(other, i);
    std::sort(edges.begin(), edges.end());

    DisjointSets smooth(fan.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size() && edges[j].first == edges[i].first; ++j) {
            const Vector3d &n = normal(fan[edges[i].second]), &m = normal(fan[edges[j].second]);
            if (n.isZero(0) || m.isZero(0) || n.dot(m) >= cos_crease)
                smooth.unite(edges[j].second, edges[i].second);
        }

    std::vector<Vector3d> sums(fan.size(), Vector3d::Zero());
    const auto place = [&](int triangle) {
        return std::find(triangles_[at(triangle)].begin(), triangles_[at(triangle)].end(), point) -
               triangles_[at(triangle)].begin();
    };
    for (std::size_t i = 0; i < fan.size(); ++i) {
        const auto &triangle = triangles_[at(fan[i])];
        const std::size_t k = static_cast<std::size_t>(place(fan[i]));
        const Vector3d to_next = points_[at(triangle[(k + 1) % 3])] - points_[at(point)];
        const Vector3d to_last = points_[at(triangle[(k + 2) % 3])] - points_[at(point)];
        const double angle = std::atan2(to_next.cross(to_last).norm(), to_next.dot(to_last));
        sums[smooth.find(i)] += angle * normal(fan[i]);
    }
    for (std::size_t i = 0; i < fan.size(); ++i) {
        const Vector3d &sum = sums[smooth.find(i)];
        const double length = sum.norm();
        corner_normals_[at(fan[i])][static_cast<std::size_t>(place(fan[i]))] =
            length > 0 ? Vector3d(sum / length) : normal(fan[i]);
    }
}

Vector3d Surface::normal_at(int triangle, const Vector3d &weights) const {
    const std::array<Vector3d, 3> &corners = corner_normals_[at(triangle)];
    const Vector3d sum = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    const double length = sum.norm();
    if (length > 0)
        return sum / length;
    // Normals that cancel each other, or a triangle without area among others of its kind.
    return normal(triangle).isZero(0) ? Vector3d::UnitZ() : normal(triangle);
}

double Surface::area() const {
    double sum = 0;
    for (const auto &[a, b, c] : triangles_)
        sum += (points_[at(b)] - points_[at(a)]).cross(points_[at(c)] - points_[at(a)]).norm() / 2;
    return sum;
}

Surface::Near Surface::near(const Vector3d &p, int triangle) const {
    const auto &corners = triangles_[at(triangle)];
    return {triangle,
            closest(p, {points_[at(corners[0])], points_[at(corners[1])], points_[at(corners[2])]}, corners)};
}

// The nearest of the triangle and its neighbours; `touching`: of those only that touch the nearest place,
// the one across an edge or those around a corner, which are few.
Surface::Near Surface::step(const Vector3d &p, const Near &from, bool touching) const {
    const std::array<int, 3> &corners = triangles_[at(from.triangle)];
    const auto holds = [&](std::size_t k) { return from.place.weights[static_cast<Eigen::Index>(k)] > 0; };
    const auto touches = [&](const std::array<int, 3> &other) {
        for (std::size_t k = 0; k < 3; ++k)
            if (holds(k) && std::find(other.begin(), other.end(), corners[k]) == other.end())
                return false;
        return true;
    };
    Near best = from;
    for (std::size_t k = 0; k < 3; ++k) {
        if (touching && !holds(k))
            continue;
        for (const int triangle : triangles_around(corners[k]))
            if (!touching || touches(triangles_[at(triangle)]))
                if (const Near next = near(p, triangle); next.before(best))
                    best = next;
        if (touching)
            break;
    }
    return best;
}

Surface::Near Surface::descend(const Vector3d &p, Near from) const {
    // Inside of a triangle the nearest place is that of its neighbourhood.
    while (!(from.place.weights.array() > 0).all()) {
        Near next = step(p, from, true);
        if (next.triangle == from.triangle) // a triangle without area may be in the way
            next = step(p, from, false);
        if (next.triangle == from.triangle)
            break;
        from = next;
    }
    return from;
}

Spot Surface::spot(const Vector3d &p, const Near &near) const {
    return {near.triangle, near.place.point, normal_at(near.triangle, near.place.weights),
            (p - near.place.point).norm()};
}

// The nearest of the triangles that are accepted; triangle -1 if none is. The triangle of the nearest
// box, and where one comes from there, bound the distance; what is within it decides.
template <class Accept> Surface::Near Surface::search(const Vector3d &p, const Accept &accept) const {
    const BoxCorner asked = box_corner(p);
    const auto accepted =
        spatial_index::satisfies([&](const BoxEntry &entry) { return accept(entry.second); });
    Near best;
    const auto begin = [&](const BoxEntry &entry) { best = near(p, entry.second); };
    tree_->boxes.query(spatial_index::nearest(asked, 1) && accepted,
                       boost::make_function_output_iterator(begin));
    if (best.triangle < 0)
        return best;
    if (const Near way = descend(p, best); accept(way.triangle))
        best = way;
    // A little further, so that rounding hides no tie.
    const double bound = best.place.squared * (1 + 1e-12);
    const auto improve = [&](const BoxEntry &entry) {
        if (boost::geometry::comparable_distance(asked, entry.first) > bound || !accept(entry.second))
            return;
        if (const Near next = near(p, entry.second); next.before(best))
            best = next;
    };
    const Vector3d reach = Vector3d::Constant(std::sqrt(bound));
    tree_->boxes.query(spatial_index::intersects(Box(box_corner(p - reach), box_corner(p + reach))),
                       boost::make_function_output_iterator(improve));
    return best;
}

Spot Surface::nearest(const Vector3d &p) const {
    return spot(p, search(p, [](int) { return true; }));
}

Spot Surface::nearest(const Vector3d &p, const Vector3d &normal) const {
    const double least = cos_agreement * normal.norm();
    const Near near = search(p, [&](int t) { return this->normal(t).dot(normal) > least; });
    return near.triangle < 0 ? nearest(p) : spot(p, near);
}

Spot Surface::follow(const Vector3d &p, int triangle) const { return spot(p, descend(p, near(p, triangle))); }

} // namespace alphamst::surface
