#include "geometry/approximation_error.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "geometry/pieces.h"
#include "index.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

// The middles of the four triangles that a triangle is halved into.
constexpr double sixth = 1.0 / 6, third = 1.0 / 3;
constexpr std::array<std::array<double, 3>, 4> middles = {
    {{4 * sixth, sixth, sixth}, {sixth, 4 * sixth, sixth}, {sixth, sixth, 4 * sixth}, {third, third, third}}};

constexpr double straight = 0.999; // cosine between a normal and the way from the surface

} // namespace

ApproximationError::ApproximationError(const surface::Surface &surface, Quads quads,
                                       const SurfacePositions &on_surface)
    : surface_(surface), quads_(quads), places_(quads.size()), area_(quads.size(), 0) {
    for (std::size_t q = 0; q < quads.size(); ++q)
        for (Place &place : places_[q])
            place.surface_triangle = on_surface.surface_triangles[alphamst::at(quads[q][0])];
}

void ApproximationError::measure(std::size_t quad, const SurfacePositions &on_surface) {
    std::array<Vector3d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k)
        corners[k] = on_surface.points[alphamst::at(quads_[quad][k])];
    const Vector3d diagonals[] = {corners[2] - corners[0], corners[3] - corners[1]};
    area_[quad] = diagonals[0].cross(diagonals[1]).norm() / 2;
    const std::size_t first = diagonals[0].squaredNorm() <= diagonals[1].squaredNorm() ? 0 : 1;
    for (std::size_t i = 0; i < places; ++i) {
        Place &place = places_[quad][i];
        place.weights = {};
        Vector3d point = Vector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t corner = (first + 2 * (i / middles.size()) + k) % 4;
            place.weights[corner] = middles[i % middles.size()][k];
            point += place.weights[corner] * corners[corner];
        }
        const surface::Spot spot = surface_.follow(point, place.surface_triangle);
        const Vector3d away = point - spot.point;
        place.surface_triangle = spot.triangle;
        place.normal = surface_.normal(spot.triangle);
        place.distance = away.dot(place.normal);
        // Above an edge or a point of the surface the way to it is along no normal of a triangle.
        if (const double length = away.norm(); std::abs(place.distance) < straight * length) {
            place.distance = place.distance < 0 ? -length : length;
            place.normal = away / place.distance;
        }
    }
}

void ApproximationError::measure(const SurfacePositions &on_surface, const Run &run) {
    in_pieces(quads_.size(), run, [&](std::size_t q) { measure(q, on_surface); });
    mean_area_ = std::accumulate(area_.begin(), area_.end(), 0.0) / static_cast<double>(area_.size());
}

double ApproximationError::mean_square(std::size_t quad) const {
    double sum = 0;
    for (const Place &place : places_[quad])
        sum += place.distance * place.distance;
    return sum / static_cast<double>(places);
}

double ApproximationError::mean_square() const {
    double sum = 0;
    for (std::size_t q = 0; q < quads_.size(); ++q)
        sum += area_[q] * mean_square(q);
    return sum / (mean_area_ * static_cast<double>(quads_.size()));
}

} // namespace alphamst::geometry
