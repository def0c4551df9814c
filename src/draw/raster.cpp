#include "draw/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alphamst::draw {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

// Twice the area of a, b and c as seen by the eye.
double area(const Vector3 &a, const Vector3 &b, const Vector3 &c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

} // namespace

Raster::Raster(const io::Arrays &mesh, const std::vector<Vector3> &points, double width, double height,
               double cell)
    : cell_(cell), columns_(std::llround(std::ceil(width / cell)) + 1),
      rows_(std::llround(std::ceil(height / cell)) + 1),
      depths_(static_cast<std::size_t>(columns_ * rows_), nothing),
      faces_(static_cast<std::size_t>(columns_ * rows_), -1) {
    for (std::size_t f = 0; f < mesh.faces.size() / 4; ++f) {
        std::array<Vector3, 4> p;
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = points[static_cast<std::size_t>(mesh.faces[4 * f + k])];
        lay({p[0], p[1], p[2]}, static_cast<std::int32_t>(f));
        lay({p[0], p[2], p[3]}, static_cast<std::int32_t>(f));
    }
}

std::int64_t Raster::column(double x) const {
    return std::clamp<std::int64_t>(std::llround(x / cell_), 0, columns_ - 1);
}

std::int64_t Raster::row(double y) const {
    return std::clamp<std::int64_t>(std::llround(y / cell_), 0, rows_ - 1);
}

void Raster::lay(const std::array<Vector3, 3> &triangle, std::int32_t face) {
    const auto &[a, b, c] = triangle;
    const double whole = area(a, b, c);
    if (whole == 0)
        return;
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [low, high] = std::minmax({a[1], b[1], c[1]});
    for (std::int64_t j = row(low); j <= row(high); ++j)
        for (std::int64_t i = column(left); i <= column(right); ++i) {
            const Vector3 at{static_cast<double>(i) * cell_, static_cast<double>(j) * cell_, 0};
            const double u = area(b, c, at) / whole, v = area(c, a, at) / whole, w = 1 - u - v;
            if (u < 0 || v < 0 || w < 0)
                continue;
            const double depth = u * a[2] + v * b[2] + w * c[2];
            const auto place = static_cast<std::size_t>(j * columns_ + i);
            if (depth > depths_[place]) {
                depths_[place] = depth;
                faces_[place] = face;
            }
        }
}

std::int64_t Raster::covered() const {
    return std::count_if(faces_.begin(), faces_.end(), [](std::int32_t face) { return face >= 0; });
}

std::vector<bool> Raster::nearest(std::size_t n_faces) const {
    std::vector<bool> is_nearest(n_faces, false);
    for (std::int32_t face : faces_)
        if (face >= 0)
            is_nearest[static_cast<std::size_t>(face)] = true;
    return is_nearest;
}

bool Raster::shows(const Vector3 &point) const {
    // On a visible slope one of the cells around is no nearer than the point. In a dent all are, by as
    // much as it is steep.
    const double steep = 4 * cell_;
    const std::int64_t i = column(point[0]), j = row(point[1]);
    for (std::int64_t y = j - 1; y <= j + 1; ++y)
        for (std::int64_t x = i - 1; x <= i + 1; ++x)
            if (x < 0 || y < 0 || x >= columns_ || y >= rows_ ||
                depths_[static_cast<std::size_t>(y * columns_ + x)] <= point[2] + steep)
                return true;
    return false;
}

} // namespace alphamst::draw
