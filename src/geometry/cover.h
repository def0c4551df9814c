// How far a surface is from the quads that are to cover it, at samples of the surface.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "geometry/star.h"
#include "geometry/surface_positions.h"

namespace alphamst::geometry {

// A point of the surface, and the quad that is nearest to it or about so.
struct Sample {
    Eigen::Vector3d point;
    int quad;
};

class Cover {
public:
    struct Place {              // the point of the quad that is nearest to a sample
        Eigen::Vector3d normal; // the way to it from the sample
        double distance;
        std::array<double, 4> weights; // of the corners
    };

    Cover(Quads quads, const Stars &stars, std::span<const Sample> samples);

    // Where the quads are now. Samples go over to quads around theirs that are nearer. `run` as in
    // EmbedOptions.
    void measure(const SurfacePositions &on_surface, const Run &run);

    std::size_t size() const { return samples_.size(); }
    // The places on a quad, by number.
    std::span<const int> at(std::size_t quad) const { return of_quad_[quad]; }
    const Place &place(int i) const { return places_[static_cast<std::size_t>(i)]; }

private:
    void measure(std::size_t sample, const SurfacePositions &on_surface);

    const Quads quads_;
    const Stars &stars_;
    std::vector<Sample> samples_;
    std::vector<Place> places_;             // [sample]
    std::vector<std::vector<int>> of_quad_; // samples
};

} // namespace alphamst::geometry
