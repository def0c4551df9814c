#include "geometry/quad.h"

#include <Eigen/Geometry>
#include <algorithm>

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

// A triangle cut by three lines; each cut adds at most half as many corners as there are.
struct Polygon {
    std::array<Vector2d, 12> corners;
    std::size_t size = 0;

    void add(const Vector2d &corner) { corners[size++] = corner; }
    double area() const {
        double twice = 0;
        for (std::size_t i = 2; i < size; ++i)
            twice += quality::determinant(corners[i - 1] - corners[0], corners[i] - corners[0]);
        return twice / 2;
    }
};

bool upright(const Triangle &t) { return quality::determinant(t[1] - t[0], t[2] - t[0]) > 0; }

// The area two counter-clockwise triangles share: one is cut down by each side of the other in turn
// (Sutherland and Hodgman 1974).
double shared(const Triangle &one, const Triangle &other) {
    Polygon left;
    for (const Vector2d &corner : one)
        left.add(corner);
    for (std::size_t side = 0; side < 3; ++side) {
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
    return std::max(0.0, left.area());
}

} // namespace

QuadPoint closest_point(const Quad &quad, const Eigen::Vector3d &point) {
    QuadPoint best;
    bool first = true;
    for (const auto &[a, b, c] : cut(quad)) {
        const surface::Closest found =
            surface::closest(point, {quad[a], quad[b], quad[c]},
                             {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
        if (!first && !(found.squared < best.distance))
            continue;
        best = {};
        best.weights[a] = found.weights[0];
        best.weights[b] = found.weights[1];
        best.weights[c] = found.weights[2];
        best.distance = found.squared;
        first = false;
    }
    return best;
}

double overlap(const Quad &quad, const Quad &other) {
    const Vector3d normal = normal_of(quad).stableNormalized();
    if (!(normal.dot(normal_of(other)) > 0))
        return 0;
    const Vector3d across = normal.unitOrthogonal(), up = normal.cross(across);
    const auto flat = [&](const Quad &corners, const std::array<std::size_t, 3> &triangle) {
        Triangle seen;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3d place = corners[triangle[i]] - quad[0];
            seen[i] = {across.dot(place), up.dot(place)};
        }
        return seen;
    };
    double sum = 0;
    for (const auto &mine : cut(quad))
        for (const auto &theirs : cut(other)) {
            const Triangle one = flat(quad, mine), two = flat(other, theirs);
            if (upright(one) && upright(two))
                sum += shared(one, two);
        }
    return sum;
}

} // namespace alphamst::geometry
