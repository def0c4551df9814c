#include "geometry/match_areas.h"

#include <algorithm>
#include <numeric>

#include "geometry/improve.h"
#include "geometry/newton.h"
#include "quality/corner.h"

namespace alphamst::geometry {
namespace {

// Quads move as they get their areas, and what is wanted where they lie then differs: so many times. The
// third still gains a tenth of the error, a fourth nothing.
constexpr int rounds = 3;
constexpr int steps = 6; // of Newton's method in each

constexpr double squeezed = 0.05; // a corner, over the wanted area: below, Newton's steps are short
constexpr int most_iterations = 12;

// The barrier is so steep next to a corner that is hardly positive that it would stay so: there the
// regularised one first makes room.
void open_squeezed(const Problem &problem, const FreeRegion &region, Newton &newton, Points &positions) {
    const double before = worst_determinant(problem, region.quads, positions);
    if (before > squeezed)
        return;
    Points opened = positions;
    int iterations = most_iterations;
    newton.untangle(opened, iterations, squeezed);
    if (worst_determinant(problem, region.quads, opened) > before)
        positions = std::move(opened);
}

} // namespace

double signed_area(const std::array<int, 4> &quad, const Points &positions) {
    const auto at = [&](std::size_t k) { return positions[static_cast<std::size_t>(quad[k])]; };
    return quality::determinant(at(2) - at(0), at(3) - at(1)) / 2;
}

Embedding match_areas(Quads quads, std::span<const char> fixed, Points positions, const WantedAreas &wanted,
                      double weight, const EmbedOptions &options) {
    const Stars stars(quads, static_cast<int>(positions.size()));
    double total = 0;
    for (const auto &q : quads)
        total += signed_area(q, positions);
    std::vector<double> areas(quads.size(), total);
    const Problem problem{quads, stars, fixed, areas};
    std::vector<int> all(quads.size());
    std::iota(all.begin(), all.end(), 0);
    const FreeRegion region(problem, all, 0);
    const auto renew = [&](const Points &now) {
        const std::vector<double> there = wanted(now);
        const double sum = std::accumulate(there.begin(), there.end(), 0.0);
        std::transform(there.begin(), there.end(), areas.begin(),
                       [&](double area) { return area * total / sum; });
    };
    renew(positions);
    Newton newton(problem, region);
    open_squeezed(problem, region, newton, positions);
    newton.minimise(positions, {weight, rounds, steps, renew});
    sharpen_corners(problem, positions, options, 0);
    return judge(quads, std::move(positions));
}

} // namespace alphamst::geometry
