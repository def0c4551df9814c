#include "geometry/relax.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quality/corner.h"

namespace alphamst::geometry {

namespace {

using Eigen::Vector2d;

// -H^-1 g; a multiple of the identity is added where H is not positive definite.
bool newton_step(Expansion e, Vector2d &step) {
    const double trace = e.hxx + e.hyy;
    double determinant = e.hxx * e.hyy - e.hxy * e.hxy;
    constexpr double tiny = 1e-10;
    if (!(trace > 0) || !(determinant > tiny * trace * trace)) {
        const double lowest = trace / 2 - std::hypot((e.hxx - e.hyy) / 2, e.hxy);
        const double shift = std::abs(lowest) * 1.5 + 1e-6 * (std::abs(trace) + 1e-300);
        e.hxx += shift;
        e.hyy += shift;
        determinant = e.hxx * e.hyy - e.hxy * e.hxy;
    }
    step = Vector2d(e.hxy * e.gy - e.hyy * e.gx, e.hxy * e.gx - e.hxx * e.gy) / determinant;
    return std::isfinite(step.x()) && std::isfinite(step.y());
}

// What is left of an expansion on the line: a step of Newton's method stays on it.
void restrict_to(Freedom freedom, Expansion &e) {
    if (freedom == Freedom::plane)
        return;
    e.gy = e.hxy = 0;
    e.hyy = std::abs(e.hxx);
}

// Halves the step until `energy` falls enough and the floor holds.
template <class Energy>
double search(const Expansion &e, std::span<const Sector> star, Points &points, int vertex, Floor floor,
              Energy energy) {
    Vector2d step;
    Vector2d &point = points[static_cast<std::size_t>(vertex)];
    if (!std::isfinite(e.value) || !newton_step(e, step))
        return 0;
    const double slope = step.x() * e.gx + step.y() * e.gy;
    if (!(slope < -1e-14 * e.value))
        return 0;
    double lowest = floor;
    if (floor > no_floor)
        lowest = std::min(floor, worst_corner(star, points, point));
    double t = 1;
    for (int halving = 0; halving < 7; ++halving, t *= 0.5) {
        const Vector2d x = point + t * step;
        if (!(energy(x) <= e.value + 1e-3 * t * slope))
            continue;
        if (floor > no_floor && worst_corner(star, points, x) < lowest)
            continue;
        point = x;
        return t * t * step.squaredNorm();
    }
    return 0;
}

// The corner between edges a and b (b counter-clockwise of a).
struct Angle {
    double sine, cotangent, determinant;
};
inline Angle angle(const Vector2d &a, const Vector2d &b) {
    const double d = quality::determinant(a, b), dot = a.dot(b);
    return {quality::scaled_jacobian(a, b), dot / d, d};
}

inline double power8(double r) {
    const double r2 = r * r, r4 = r2 * r2;
    return r4 * r4;
}

// Infinite where a corner determinant is below `smallest`.
double sharp_value(std::span<const Sector> star, const Points &points, const Vector2d &x, double reference,
                   double smallest) {
    double sum = 0;
    for (const Sector &s : star) {
        const Vector2d &n = points[static_cast<std::size_t>(s.next)];
        const Vector2d &o = points[static_cast<std::size_t>(s.opposite)];
        const Vector2d &p = points[static_cast<std::size_t>(s.previous)];
        const Vector2d a = n - x, b = p - x, u = o - n, w = o - p;
        for (const Angle &corner : {angle(a, b), angle(u, -a), angle(-b, w)}) {
            if (!(corner.sine > 0) || corner.determinant < smallest)
                return std::numeric_limits<double>::infinity();
            sum += power8(reference / corner.sine);
        }
    }
    return sum;
}

// First and second derivatives of the direction angle of an edge that points to x:
// arg is harmonic, its gradient is the edge turned left over the squared length.
struct Turn {
    double gx, gy, hxx, hxy;
};
inline Turn turn(const Vector2d &edge) {
    const double r = 1 / edge.squaredNorm(), x = edge.x() * r, y = edge.y() * r;
    return {-y, x, 2 * x * y, y * y - x * x};
}

// Adds (reference / sin t)^8 for a corner angle t with derivatives `t`.
inline void add_sharp(Expansion &e, const Angle &corner, const Turn &t, double reference) {
    const double v = power8(reference / corner.sine), c = corner.cotangent;
    const double first = -8 * v * c, second = 8 * v * (1 + 9 * c * c);
    e.value += v;
    e.gx += first * t.gx;
    e.gy += first * t.gy;
    e.hxx += second * t.gx * t.gx + first * t.hxx;
    e.hxy += second * t.gx * t.gy + first * t.hxy;
    e.hyy += second * t.gy * t.gy - first * t.hxx;
}

} // namespace

double relax(const Barrier &barrier, std::span<const Sector> star, Points &points, int vertex, Floor floor,
             Freedom freedom) {
    Expansion e = taylor_expansion(barrier, star, points, points[static_cast<std::size_t>(vertex)]);
    restrict_to(freedom, e);
    if (barrier.epsilon == 0 && floor <= 0)
        floor = no_floor; // the barrier alone keeps every corner positive
    return search(e, star, points, vertex, floor,
                  [&](const Vector2d &x) { return value(barrier, star, points, x); });
}

double sharpen(std::span<const Sector> star, Points &points, int vertex, Floor floor, double smallest,
               Freedom freedom) {
    const Vector2d x = points[static_cast<std::size_t>(vertex)];
    const double worst = worst_corner(star, points, x);
    if (!(worst > 0))
        return 0;
    const double reference = std::sqrt(worst); // keeps the powers in range
    Expansion e;
    for (const Sector &s : star) {
        const Vector2d &n = points[static_cast<std::size_t>(s.next)];
        const Vector2d &o = points[static_cast<std::size_t>(s.opposite)];
        const Vector2d &p = points[static_cast<std::size_t>(s.previous)];
        const Vector2d a = n - x, b = p - x, u = o - n, w = o - p;
        // Turning x about next or previous; the corner at x closes by what they open.
        const Turn ta = turn(a), tb = turn(b);
        const Turn at_next{-ta.gx, -ta.gy, ta.hxx, ta.hxy}, at_previous{-tb.gx, -tb.gy, tb.hxx, tb.hxy};
        const Angle here = angle(a, b), there = angle(u, -a), behind = angle(-b, w);
        smallest = std::min({smallest, here.determinant, there.determinant, behind.determinant});
        add_sharp(e, here,
                  {at_previous.gx - at_next.gx, at_previous.gy - at_next.gy, at_previous.hxx - at_next.hxx,
                   at_previous.hxy - at_next.hxy},
                  reference);
        add_sharp(e, there, at_next, reference);
        add_sharp(e, behind, {-at_previous.gx, -at_previous.gy, -at_previous.hxx, -at_previous.hxy},
                  reference);
    }
    restrict_to(freedom, e);
    return search(e, star, points, vertex, floor,
                  [&](const Vector2d &y) { return sharp_value(star, points, y, reference, smallest); });
}

} // namespace alphamst::geometry
