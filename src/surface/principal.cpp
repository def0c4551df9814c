#include "surface/principal.h"

#include <Eigen/LU>
#include <utility>

#include "stop.h"

namespace alphamst::surface {

Complex deviation(const Frame &frame, std::span<const Bend> bends) {
    // Unknown are the elements e, f, g of the form: (e f; f g) * way = change.
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Bend &bend : bends) {
        const auto [x, y] = frame.of(bend.way);
        const auto [nx, ny] = frame.of(bend.change);
        matrix(0, 0) += x * x;
        matrix(0, 1) += x * y;
        matrix(2, 2) += y * y;
        right += Eigen::Vector3d(x * nx, x * ny + y * nx, y * ny);
    }
    matrix(1, 1) = matrix(0, 0) + matrix(2, 2);
    matrix(1, 0) = matrix(1, 2) = matrix(2, 1) = matrix(0, 1);
    const double size = matrix(1, 1);
    if (!(matrix.determinant() > 1e-9 * size * size * size))
        return {};
    const Eigen::Vector3d form = matrix.inverse() * right;
    return {(form[0] - form[2]) / 2, form[1]};
}

void average(const Links &links, std::vector<Complex> &deviations, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        std::vector<Complex> averages(deviations.size());
        for (std::size_t i = 0; i < deviations.size(); ++i) {
            Stop::point();
            Complex sum;
            const std::size_t n = links.begin[i + 1] - links.begin[i];
            for (std::size_t k = links.begin[i]; k < links.begin[i + 1]; ++k) {
                const auto j = static_cast<std::size_t>(links.neighbours[k]);
                sum += square(transport(links.frames[j], links.frames[i])) * deviations[j];
            }
            averages[i] = n == 0 ? deviations[i] : 0.5 * (deviations[i] + (1 / static_cast<double>(n)) * sum);
        }
        deviations = std::move(averages);
    }
}

} // namespace alphamst::surface
