#include "geometry/cover.h"

#include <cmath>
#include <limits>

#include "geometry/pieces.h"
#include "index.h"
#include "surface/triangle.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

} // namespace

Cover::Cover(Quads quads, const Stars &stars, std::span<const Sample> samples)
    : quads_(quads), stars_(stars), samples_(samples.begin(), samples.end()), places_(samples.size()),
      of_quad_(quads.size()) {}

// The quad as two triangles along its shorter diagonal.
void Cover::measure(std::size_t sample, const SurfacePositions &on_surface) {
    Sample &mine = samples_[sample];
    Place &place = places_[sample];
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](int q) {
        const std::array<int, 4> &quad = quads_[alphamst::at(q)];
        const auto corner = [&](std::size_t k) { return on_surface.points[alphamst::at(quad[k])]; };
        const std::size_t first =
            (corner(2) - corner(0)).squaredNorm() <= (corner(3) - corner(1)).squaredNorm() ? 0 : 1;
        for (const std::size_t half : {std::size_t{0}, std::size_t{2}}) {
            const std::array<std::size_t, 3> k = {(first + half) % 4, (first + half + 1) % 4,
                                                  (first + half + 2) % 4};
            const surface::Closest found = surface::closest(
                mine.point, {corner(k[0]), corner(k[1]), corner(k[2])}, {quad[k[0]], quad[k[1]], quad[k[2]]});
            if (!(found.squared < least))
                continue;
            least = found.squared;
            mine.quad = q;
            place.weights = {};
            for (std::size_t i = 0; i < 3; ++i)
                place.weights[k[i]] = found.weights[static_cast<Eigen::Index>(i)];
            place.distance = std::sqrt(found.squared);
            place.normal = place.distance > 0 ? Vector3d((found.point - mine.point) / place.distance)
                                              : Vector3d(Vector3d::Zero());
        }
    };
    const std::array<int, 4> start = quads_[alphamst::at(mine.quad)];
    look(mine.quad);
    for (const int v : start)
        for (const Sector &sector : stars_.at(v))
            look(sector.quad);
}

void Cover::measure(const SurfacePositions &on_surface, const Run &run) {
    in_pieces(samples_.size(), run, [&](std::size_t s) { measure(s, on_surface); });
    for (std::vector<int> &list : of_quad_)
        list.clear();
    for (std::size_t s = 0; s < samples_.size(); ++s)
        of_quad_[alphamst::at(samples_[s].quad)].push_back(static_cast<int>(s));
}

} // namespace alphamst::geometry
