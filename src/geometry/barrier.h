// The regularised shape barrier of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and
// Sokolov, "Foldover-free maps in 50 lines of code" (2021), on the corners of quads.
//
// With J the matrix of the two edges leaving a corner over the wanted edge length and
// D = det J,
//     f = ((1 - theta) |J|^2 / 2 + theta (1 + D^2) / 2) / chi(D),
//     chi(D) = (D + sqrt(epsilon^2 + D^2)) / 2.
// f is at least 1 and is 1 for a square of the wanted size. With epsilon = 0 it is
// infinite from D = 0 downwards.
#pragma once

#include <span>

#include "geometry/star.h"

namespace alphamst::geometry {

struct Barrier {
    double theta = 1.0 / 128; // weight of size against shape
    double epsilon = 0;
    std::span<const double> area; // [quad] wanted area
};

// f summed over the corners that depend on one vertex, to second order in its position.
// With the curvature of chi left out f is a square over an affine function of that
// position, hence convex: the Hessian is positive definite.
struct Expansion {
    double value = 0, gx = 0, gy = 0, hxx = 0, hxy = 0, hyy = 0;
};

double value(const Barrier &barrier, std::span<const Sector> star, const Points &points,
             const Eigen::Vector2d &x);
Expansion taylor_expansion(const Barrier &barrier, std::span<const Sector> star, const Points &points,
                           const Eigen::Vector2d &x);

// One corner as a function of its edges (a.x, a.y, b.x, b.y) = J; the Hessian is
// projected onto the positive semi-definite matrices.
struct CornerExpansion {
    double value;
    Eigen::Vector4d gradient;
    Eigen::Matrix4d hessian;
};
double corner_value(const Barrier &barrier, const Eigen::Vector4d &edges, double wanted_area);
CornerExpansion expand_corner(const Barrier &barrier, const Eigen::Vector4d &edges, double wanted_area);

// Smallest signed square of the scaled Jacobian, s |s|, over the corners that
// depend on one vertex. Monotone in s and free of square roots.
double worst_corner(std::span<const Sector> star, const Points &points, const Eigen::Vector2d &x);

} // namespace alphamst::geometry
