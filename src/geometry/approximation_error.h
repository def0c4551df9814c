// How far quads are from the surface that their vertices lie on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "geometry/surface_positions.h"

namespace alphamst::geometry {

// Places spread over the quads, each quad taken as two triangles along its shorter diagonal, and the signed
// distance of each place along the normal of the surface at its nearest point: near the surface what is left
// is the distance to the plane that touches it there (Chen and Medioni 1992).
class ApproximationError {
public:
    static constexpr std::size_t places = 8; // of a quad
    struct Place {
        Eigen::Vector3d normal;
        double distance;
        std::array<double, 4> weights; // of the corners
        int surface_triangle;          // triangle of the surface
    };

    ApproximationError(const surface::Surface &surface, Quads quads, const SurfacePositions &on_surface);

    // Where the quads are now. `run` as in EmbedOptions.
    void measure(const SurfacePositions &on_surface, const Run &run);

    std::span<const Place> at(std::size_t quad) const { return places_[quad]; }
    double area(std::size_t quad) const { return area_[quad]; }
    double mean_area() const { return mean_area_; }
    // Of a quad, and of all by area.
    double mean_square(std::size_t quad) const;
    double mean_square() const;

private:
    void measure(std::size_t quad, const SurfacePositions &on_surface);

    const surface::Surface &surface_;
    const Quads quads_;
    std::vector<std::array<Place, places>> places_;
    std::vector<double> area_;
    double mean_area_ = 0;
};

} // namespace alphamst::geometry
