#include "smooth/settle.h"

#include <algorithm>

#include "index.h"

namespace alphamst::smooth {
namespace {

constexpr int most_rounds = 8; // three were the most that were seen to be needed

std::vector<double> scaled_jacobians(geometry::Quads quads, const geometry::Points &positions) {
    std::vector<double> least;
    for (std::size_t q = 0; q < quads.size(); ++q)
        least.push_back(geometry::shapes_of(quads.subspan(q, 1), positions).min_scaled_jacobian);
    return least;
}

} // namespace

void settle(geometry::Quads quads, std::vector<char> fixed, geometry::Points &positions,
            const geometry::WantedAreas &wanted, double weight, double enough,
            const geometry::EmbedOptions &options) {
    if (!geometry::shapes_of(quads, positions).valid)
        return;
    const std::vector<double> before = scaled_jacobians(quads, positions);
    for (int round = 0; round < most_rounds; ++round) {
        geometry::Points settled =
            geometry::match_areas(quads, fixed, positions, wanted, weight, options).positions;
        const std::vector<double> now = scaled_jacobians(quads, settled);
        bool spoiled = false;
        for (std::size_t q = 0; q < now.size(); ++q)
            if (now[q] < std::min(before[q], enough)) {
                spoiled = true; // the next time its vertices stay
                for (const int v : quads[q])
                    fixed[at(v)] = 1;
            }
        if (!spoiled) {
            positions = std::move(settled);
            return;
        }
    }
}

} // namespace alphamst::smooth
