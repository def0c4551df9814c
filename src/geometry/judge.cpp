#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/star.h"
#include "quality/corner.h"

namespace alphamst::geometry {

Judgement shapes_of(Quads quads, const Points &positions) {
    Judgement result;
    double determinant = std::numeric_limits<double>::infinity(), jacobian = 1, shape = 1;
    for (const auto &quad : quads) {
        Eigen::Vector2d edge[4]; // from corner k to corner k+1
        double length[4];
        for (std::size_t k = 0; k < 4; ++k) {
            edge[k] = positions[static_cast<std::size_t>(quad[(k + 1) % 4])] -
                      positions[static_cast<std::size_t>(quad[k])];
            length[k] = edge[k].norm();
        }
        double worst = 1, sine = 1;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t before = (k + 3) % 4;
            const double d = quality::determinant(edge[before], edge[k]),
                         lengths = length[before] * length[k];
            // Not std::min: a NaN has to win.
            if (!(d >= determinant))
                determinant = d;
            if (const double s = quality::scaled_jacobian(d, lengths); !(s >= sine))
                sine = s;
            const double squares = length[before] * length[before] + length[k] * length[k];
            if (const double s = quality::corner_shape(d, squares); !(s >= worst))
                worst = s;
        }
        if (!(worst >= shape))
            shape = worst;
        if (!(sine >= jacobian))
            jacobian = sine;
        result.inverted += !(sine > 0);
        result.poor += !acceptable(sine, worst);
    }
    result.valid = determinant > 0 && jacobian > 0;
    result.min_determinant = quads.empty() ? 0 : determinant;
    result.min_scaled_jacobian = quads.empty() ? 0 : jacobian;
    result.min_shape = quads.empty() ? 0 : shape;
    return result;
}

Embedding judge(Quads quads, Points positions) {
    Embedding result;
    static_cast<Judgement &>(result) = shapes_of(quads, positions);
    result.positions = std::move(positions);
    return result;
}

} // namespace alphamst::geometry
