#include "surface/triangle.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

// Square of the sine of a triangle's angle below which it is slender: scalar products may cost it two digits.
constexpr double slender = 1e-2;

Closest at_corner(const Vector3d &p, const Triangle &triangle, std::size_t i) {
    Vector3d weights = Vector3d::Zero();
    weights[static_cast<Eigen::Index>(i)] = 1;
    return {triangle[i], weights, (p - triangle[i]).squaredNorm()};
}

Closest on_edge(const Vector3d &p, const Triangle &triangle, const std::array<int, 3> &ids, std::size_t i,
                std::size_t j) {
    if (ids[j] < ids[i])
        std::swap(i, j);
    const Vector3d along = triangle[j] - triangle[i];
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - triangle[i]).dot(along) / length, 0.0, 1.0) : 0.0;
    if (t == 0 || t == 1)
        return at_corner(p, triangle, t == 0 ? i : j);
    Vector3d weights = Vector3d::Zero();
    weights[static_cast<Eigen::Index>(i)] = 1 - t;
    weights[static_cast<Eigen::Index>(j)] = t;
    const Vector3d point = triangle[i] + t * along;
    return {point, weights, (p - point).squaredNorm()};
}

} // namespace

// Ericson 2005, Real-Time Collision Detection, 5.1.5: which corner, edge or inside is nearest is told
// by the signs of scalar products with two sides. Their products lose (length / width)^2 of the digits, the
// cross products that equal them length / width, but these take half as long again: they are for the slender.
Closest closest(const Vector3d &p, const Triangle &triangle, const std::array<int, 3> &ids) {
    const auto &[a, b, c] = triangle;
    const Vector3d ab = b - a, ac = c - a;
    const double ab_a = ab.dot(p - a), ac_a = ac.dot(p - a);
    if (ab_a <= 0 && ac_a <= 0)
        return at_corner(p, triangle, 0);
    const double ab_b = ab.dot(p - b), ac_b = ac.dot(p - b);
    if (ab_b >= 0 && ac_b <= ab_b)
        return at_corner(p, triangle, 1);
    const double ab_c = ab.dot(p - c), ac_c = ac.dot(p - c);
    if (ac_c >= 0 && ab_c <= ac_c)
        return at_corner(p, triangle, 2);
    // Twice the areas of the triangles that the projection of p makes with the edges, times a constant.
    double of_c = ab_a * ac_b - ab_b * ac_a;
    double of_b = ab_c * ac_a - ab_a * ac_c;
    double of_a = ab_b * ac_c - ab_c * ac_b;
    if (!(of_a + of_b + of_c > slender * ab.squaredNorm() * ac.squaredNorm())) {
        const Vector3d normal = ab.cross(ac);
        of_c = normal.dot((p - a).cross(p - b));
        of_b = normal.dot((p - c).cross(p - a));
        of_a = normal.dot((p - b).cross(p - c));
    }
    if (of_c <= 0 && ab_a >= 0 && ab_b <= 0)
        return on_edge(p, triangle, ids, 0, 1);
    if (of_b <= 0 && ac_a >= 0 && ac_c <= 0)
        return on_edge(p, triangle, ids, 0, 2);
    if (of_a <= 0 && ac_b >= ab_b && ab_c >= ac_c)
        return on_edge(p, triangle, ids, 1, 2);
    const double sum = of_a + of_b + of_c;
    if (!(of_a > 0 && of_b > 0 && of_c > 0 && sum > 0)) { // degenerate: rounding decided above
        Closest best = on_edge(p, triangle, ids, 0, 1);
        for (const Closest &other : {on_edge(p, triangle, ids, 0, 2), on_edge(p, triangle, ids, 1, 2)})
            if (other.squared < best.squared)
                best = other;
        return best;
    }
    const Vector3d weights = Vector3d(of_a, of_b, of_c) / sum;
    const Vector3d point = a + weights[1] * ab + weights[2] * ac;
    return {point, weights, (p - point).squaredNorm()};
}

Vector3d unit_normal(const Vector3d &a, const Vector3d &b, const Vector3d &c) {
    const Vector3d normal = (b - a).cross(c - a);
    const double length = normal.norm();
    return length > 0 ? Vector3d(normal / length) : Vector3d::Zero();
}

} // namespace alphamst::surface
