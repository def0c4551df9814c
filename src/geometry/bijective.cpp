#include <algorithm>
#include <numeric>

#include "geometry/parametrise.h"
#include "geometry/star.h"
#include "quality/corner.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector2d;

// Edges from a to b and from c to d have a point in common, or lie so that rounding cannot tell.
bool meet(const Vector2d &a, const Vector2d &b, const Vector2d &c, const Vector2d &d) {
    const double c_side = quality::determinant(b - a, c - a), d_side = quality::determinant(b - a, d - a);
    const double a_side = quality::determinant(d - c, a - c), b_side = quality::determinant(d - c, b - c);
    const bool apart = (c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0) ||
                       (a_side > 0 && b_side > 0) || (a_side < 0 && b_side < 0);
    return !apart;
}

// Edges from a to b and from b to c, the second back along the first.
bool turns_back(const Vector2d &a, const Vector2d &b, const Vector2d &c) {
    return quality::determinant(a - b, c - b) == 0 && (a - b).dot(c - b) >= 0;
}

} // namespace

bool is_simple(std::span<const Vector2d> loop) {
    const std::size_t n = loop.size();
    const auto end = [&](std::size_t edge) -> const Vector2d & { return loop[(edge + 1) % n]; };
    const auto low = [&](std::size_t edge) { return loop[edge].cwiseMin(end(edge)).eval(); };
    const auto high = [&](std::size_t edge) { return loop[edge].cwiseMax(end(edge)).eval(); };
    for (std::size_t i = 0; i < n; ++i)
        if (turns_back(loop[i], end(i), end((i + 1) % n)))
            return false;
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return low(a).x() < low(b).x(); });
    for (std::size_t i = 0; i < n; ++i) // from left to right, each with those that begin before it ends
        for (std::size_t j = i + 1; j < n && !(low(order[j]).x() > high(order[i]).x()); ++j) {
            const std::size_t a = order[i], b = order[j];
            if (low(b).y() > high(a).y() || low(a).y() > high(b).y())
                continue;
            const bool adjacent = (a + 1) % n == b || (b + 1) % n == a;
            if (!adjacent && meet(loop[a], end(a), loop[b], end(b)))
                return false;
        }
    return n >= 3;
}

// Where every triangle turns left each place is covered as often as the loop winds around it; a simple loop
// does so once.
bool is_bijective(Quads quads, int boundary, const Points &positions) {
    return shapes_of(quads, positions).valid &&
           is_simple({positions.data(), static_cast<std::size_t>(boundary)});
}

} // namespace alphamst::geometry
