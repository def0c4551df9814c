#include "surface/cross_field.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "index.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

constexpr Complex one{1, 0};

// The energy of crosses z: the sum over links of |z_i - coupling_ij z_j|^2 and the product with the guides.
struct Level {
    std::vector<std::size_t> begin; // [nodes + 1]
    std::vector<int> neighbours;
    std::vector<Complex> couplings;
    std::vector<Complex> guides; // [node]
    // What each node is merged into, and by what number that one's cross is multiplied to be its own.
    std::vector<int> parent;
    std::vector<Complex> lift;

    std::size_t size() const { return guides.size(); }
};

Level finest(const Links &links, std::span<const Guide> guides) {
    Level level;
    level.begin = links.begin;
    level.neighbours = links.neighbours;
    level.couplings.reserve(links.neighbours.size());
    level.guides.resize(links.frames.size());
    for (std::size_t i = 0; i < links.frames.size(); ++i)
        for (std::size_t k = links.begin[i]; k < links.begin[i + 1]; ++k) {
            const Complex turn = transport(links.frames[at(links.neighbours[k])], links.frames[i]);
            level.couplings.push_back(links.weights[k] * square(square(turn)));
        }
    for (const auto &[node, direction, weight] : guides) {
        const Complex along = unit(links.frames[at(node)].of(direction), {});
        level.guides[at(node)] += weight * square(square(along));
    }
    return level;
}

// Merges nodes in pairs, each with the free neighbour it is coupled to most (heavy edge matching, Karypis
// and Kumar 1998); one without a free neighbour joins the pair of another, so that each merged node has at
// least two, if it is not alone. Says how many there are.
int merge(Level &level) {
    const std::size_t n = level.size();
    level.parent.assign(n, -1);
    level.lift.assign(n, one);
    std::vector<std::size_t> alone;
    int merged = 0;
    const auto strongest = [&](std::size_t i, bool taken) {
        std::size_t best = level.begin[i + 1];
        double most = 0;
        for (std::size_t k = level.begin[i]; k < level.begin[i + 1]; ++k)
            if (const double strength = length(level.couplings[k]);
                strength > most && (level.parent[at(level.neighbours[k])] >= 0) == taken) {
                most = strength;
                best = k;
            }
        return best;
    };
    for (std::size_t i = 0; i < n; ++i) {
        if (level.parent[i] >= 0)
            continue;
        if (const std::size_t k = strongest(i, false); k < level.begin[i + 1]) {
            const std::size_t j = at(level.neighbours[k]);
            level.parent[i] = level.parent[j] = merged++;
            level.lift[j] = conjugate(unit(level.couplings[k], one));
        } else {
            alone.push_back(i);
        }
    }
    for (const std::size_t i : alone) {
        const std::size_t k = strongest(i, true);
        if (k == level.begin[i + 1]) {
            level.parent[i] = merged++;
            continue;
        }
        const std::size_t j = at(level.neighbours[k]);
        level.parent[i] = level.parent[j];
        level.lift[i] = unit(level.couplings[k], one) * level.lift[j];
    }
    return merged;
}

// The same energy for crosses that are lifted from merged nodes. But these change from one to the next as
// they would between their centres, not all at once across the links between them: couplings go down as nodes
// get farther apart (Braess 1995), or guides would have too little say.
Level coarser(const Level &fine, int merged) {
    const double nearness = std::sqrt(merged / static_cast<double>(fine.size()));
    Level coarse;
    coarse.guides.resize(at(merged));
    std::vector<std::size_t> first(at(merged) + 1);
    for (const int parent : fine.parent)
        ++first[at(parent) + 1];
    for (std::size_t p = 1; p < first.size(); ++p)
        first[p] += first[p - 1];
    std::vector<std::size_t> members(fine.size()), next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < fine.size(); ++i)
        members[next[at(fine.parent[i])]++] = i;

    std::vector<std::size_t> link(at(merged), SIZE_MAX); // to this node from the present one
    coarse.begin.reserve(at(merged) + 1);
    coarse.begin.push_back(0);
    for (std::size_t p = 0; p < at(merged); ++p) {
        for (std::size_t m = first[p]; m < first[p + 1]; ++m) {
            const std::size_t i = members[m];
            const Complex back = conjugate(fine.lift[i]);
            coarse.guides[p] += back * fine.guides[i];
            for (std::size_t k = fine.begin[i]; k < fine.begin[i + 1]; ++k) {
                const std::size_t j = at(fine.neighbours[k]);
                const int q = fine.parent[j];
                if (at(q) == p)
                    continue;
                if (link[at(q)] == SIZE_MAX || link[at(q)] < coarse.begin[p]) {
                    link[at(q)] = coarse.neighbours.size();
                    coarse.neighbours.push_back(q);
                    coarse.couplings.emplace_back();
                }
                coarse.couplings[link[at(q)]] += nearness * (back * fine.couplings[k] * fine.lift[j]);
            }
        }
        coarse.begin.push_back(coarse.neighbours.size());
    }
    return coarse;
}

void relax(const Level &level, std::vector<Complex> &crosses, int sweeps, const Pace &pace) {
    const auto accept_or_roll_back = [&](std::size_t i) {
        Complex sum = level.guides[i];
        for (std::size_t k = level.begin[i]; k < level.begin[i + 1]; ++k)
            sum += level.couplings[k] * crosses[at(level.neighbours[k])];
        crosses[i] = unit(sum, crosses[i]);
    };
    // To and fro, so that neither way is preferred.
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 0; i < level.size(); ++i) {
            pace.step();
            accept_or_roll_back(sweep % 2 == 0 ? i : level.size() - 1 - i);
        }
}

std::vector<Complex> solve(const Links &links, std::span<const Guide> guides, int sweeps, const Pace &pace) {
    std::vector<Level> levels;
    levels.push_back(finest(links, guides));
    for (;;) {
        pace.step(levels.back().size());
        const int merged = merge(levels.back());
        pace.step(levels.back().size());
        if (at(merged) == levels.back().size())
            break;
        levels.push_back(coarser(levels.back(), merged));
    }
    std::vector<Complex> crosses;
    for (const Complex guide : levels.back().guides)
        crosses.push_back(unit(guide, one));
    while (levels.size() > 1) {
        levels.pop_back();
        const Level &level = levels.back();
        std::vector<Complex> lifted(level.size());
        for (std::size_t i = 0; i < level.size(); ++i)
            lifted[i] = level.lift[i] * crosses[at(level.parent[i])];
        crosses = std::move(lifted);
        relax(level, crosses, sweeps, pace);
        pace.reach(1.0 / static_cast<double>(levels.size()));
    }
    return crosses;
}

} // namespace

std::vector<Vector3d> solve_cross_field(const Links &links, std::span<const Guide> guides, int sweeps,
                                        const Pace &pace) {
    const std::vector<Complex> crosses = solve(links, guides, sweeps, pace);
    std::vector<Vector3d> directions;
    directions.reserve(crosses.size());
    for (std::size_t i = 0; i < crosses.size(); ++i)
        directions.push_back(links.frames[i].at(half(half(crosses[i]))).normalized());
    return directions;
}

} // namespace alphamst::surface
