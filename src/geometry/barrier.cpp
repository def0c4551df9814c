#include "geometry/barrier.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace alphamst::geometry {

namespace {

using Eigen::Vector2d;

constexpr double infinite = std::numeric_limits<double>::infinity();

// chi and its derivative; the form for D <= 0 avoids cancellation.
struct Chi {
    double value, slope;
};

inline Chi chi(double d, double epsilon) {
    if (epsilon == 0)
        return {std::max(d, 0.0), 1.0};
    const double root = std::sqrt(epsilon * epsilon + d * d);
    const double value = d > 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
    return {value, value / root};
}

// A corner seen from one of its three vertices: squared length of both edges (with its
// gradient and, a multiple of the identity, its Hessian) and determinant (affine).
struct Form {
    double q, qx, qy, qq, d, dx, dy;
};

// The corners of a quad that depend on its vertex x: at x itself, next and previous.
template <class Visit>
inline void visit_corners(const Sector &s, const Points &points, const Vector2d &x, Visit visit) {
    const Vector2d &n = points[static_cast<std::size_t>(s.next)];
    const Vector2d &o = points[static_cast<std::size_t>(s.opposite)];
    const Vector2d &p = points[static_cast<std::size_t>(s.previous)];
    const Vector2d a = n - x, b = p - x, u = o - n, w = o - p;
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), uu = u.squaredNorm(), ww = w.squaredNorm();
    visit(Form{aa + bb, -2 * (a.x() + b.x()), -2 * (a.y() + b.y()), 4, cross(a, b), n.y() - p.y(),
               p.x() - n.x()},
          aa * bb);
    visit(Form{aa + uu, -2 * a.x(), -2 * a.y(), 2, cross(a, u), -u.y(), u.x()}, aa * uu);
    visit(Form{bb + ww, -2 * b.x(), -2 * b.y(), 2, cross(w, b), w.y(), -w.x()}, bb * ww);
}

} // namespace

double value(const Barrier &barrier, std::span<const Sector> star, const Points &points, const Vector2d &x) {
    const double shape = (1 - barrier.theta) / 2, size = barrier.theta / 2;
    double sum = 0;
    for (const Sector &s : star) {
        const double scale = 1 / barrier.area[static_cast<std::size_t>(s.quad)];
        visit_corners(s, points, x, [&](const Form &f, double) {
            const double d = f.d * scale, c = chi(d, barrier.epsilon).value;
            sum += c > 0 ? (shape * f.q * scale + size * (1 + d * d)) / c : infinite;
        });
    }
    return sum;
}

Expansion expand(const Barrier &barrier, std::span<const Sector> star, const Points &points,
                 const Vector2d &x) {
    const double shape = (1 - barrier.theta) / 2, size = barrier.theta / 2;
    Expansion e;
    for (const Sector &s : star) {
        const double scale = 1 / barrier.area[static_cast<std::size_t>(s.quad)];
        visit_corners(s, points, x, [&](const Form &f, double) {
            const double d = f.d * scale, dx = f.dx * scale, dy = f.dy * scale;
            const Chi c = chi(d, barrier.epsilon);
            if (!(c.value > 0)) {
                e.value = infinite;
                return;
            }
            // f = n / chi with n quadratic and chi taken as affine.
            const double k = shape * scale, r = 1 / c.value;
            const double n = k * f.q + size * (1 + d * d);
            const double nx = k * f.qx + 2 * size * d * dx, ny = k * f.qy + 2 * size * d * dy;
            const double cx = c.slope * dx * r, cy = c.slope * dy * r, v = n * r;
            e.value += v;
            e.gx += nx * r - v * cx;
            e.gy += ny * r - v * cy;
            e.hxx += (k * f.qq + 2 * size * dx * dx) * r - 2 * nx * r * cx + 2 * v * cx * cx;
            e.hxy += 2 * size * dx * dy * r - (nx * cy + ny * cx) * r + 2 * v * cx * cy;
            e.hyy += (k * f.qq + 2 * size * dy * dy) * r - 2 * ny * r * cy + 2 * v * cy * cy;
        });
    }
    return e;
}

double corner_value(const Barrier &barrier, const Eigen::Vector4d &edges, double wanted_area) {
    const double d = (edges[0] * edges[3] - edges[1] * edges[2]) / wanted_area;
    const double n =
        ((1 - barrier.theta) * edges.squaredNorm() / wanted_area + barrier.theta * (1 + d * d)) / 2;
    const double c = chi(d, barrier.epsilon).value;
    return c > 0 ? n / c : infinite;
}

CornerExpansion expand_corner(const Barrier &barrier, const Eigen::Vector4d &edges, double wanted_area) {
    const double k = (1 - barrier.theta) / wanted_area, theta = barrier.theta;
    const double d = (edges[0] * edges[3] - edges[1] * edges[2]) / wanted_area;
    const Eigen::Vector4d dd = Eigen::Vector4d(edges[3], -edges[2], -edges[1], edges[0]) / wanted_area;
    const Chi c = chi(d, barrier.epsilon);
    const double r = 1 / c.value, slope = c.slope * r;
    const double v = (k * edges.squaredNorm() + theta * (1 + d * d)) / 2 * r;
    const Eigen::Vector4d n = (k * edges + theta * d * dd) * r;

    CornerExpansion e;
    e.value = v;
    e.gradient = n - v * slope * dd;
    e.hessian = k * r * Eigen::Matrix4d::Identity() +
                (theta * r + 2 * v * slope * slope) * dd * dd.transpose() -
                slope * (n * dd.transpose() + dd * n.transpose());
    // The determinant is bilinear in the edges: the one indefinite part.
    const double bilinear = (theta * d * r - v * slope) / wanted_area;
    e.hessian(0, 3) += bilinear;
    e.hessian(3, 0) += bilinear;
    e.hessian(1, 2) -= bilinear;
    e.hessian(2, 1) -= bilinear;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(e.hessian);
    if (eigen.eigenvalues()[0] < 0)
        e.hessian = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
                    eigen.eigenvectors().transpose();
    return e;
}

double worst_corner(std::span<const Sector> star, const Points &points, const Vector2d &x) {
    double worst = 1;
    for (const Sector &s : star)
        visit_corners(s, points, x, [&](const Form &f, double lengths) {
            const double square = lengths > 0 ? f.d * std::abs(f.d) / lengths : 0;
            worst = std::min(worst, square);
        });
    return worst;
}

} // namespace alphamst::geometry
