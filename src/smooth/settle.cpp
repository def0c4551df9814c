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

std::optional<geometry::Points>
improve_without_spoiling(geometry::Quads quads, std::vector<char> &fixed,
                         const std::function<geometry::Points(std::span<const char> fixed)> &improve,
                         const std::function<std::vector<int>(const geometry::Points &)> &spoiled) {
    for (int round = 0; round < most_rounds; ++round) {
        geometry::Points improved = improve(fixed);
        const std::vector<int> bad = spoiled(improved);
        if (bad.empty())
            return improved;
        for (const int q : bad)
            for (const int v : quads[at(q)])
                fixed[at(v)] = 1;
    }
    return std::nullopt;
}

void settle(geometry::Quads quads, std::vector<char> fixed, geometry::Points &positions,
            const geometry::WantedAreas &wanted, double weight, double enough,
            const geometry::EmbedOptions &options) {
    if (!geometry::shapes_of(quads, positions).valid)
        return;
    const std::vector<double> before = scaled_jacobians(quads, positions);
    const auto spoiled = [&](const geometry::Points &settled) {
        const std::vector<double> now = scaled_jacobians(quads, settled);
        std::vector<int> bad;
        for (std::size_t q = 0; q < now.size(); ++q)
            if (now[q] < std::min(before[q], enough))
                bad.push_back(static_cast<int>(q));
        return bad;
    };
    auto settled = improve_without_spoiling(
        quads, fixed,
        [&](std::span<const char> held) {
            return geometry::match_areas(quads, held, positions, wanted, weight, options).positions;
        },
        spoiled);
    if (settled)
        positions = std::move(*settled);
}

} // namespace alphamst::smooth
