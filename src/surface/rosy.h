// Directions in tangent planes as complex numbers: the angle of one from the first axis of a frame, once,
// doubled for a line or four times for a cross, which is then one number whichever of its directions is
// taken (Knoppel, Crane, Pinkall and Schroder 2013).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace alphamst::surface {

// std::complex, but for its care of infinite numbers, which takes most of the time of a product.
struct Complex {
    double re = 0, im = 0;
};

inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
inline Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Complex &operator+=(Complex &a, Complex b) { return a = a + b; }
inline Complex conjugate(Complex a) { return {a.re, -a.im}; }
inline Complex square(Complex a) { return a * a; }
inline double length(Complex a) { return std::sqrt(a.re * a.re + a.im * a.im); }
// Of length one; `otherwise` if it has none.
inline Complex unit(Complex a, Complex otherwise) {
    const double l = length(a);
    return l > 0 && std::isfinite(l) ? Complex{a.re / l, a.im / l} : otherwise;
}
// Of a number of length one: half its angle, which is within -90 and 90 degrees then.
inline Complex half(Complex a) {
    return {std::sqrt(std::fmax(0, (1 + a.re) / 2)),
            std::copysign(std::sqrt(std::fmax(0, (1 - a.re) / 2)), a.im)};
}

// Two axes of a tangent plane.
struct Frame {
    Eigen::Vector3d u, v;

    // Of a normal of length one.
    explicit Frame(const Eigen::Vector3d &normal) : u(normal.unitOrthogonal()), v(normal.cross(u)) {}

    Complex of(const Eigen::Vector3d &direction) const { return {u.dot(direction), v.dot(direction)}; }
    Eigen::Vector3d at(Complex a) const { return a.re * u + a.im * v; }
};

// What a number in frame `from` is multiplied with to be the one in frame `to` of the same direction, carried
// over by the least rotation that takes one plane to the other.
inline Complex transport(const Frame &from, const Frame &to) {
    return unit({to.u.dot(from.u) + to.v.dot(from.v), to.v.dot(from.u) - to.u.dot(from.v)}, {1, 0});
}

} // namespace alphamst::surface
