#include <cmath>
#include <limits>

#include "geometry/corner.h"
#include "geometry/parametrise.h"
#include "geometry/star.h"
#include "index.h"
#include "quality/corner.h"

namespace alphamst::geometry {
namespace {

// Of one quad: its area in space, in the plane, and the first times the square of its stretch.
struct Share {
    double area = 0, flat_area = 0, stretched = 0;
};

Share share_of(const std::array<int, 4> &quad, const Disk &disk, const Points &positions) {
    Share share;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [a, b, c] = corner_of(quad, k);
        const FlatTriangle triangle(disk.points[at(a)], disk.points[at(b)], disk.points[at(c)]);
        const Eigen::Vector2d side = positions[at(b)] - positions[at(a)];
        const Eigen::Vector2d other = positions[at(c)] - positions[at(a)];
        const double determinant = quality::determinant(side, other);
        share.area += triangle.twice_area / 4;
        share.flat_area += determinant / 4;
        // The derivative of the map from the plane to the triangle, columns of it times the determinant.
        const Eigen::Vector2d s = triangle.second * other.y() - triangle.third * side.y();
        const Eigen::Vector2d t = triangle.third * side.x() - triangle.second * other.x();
        const double square = (s.squaredNorm() + t.squaredNorm()) / (2 * determinant * determinant);
        share.stretched +=
            determinant > 0 ? triangle.twice_area / 4 * square : std::numeric_limits<double>::infinity();
    }
    return share;
}

} // namespace

double stretch(const Disk &disk, const Points &positions) {
    Share sum;
    for (const auto &quad : disk.quads) {
        const Share share = share_of(quad, disk, positions);
        sum.area += share.area;
        sum.flat_area += share.flat_area;
        sum.stretched += share.stretched;
    }
    return std::sqrt(sum.stretched / sum.area * (sum.flat_area / sum.area));
}

std::vector<double> vertex_stretch(const Disk &disk, const Points &positions) {
    std::vector<double> area(positions.size(), 0.0), stretched(positions.size(), 0.0);
    for (const auto &quad : disk.quads) {
        const Share share = share_of(quad, disk, positions);
        for (const int v : quad) {
            area[at(v)] += share.area;
            stretched[at(v)] += share.stretched;
        }
    }
    for (std::size_t v = 0; v < area.size(); ++v)
        stretched[v] = std::sqrt(stretched[v] / area[v]);
    return stretched;
}

} // namespace alphamst::geometry
