#include "quality/metric.h"

#include "quality/element.h"

#include <limits>
#include <numbers>

#include "quality/corner.h"

namespace alphamst::quality {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

double angle_between(const Vector &a, const Vector &b) {
    return degrees * std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
}

// A quadrilateral whose last edge has no length is judged as the triangle 0, 1, 2
// by the metrics that are defined at its corners.
double triangle_angle(const Element &e, bool largest) {
    const auto &[a, b, none, c] = e.edge; // c runs from 2 to 0
    if (a.isZero(0) || b.isZero(0) || c.isZero(0))
        return 0;
    const auto [low, high] = std::minmax({angle_between(a, -c), angle_between(b, -a), angle_between(c, -b)});
    return largest ? high : low;
}

double triangle_condition(const Element &e) {
    const Vector &a = e.edge[0], b = -e.edge[3];
    const double parallelogram = a.cross(b).norm();
    if (parallelogram == 0)
        return huge;
    return bounded((a.squaredNorm() + b.squaredNorm() - a.dot(b)) / (std::sqrt(3.0) * parallelogram));
}

double triangle_scaled_jacobian(const Element &e) {
    const auto &[a, b, none, c] = e.length;
    const double product = std::max({a * b, b * c, c * a});
    if (product < tiny)
        return 0;
    return bounded(2 / std::sqrt(3.0) * e.edge[0].cross(e.edge[1]).norm() / product);
}

// Smallest and largest corner angle. Where a corner is reflex or the element is inverted
// the largest acute reading is the complement of the true angle.
double min_angle(const Element &e) {
    if (e.collapsed())
        return triangle_angle(e, false);
    if (e.shortest() <= tiny)
        return 360;
    double smallest = 360;
    for (std::size_t k = 0; k < 4; ++k)
        smallest = std::min(smallest, angle_between(e.edge[k], -e.edge[(k + 3) % 4]));
    return smallest;
}

double max_angle(const Element &e) {
    if (e.collapsed())
        return triangle_angle(e, true);
    if (e.shortest() <= tiny)
        return 0;
    double largest = 0;
    bool reflex = false;
    for (std::size_t k = 0; k < 4; ++k) {
        largest = std::max(largest, angle_between(e.edge[k], -e.edge[(k + 3) % 4]));
        reflex = reflex || e.corner_area[k] < 0;
    }
    return reflex ? 360 - largest : largest;
}

// Pebay (2004): a triangle's ratio of longest edge to inradius, by perimeter and area.
double aspect_ratio(const Element &e) {
    const double perimeter = e.length[0] + e.length[1] + e.length[2] + e.length[3];
    return bounded(e.longest() * perimeter / (4 * e.area()));
}

double edge_ratio(const Element &e) {
    if (e.shortest() * e.shortest() < tiny)
        return huge;
    return bounded(e.longest() / e.shortest());
}

// Pebay (2004), "radius ratio" by analogy: a quadrilateral has no incircle in general.
double radius_ratio(const Element &e) {
    double squares = 0, longest = std::max(e.diagonal[0].squaredNorm(), e.diagonal[1].squaredNorm());
    double smallest = huge;
    for (std::size_t k = 0; k < 4; ++k) {
        squares += e.edge[k].squaredNorm();
        longest = std::max(longest, e.edge[k].squaredNorm());
        smallest = std::min(smallest, e.normal[k].norm());
    }
    if (smallest < tiny)
        return huge;
    return bounded(std::sqrt(squares * longest / 8) / smallest);
}

// Knupp (2000): condition number of the Jacobian matrix, the worst corner.
double condition(const Element &e) {
    if (e.collapsed())
        return triangle_condition(e);
    double worst = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (e.corner_area[k] < tiny)
            return huge;
        const double squares = e.edge[k].squaredNorm() + e.edge[(k + 3) % 4].squaredNorm();
        worst = std::max(worst, squares / e.corner_area[k]);
    }
    return bounded(worst / 2);
}

// Knupp (2003): its inverse, but 0 where that is infinite.
double shape(const Element &e) {
    if (e.shortest() * e.shortest() <= tiny)
        return 0;
    double worst = huge;
    for (std::size_t k = 0; k < 4; ++k) {
        const double squares = e.edge[k].squaredNorm() + e.edge[(k + 3) % 4].squaredNorm();
        worst = std::min(worst, corner_shape(e.corner_area[k], squares));
    }
    return worst < tiny ? 0 : bounded(worst);
}

double jacobian(const Element &e) {
    const double scale = e.size * e.size;
    if (e.collapsed())
        return bounded(scale * e.edge[0].cross(e.edge[1]).norm());
    return bounded(scale * *std::min_element(e.corner_area.begin(), e.corner_area.end()));
}

double scaled_jacobian(const Element &e) {
    if (e.collapsed())
        return triangle_scaled_jacobian(e);
    if (e.shortest() < tiny)
        return 0;
    double worst = huge;
    for (std::size_t k = 0; k < 4; ++k)
        worst =
            std::min(worst, quality::scaled_jacobian(e.corner_area[k], e.length[k] * e.length[(k + 3) % 4]));
    return bounded(worst);
}

double shear(const Element &e) {
    const double value = scaled_jacobian(e);
    return value <= tiny ? 0 : value;
}

// Oddy, Goldak, McDill and Bibby (1988): from the metric tensor at the worst corner.
double oddy(const Element &e) {
    double worst = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vector &a = e.edge[k], &b = e.edge[(k + 3) % 4];
        const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b);
        const double determinant = aa * bb - ab * ab;
        if (determinant < tiny)
            return huge;
        worst = std::max(worst, ((aa - bb) * (aa - bb) + 4 * ab * ab) / (2 * determinant));
    }
    return bounded(worst);
}

// Robinson (1987): angle between the axes, and growth of opposite edges along them.
double skew(const Element &e) { return std::abs(direction(e.axis[0]).dot(direction(e.axis[1]))); }

double taper(const Element &e) {
    const double shorter = std::min(e.axis[0].norm(), e.axis[1].norm());
    if (shorter < tiny)
        return huge;
    return bounded((e.edge[0] + e.edge[2]).norm() / shorter);
}

double stretch(const Element &e) {
    const double longest = std::max(e.diagonal[0].norm(), e.diagonal[1].norm());
    if (longest * longest < tiny)
        return huge;
    return bounded(std::numbers::sqrt2 * e.shortest() / longest);
}

// 1 is planar: the cube of the cosine between normals of opposite corners.
double warpage(const Element &e) {
    std::array<Vector, 4> unit;
    for (std::size_t k = 0; k < 4; ++k) {
        unit[k] = direction(e.normal[k]);
        if (unit[k].isZero(0))
            return tiny;
    }
    const double cosine = std::min(unit[0].dot(unit[2]), unit[1].dot(unit[3]));
    return cosine * cosine * cosine;
}

double area(const Element &e) { return bounded(e.size * e.size * e.area()); }

// Knupp (2003): 1 at the mean area, smaller for elements above as below it.
double relative_size(const Element &e, double mean_area) {
    if (!(mean_area > 0))
        return 0;
    const double ratio = area(e) / mean_area;
    if (!(ratio > tiny))
        return 0;
    const double size = std::min(ratio, 1 / ratio);
    return size * size;
}

} // namespace

double measure(Metric metric, const Corners &quad, double mean_area) {
    const Element e(quad);
    switch (metric) {
    case Metric::area:
        return area(e);
    case Metric::aspect_ratio:
        return aspect_ratio(e);
    case Metric::condition:
        return condition(e);
    case Metric::distortion:
        return distortion(e);
    case Metric::edge_ratio:
        return edge_ratio(e);
    case Metric::jacobian:
        return jacobian(e);
    case Metric::max_angle:
        return max_angle(e);
    case Metric::min_angle:
        return min_angle(e);
    case Metric::oddy:
        return oddy(e);
    case Metric::radius_ratio:
        return radius_ratio(e);
    case Metric::relative_size:
        return relative_size(e, mean_area);
    case Metric::scaled_jacobian:
        return scaled_jacobian(e);
    case Metric::shape:
        return shape(e);
    case Metric::shape_and_size:
        return shape(e) * relative_size(e, mean_area);
    case Metric::shear:
        return shear(e);
    case Metric::shear_and_size:
        return shear(e) * relative_size(e, mean_area);
    case Metric::skew:
        return skew(e);
    case Metric::stretch:
        return stretch(e);
    case Metric::taper:
        return taper(e);
    case Metric::warpage:
        return warpage(e);
    }
    return -huge;
}

// The "acceptable" column of the Verdict manual.
Range acceptable_range(Metric metric) {
    switch (metric) {
    case Metric::area:
    case Metric::jacobian:
        return {0, huge};
    case Metric::aspect_ratio:
    case Metric::edge_ratio:
    case Metric::radius_ratio:
        return {1, 1.3};
    case Metric::condition:
        return {1, 4};
    case Metric::distortion:
        return {0.5, 1};
    case Metric::max_angle:
        return {90, 135};
    case Metric::min_angle:
        return {45, 90};
    case Metric::oddy:
    case Metric::skew:
        return {0, 0.5};
    case Metric::relative_size:
    case Metric::scaled_jacobian:
    case Metric::shape:
    case Metric::shear:
    case Metric::warpage:
        return {0.3, 1};
    case Metric::shape_and_size:
    case Metric::shear_and_size:
        return {0.2, 1};
    case Metric::stretch:
        return {0.25, 1};
    case Metric::taper:
        return {0, 0.7};
    }
    return {-huge, huge};
}

// Ideal values lie on the end of a range, so a rounding error is not held against them.
Summary summarise(Metric metric, std::span<const double> values) {
    Summary s;
    if (values.empty())
        return s;
    const Range range = acceptable_range(metric);
    const double slack = 1e-12 * std::max(1.0, std::min(std::abs(range.low), std::abs(range.high)));
    s.min = std::numeric_limits<double>::infinity();
    s.max = -s.min;
    for (const double value : values) {
        s.acceptable += value >= range.low - slack && value <= range.high + slack;
        s.min = std::min(s.min, value);
        s.max = std::max(s.max, value);
        ++s.count;
        s.mean += (value - s.mean) / static_cast<double>(s.count);
    }
    for (const double value : values)
        s.stddev += (value - s.mean) * (value - s.mean);
    s.stddev = std::sqrt(s.stddev / static_cast<double>(s.count));
    return s;
}

} // namespace alphamst::quality
