#include "geometry/barrier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "quality/corner.h"

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
    visit(Form{aa + bb, -2 * (a.x() + b.x()), -2 * (a.y() + b.y()), 4, quality::determinant(a, b),
               n.y() - p.y(), p.x() - n.x()},
          aa * bb);
    visit(Form{aa + uu, -2 * a.x(), -2 * a.y(), 2, quality::determinant(a, u), -u.y(), u.x()}, aa * uu);
    visit(Form{bb + ww, -2 * b.x(), -2 * b.y(), 2, quality::determinant(w, b), w.y(), -w.x()}, bb * ww);
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

Expansion taylor_expansion(const Barrier &barrier, std::span<const Sector> star, const Points &points,
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
    const double d = quality::determinant(edges) / wanted_area;
    const double n =
        ((1 - barrier.theta) * edges.squaredNorm() / wanted_area + barrier.theta * (1 + d * d)) / 2;
    const double c = chi(d, barrier.epsilon).value;
    return c > 0 ? n / c : infinite;
}

namespace {

// The Hessian diagonal + bilinear M + square dd dd' - slope (n dd' + dd n'), where M is the
// (constant) Hessian of the determinant.
struct Parts {
    Eigen::Vector4d edges, dd, n;
    double diagonal, square, slope, bilinear;
};

// M has eigenvalues 1 and -1, twice each, and dd and n lie in the span of the edges' parts in
// its two eigenspaces. So the eigenvectors are known up to a rotation in that span, and
// negative eigenvalues are cut off in closed form.
Eigen::Matrix4d projected_hessian(const Parts &h) {
    const double half = 1 / std::numbers::sqrt2;
    Eigen::Matrix4d basis; // eigenvectors of M: 1, 1, -1, -1; the first of each along the edges
    basis << 1, 0, 1, 0, 0, 1, 0, 1, 0, -1, 0, 1, 1, 0, -1, 0;
    basis *= half;
    for (Eigen::Index pair = 0; pair < 4; pair += 2) {
        const Eigen::Vector2d along = basis.middleCols<2>(pair).transpose() * h.edges;
        if (along.norm() > 0) {
            Eigen::Matrix2d turn;
            turn << along[0], -along[1], along[1], along[0];
            basis.middleCols<2>(pair) = (basis.middleCols<2>(pair) * turn / along.norm()).eval();
        }
    }
    const double dp = basis.col(0).dot(h.dd), dq = basis.col(2).dot(h.dd);
    const double np = basis.col(0).dot(h.n), nq = basis.col(2).dot(h.n);
    const double pp = h.diagonal + h.bilinear + h.square * dp * dp - 2 * h.slope * np * dp;
    const double qq = h.diagonal - h.bilinear + h.square * dq * dq - 2 * h.slope * nq * dq;
    const double pq = h.square * dp * dq - h.slope * (np * dq + dp * nq);
    const double angle = 0.5 * std::atan2(2 * pq, pp - qq), c = std::cos(angle), s = std::sin(angle);
    const double mean = (pp + qq) / 2, radius = std::hypot((pp - qq) / 2, pq);
    const Eigen::Vector4d high = c * basis.col(0) + s * basis.col(2),
                          low = c * basis.col(2) - s * basis.col(0);
    auto cut = [](double value) { return std::max(value, 0.0); };
    return cut(mean + radius) * high * high.transpose() + cut(mean - radius) * low * low.transpose() +
           cut(h.diagonal + h.bilinear) * basis.col(1) * basis.col(1).transpose() +
           cut(h.diagonal - h.bilinear) * basis.col(3) * basis.col(3).transpose();
}

} // namespace

CornerExpansion expand_corner(const Barrier &barrier, const Eigen::Vector4d &edges, double wanted_area) {
    const double k = (1 - barrier.theta) / wanted_area, theta = barrier.theta;
    const double d = quality::determinant(edges) / wanted_area;
    const Eigen::Vector4d dd = Eigen::Vector4d(edges[3], -edges[2], -edges[1], edges[0]) / wanted_area;
    const Chi c = chi(d, barrier.epsilon);
    const double r = 1 / c.value, slope = c.slope * r;
    const double v = (k * edges.squaredNorm() + theta * (1 + d * d)) / 2 * r;
    const Eigen::Vector4d n = (k * edges + theta * d * dd) * r;

    CornerExpansion e;
    e.value = v;
    e.gradient = n - v * slope * dd;
    e.hessian = projected_hessian({edges, dd, n, k * r, theta * r + 2 * v * slope * slope, slope,
                                   (theta * d * r - v * slope) / wanted_area});
    return e;
}

double worst_corner(std::span<const Sector> star, const Points &points, const Vector2d &x) {
    double worst = 1;
    for (const Sector &s : star)
        visit_corners(s, points, x, [&](const Form &f, double squares) {
            worst = std::min(worst, quality::signed_square(f.d, squares));
        });
    return worst;
}

} // namespace alphamst::geometry
