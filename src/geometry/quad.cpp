#include "geometry/quad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "quality/corner.h"
#include "surface/triangle.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<Vector2d, 3>;

Vector3d normal_of(const Quad &quad) { return (quad[2] - quad[0]).cross(quad[3] - quad[1]); }

// Corners of the two triangles: cut along the diagonal that leaves the smaller of them the larger, so
// that both are upright wherever the quad has no corner that cross_field the opposite sides.
std::array<std::array<std::size_t, 3>, 2> cut(const Quad &quad) {
    const Vector3d normal = normal_of(quad);
    const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
        return normal.dot((quad[b] - quad[a]).cross(quad[c] - quad[a]));
    };
    if (std::min(area(0, 1, 2), area(0, 2, 3)) >= std::min(area(1, 2, 3), area(1, 3, 0)))
        return {{{0, 1, 2}, {0, 2, 3}}};
    return {{{1, 2, 3}, {1, 3, 0}}};
}

// Twice an area, and six times its first moment.
struct Moments {
    double twice = 0;
    Vector2d sixfold = Vector2d::Zero();
};

// A triangle cut by three lines; each cut adds at most half as many corners as there are.
struct Polygon {
    std::array<Vector2d, 12> corners;
    std::size_t size = 0;

    void add(const Vector2d &corner) { corners[size++] = corner; }
    Moments moments() const {
        Moments sum;
        for (std::size_t i = 2; i < size; ++i) {
            const Vector2d &a = corners[0], &b = corners[i - 1], &c = corners[i];
            const double twice = quality::determinant(b - a, c - a);
            sum.twice += twice;
            sum.sixfold += twice * (a + b + c);
        }
        return sum;
    }
};

bool upright(const Triangle &t) { return quality::determinant(t[1] - t[0], t[2] - t[0]) > 0; }

// Whether a line along a coordinate axis parts them.
bool apart(const Triangle &one, const Triangle &other) {
    const auto low = [](const Triangle &t) { return t[0].cwiseMin(t[1]).cwiseMin(t[2]); };
    const auto high = [](const Triangle &t) { return t[0].cwiseMax(t[1]).cwiseMax(t[2]); };
    return (low(one).array() >= high(other).array()).any() || (low(other).array() >= high(one).array()).any();
}

// What two counter-clockwise triangles share: one is cut down by each side of the other in turn
// (Sutherland and Hodgman 1974).
Moments shared(const Triangle &one, const Triangle &other) {
    Polygon left;
    for (const Vector2d &corner : one)
        left.add(corner);
    for (std::size_t side = 0; side < 3 && left.size > 0; ++side) {
        const Vector2d from = other[side], along = other[(side + 1) % 3] - from;
        Polygon kept;
        for (std::size_t i = 0; i < left.size; ++i) {
            const Vector2d a = left.corners[i], b = left.corners[(i + 1) % left.size];
            const double height_a = quality::determinant(along, a - from),
                         height_b = quality::determinant(along, b - from);
            if (height_a >= 0)
                kept.add(a);
            if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0))
                kept.add(a + (b - a) * (height_a / (height_a - height_b)));
        }
        left = kept;
    }
    const Moments moments = left.moments();
    return moments.twice > 0 ? moments : Moments();
}

// The triangle of a quad that is nearest to a point, and its point there.
struct Nearest {
    std::array<std::size_t, 3> triangle;
    QuadPoint spot;
};

Nearest nearest(const Quad &quad, const Vector3d &point) {
    std::optional<Nearest> best;
    for (const auto &triangle : cut(quad)) {
        const auto &[a, b, c] = triangle;
        const surface::Closest found =
            surface::closest(point, {quad[a], quad[b], quad[c]},
                             {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
        if (best && !(found.squared < best->spot.distance))
            continue;
        best = {triangle, {{}, found.squared}};
        best->spot.weights[a] = found.weights[0];
        best->spot.weights[b] = found.weights[1];
        best->spot.weights[c] = found.weights[2];
    }
    return *best;
}

// Weights beyond that continue nothing: the triangle is too small or too slender to tell.
constexpr double far = 3;

} // namespace

QuadPoint closest_point(const Quad &quad, const Vector3d &point) { return nearest(quad, point).spot; }

QuadPoint continued_point(const Quad &quad, const Vector3d &point) {
    const auto [triangle, spot] = nearest(quad, point);
    const auto &[a, b, c] = triangle;
    const Vector3d normal = (quad[b] - quad[a]).cross(quad[c] - quad[a]);
    const auto weight = [&](std::size_t i, std::size_t j) {
        return normal.dot((quad[i] - point).cross(quad[j] - point)) / normal.squaredNorm();
    };
    const double of_a = weight(b, c), of_b = weight(c, a), of_c = 1 - of_a - of_b;
    if (spot.distance == 0 || !(std::min({of_a, of_b, of_c}) >= -far && std::max({of_a, of_b, of_c}) <= far))
        return spot;
    QuadPoint continued{{}, spot.distance};
    continued.weights[a] = of_a;
    continued.weights[b] = of_b;
    continued.weights[c] = of_c;
    return continued;
}

Vector3d area_centroid(const Quad &quad) {
    const Vector3d normal = normal_of(quad);
    Vector3d sum = Vector3d::Zero();
    double size = 0;
    for (const auto &[a, b, c] : cut(quad)) {
        const Vector3d to_b = quad[b] - quad[0], to_c = quad[c] - quad[0], to_a = quad[a] - quad[0];
        const double area = normal.dot((to_b - to_a).cross(to_c - to_a));
        sum += area * (to_a + to_b + to_c);
        size += area;
    }
    return size > 0 ? Vector3d(quad[0] + sum / (3 * size)) : centre(quad);
}

Intersection overlap(const Quad &quad, const Quad &other) {
    const Vector3d normal = normal_of(quad).stableNormalized();
    if (!(normal.dot(normal_of(other)) > 0))
        return {};
    const Vector3d across = normal.unitOrthogonal(), up = normal.cross(across);
    const auto flat = [&](const Quad &corners) {
        std::array<Triangle, 2> seen;
        const auto triangles = cut(corners);
        for (std::size_t t = 0; t < 2; ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const Vector3d place = corners[triangles[t][i]] - quad[0];
                seen[t][i] = {across.dot(place), up.dot(place)};
            }
        return seen;
    };
    Moments sum;
    const std::array<Triangle, 2> mine = flat(quad), theirs = flat(other);
    for (const Triangle &one : mine)
        for (const Triangle &two : theirs)
            if (upright(one) && upright(two) && !apart(one, two)) {
                const Moments moments = shared(one, two);
                sum.twice += moments.twice;
                sum.sixfold += moments.sixfold;
            }
    if (!(sum.twice > 0))
        return {};
    const Vector2d place = sum.sixfold / (3 * sum.twice);
    return {sum.twice / 2, quad[0] + across * place[0] + up * place[1]};
}

} // namespace alphamst::geometry
