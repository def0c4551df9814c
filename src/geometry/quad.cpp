#include "geometry/quad.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "quality/corner.h"

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

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

// Weights of b and c in the point of a triangle nearest to p: the walk over its corners, sides and
// inside of Ericson (Real-Time Collision Detection, 2005, section 5.1.5). His differences of dot products
// would lose (length / width)^2 of the digits in a slender triangle; the cross products that equal them
// lose length / width.
std::array<double, 2> nearest(const Vector3d &a, const Vector3d &b, const Vector3d &c, const Vector3d &p) {
    const Vector3d ab = b - a, ac = c - a, normal = ab.cross(ac);
    const double ab_a = ab.dot(p - a), ac_a = ac.dot(p - a);
    if (ab_a <= 0 && ac_a <= 0)
        return {0, 0};
    const double ab_b = ab.dot(p - b), ac_b = ac.dot(p - b);
    if (ab_b >= 0 && ac_b <= ab_b)
        return {1, 0};
    const double at_c = normal.dot((a - p).cross(b - p));
    if (at_c <= 0 && ab_a >= 0 && ab_b <= 0)
        return {ratio(ab_a, ab_a - ab_b), 0};
    const double ab_c = ab.dot(p - c), ac_c = ac.dot(p - c);
    if (ac_c >= 0 && ab_c <= ac_c)
        return {0, 1};
    const double at_b = normal.dot((c - p).cross(a - p));
    if (at_b <= 0 && ac_a >= 0 && ac_c <= 0)
        return {0, ratio(ac_a, ac_a - ac_c)};
    const double at_a = normal.dot((b - p).cross(c - p));
    const double from_b = ac_b - ab_b, from_c = ab_c - ac_c;
    if (at_a <= 0 && from_b >= 0 && from_c >= 0) {
        const double along = ratio(from_b, from_b + from_c);
        return {1 - along, along};
    }
    const double sum = at_a + at_b + at_c;
    return {ratio(at_b, sum), ratio(at_c, sum)};
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
        const auto [at_b, at_c] = nearest(quad[a], quad[b], quad[c], point);
        QuadPoint spot;
        spot.weights[a] = std::max(0.0, 1 - at_b - at_c);
        spot.weights[b] = at_b;
        spot.weights[c] = at_c;
        spot.distance =
            (quad[a] + at_b * (quad[b] - quad[a]) + at_c * (quad[c] - quad[a]) - point).squaredNorm();
        if (first || spot.distance < best.distance)
            best = spot;
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
