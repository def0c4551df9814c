#include "transfer/reconstruct.h"

#include <algorithm>
#include <utility>

#include "index.h"

namespace alphamst::transfer {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Neighbours whose spread across is below a thousandth of that along are a row: nothing is known across it.
constexpr double thin = 1e-6; // its square

} // namespace

Reconstruction::Reconstruction(const Cells &before, std::vector<Overlap> overlaps)
    : before_(before), overlaps_(std::move(overlaps)) {
    std::stable_sort(overlaps_.begin(), overlaps_.end(),
                     [](const Overlap &a, const Overlap &b) { return a.after < b.after; });
}

void Reconstruction::fit() {
    std::vector<int> stencil(at(before_.count()), -1);
    std::vector<std::optional<Vector3d>> centroids(stencil.size()); // those asked for
    for (const Overlap &overlap : overlaps_)
        stencil[at(overlap.before)] = 0;
    for (int cell = 0; cell < before_.count(); ++cell)
        if (stencil[at(cell)] == 0) {
            stencil[at(cell)] = static_cast<int>(stencils_.size());
            fit(cell, centroids);
        }
    stencil_of_.reserve(overlaps_.size());
    for (const Overlap &overlap : overlaps_)
        stencil_of_.push_back(at(stencil[at(overlap.before)]));
}

// Neighbours count by the inverse square of their distance.
void Reconstruction::fit(int cell, std::vector<std::optional<Vector3d>> &centroids) {
    const Cells::Place place = before_.place(cell);
    const Vector3d normal = place.normal.stableNormalized();
    const Vector3d across = normal.unitOrthogonal(), up = normal.cross(across);
    const std::size_t begin = neighbours_.size();
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    std::vector<Vector2d> pulls;
    for (const int other : before_.neighbours(cell)) {
        std::optional<Vector3d> &centroid = centroids[at(other)];
        if (!centroid)
            centroid = before_.place(other).centroid;
        const Vector3d away = *centroid - place.centroid;
        const Vector2d flat(across.dot(away), up.dot(away));
        const double square = flat.squaredNorm();
        neighbours_.push_back(other);
        pulls.push_back(square > 0 ? Vector2d(flat / square) : Vector2d::Zero());
        spread += pulls.back() * flat.transpose();
    }
    const double trace = spread.trace(), determinant = spread.determinant();
    Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
    if (determinant > thin * trace * trace)
        inverse = spread.inverse();
    else if (trace > 0)
        inverse = spread / (trace * trace);
    for (const Vector2d &pull : pulls) {
        const Vector2d weight = inverse * pull;
        weights_.emplace_back(across * weight[0] + up * weight[1]);
    }
    stencils_.push_back({cell, place.centroid, begin, neighbours_.size()});
}

std::vector<Reconstruction::Slope> Reconstruction::slopes(std::span<const double> from, std::size_t width,
                                                          std::size_t component) const {
    const auto value = [&](int cell) { return from[at(cell) * width + component]; };
    std::vector<Slope> slopes;
    for (const Stencil &stencil : stencils_) {
        const double mean = value(stencil.cell);
        Slope slope{Vector3d::Zero(), mean, mean};
        for (std::size_t i = stencil.begin; i < stencil.end; ++i) {
            const double other = value(neighbours_[i]);
            slope.low = std::min(slope.low, other);
            slope.high = std::max(slope.high, other);
            slope.gradient += (other - mean) * weights_[i];
        }
        if (!slope.gradient.allFinite()) // of values or of faces beyond all measure
            slope.gradient.setZero();
        slopes.push_back(slope);
    }
    std::vector<double> share(slopes.size(), 1);
    for (std::size_t i = 0; i < overlaps_.size(); ++i) {
        const std::size_t s = stencil_of_[i];
        const double mean = value(stencils_[s].cell),
                     rise = slopes[s].gradient.dot(overlaps_[i].centroid - stencils_[s].centroid);
        if (rise != 0)
            share[s] = std::min(share[s], ((rise > 0 ? slopes[s].high : slopes[s].low) - mean) / rise);
    }
    for (std::size_t s = 0; s < slopes.size(); ++s)
        slopes[s].gradient *= share[s];
    return slopes;
}

void Reconstruction::average(std::span<const double> from, std::span<double> to, int components,
                             bool linear) {
    const std::size_t width = at(components);
    if (linear && stencils_.empty())
        fit();
    for (std::size_t c = 0; c < width; ++c) {
        const std::vector<Slope> found = linear ? slopes(from, width, c) : std::vector<Slope>();
        const auto value = [&](std::size_t i) {
            const double mean = from[at(overlaps_[i].before) * width + c];
            if (!linear)
                return mean;
            const Slope &slope = found[stencil_of_[i]];
            const Vector3d away = overlaps_[i].centroid - stencils_[stencil_of_[i]].centroid;
            return std::clamp(mean + slope.gradient.dot(away), slope.low, slope.high);
        };
        for (std::size_t begin = 0, end; begin < overlaps_.size(); begin = end) {
            const int cell = overlaps_[begin].after;
            double sum = 0, area = 0, least = value(begin), largest = least;
            for (end = begin; end < overlaps_.size() && overlaps_[end].after == cell; ++end) {
                const double one = value(end);
                sum += overlaps_[end].area * one;
                area += overlaps_[end].area;
                least = std::min(least, one);
                largest = std::max(largest, one);
            }
            to[at(cell) * width + c] = std::clamp(sum / area, least, largest);
        }
    }
}

} // namespace alphamst::transfer
