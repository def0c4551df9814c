// One corner of a quad by two of its edges, of which the second turns left from the first where the corner
// is upright: both leave it, or the first comes to it and the second leaves.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace alphamst::quality {

// Twice the signed area of the triangle between two edges, in the plane or seen against a normal.
inline double determinant(const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
    return a.x() * b.y() - a.y() * b.x();
}
inline double determinant(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &normal) {
    return a.cross(b).dot(normal);
}
// Of (a.x, a.y, b.x, b.y).
inline double determinant(const Eigen::Vector4d &edges) { return edges[0] * edges[3] - edges[1] * edges[2]; }

// The sine of the corner: 1 for a right angle, 0 where an edge has no length. `lengths` is the product of
// both lengths.
inline double scaled_jacobian(double determinant, double lengths) {
    return lengths > 0 ? determinant / lengths : 0;
}
inline double scaled_jacobian(const Eigen::Vector2d &a, const Eigen::Vector2d &b) {
    return scaled_jacobian(determinant(a, b), std::sqrt(a.squaredNorm() * b.squaredNorm()));
}
inline double scaled_jacobian(const Eigen::Vector3d &a, const Eigen::Vector3d &b,
                              const Eigen::Vector3d &normal) {
    return scaled_jacobian(determinant(a, b, normal), std::sqrt(a.squaredNorm() * b.squaredNorm()));
}

// s |s| of the scaled Jacobian s, which rises with s and takes no roots. `squares` is the product of the
// squares of both lengths.
inline double signed_square(double determinant, double squares) {
    return squares > 0 ? determinant * std::abs(determinant) / squares : 0;
}
inline double of_signed_square(double square) { return std::copysign(std::sqrt(std::abs(square)), square); }

// Verdict's shape of the corner: as the scaled Jacobian, but less where the lengths differ. `squares` is the
// sum of the squares of both lengths.
inline double corner_shape(double determinant, double squares) {
    return squares > 0 ? 2 * determinant / squares : 0;
}

} // namespace alphamst::quality
