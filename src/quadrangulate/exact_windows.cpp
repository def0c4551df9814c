#include "quadrangulate/exact_windows.h"

#include <algorithm>
#include <cmath>

#include "index.h"
#include "quadrangulate/weighted_matching.h"

namespace alphamst::quadrangulate {
namespace {

// Costs are below 10 but for the penalties of stages, which all edges of one have, and windows below a
// thousand nodes, so that with a unit of 1/1000 one edge of a stage outweighs all that smaller stages can
// save.
constexpr double unit = 1000;
constexpr std::array<std::int64_t, TriangleDual::stages> weight_of_stage{0, 10'000'000, 300'000'000,
                                                                         10'000'000'000, 10'000'000'000};
// Nodes of windows. So many of each are tried, and one more for so many nodes: the time they
// take grows with about the square of their size, and shall stay below that of the matching.
constexpr std::array<std::size_t, 3> sizes{48, 192, 768};
constexpr std::array<std::size_t, 3> least_windows{500, 100, 30};
constexpr std::array<std::size_t, 3> nodes_per_window{50, 300, 10000};

class Windows {
public:
    Windows(const TriangleDual &dual, Matching &matching)
        : dual_(dual), matching_(matching), place_(dual.n_nodes(), -1), seen_(dual.n_nodes()) {}

    void run(std::span<const std::int8_t> sides_before) {
        std::vector<std::int32_t> due;
        for (std::size_t p = 0; p < dual_.across.size(); p += 3)
            if (const auto node = static_cast<std::int32_t>(p / 3);
                is_bad(node) && has_edges(p) &&
                (sides_before.empty() || sides_before[at(node)] != matching_.side(node)))
                due.push_back(node);
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            std::erase_if(due, [&](std::int32_t node) { return !is_bad(node); });
            std::size_t n = 0;
            for (const std::int32_t node : due)
                if (is_bad(node) && seen_[at(node)] <= i && n < most_windows(i)) {
                    solve(node, sizes[i]);
                    ++n;
                    const bool is_all = nodes_.size() < sizes[i]; // that are connected
                    for (const std::int32_t inside : nodes_)
                        seen_[at(inside)] = static_cast<std::uint8_t>(is_all ? sizes.size() : i + 1);
                }
        }
    }

private:
    std::size_t most_windows(std::size_t i) const {
        return least_windows[i] + dual_.n_nodes() / nodes_per_window[i];
    }

    bool has_edges(std::size_t first) const {
        return std::any_of(dual_.stage.begin() + static_cast<std::ptrdiff_t>(first),
                           dual_.stage.begin() + static_cast<std::ptrdiff_t>(first) + 3,
                           [](std::uint8_t stage) { return stage != TriangleDual::never; });
    }

    struct Value {
        std::size_t matched = 0;
        std::int64_t cost = 0;
        bool operator<(const Value &other) const {
            return matched != other.matched ? matched < other.matched : cost > other.cost;
        }
    };

    std::size_t place(std::int32_t node, int side) const { return 3 * at(node) + at(side); }

    bool is_bad(std::int32_t node) const {
        const int side = matching_.side(node);
        return side < 0 || dual_.stage[place(node, side)] > 0;
    }

    std::int64_t cost(std::size_t place) const {
        return std::llround(static_cast<double>(dual_.cost[place]) * unit) +
               weight_of_stage[dual_.stage[place]];
    }

    // Around a node; with every node its mate is there.
    void gather(std::int32_t first, std::size_t size) {
        nodes_.clear();
        const auto add = [&](std::int32_t node) {
            if (node >= 0 && place_[at(node)] < 0) {
                place_[at(node)] = static_cast<std::int32_t>(nodes_.size());
                nodes_.push_back(node);
            }
        };
        add(first);
        for (std::size_t head = 0; head < nodes_.size() && nodes_.size() < size; ++head)
            for (int side = 0; side < 3; ++side)
                if (const std::size_t p = place(nodes_[head], side);
                    dual_.stage[p] != TriangleDual::never && dual_.across[p] >= 0)
                    add(dual_.across[p] / 3);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            add(matching_.mate(nodes_[i]));
    }

    void solve(std::int32_t first, std::size_t size) {
        gather(first, size);
        const auto outside = static_cast<std::int32_t>(nodes_.size());
        Value before, after;
        bool leaves = false;
        for (const std::int32_t node : nodes_)
            if (const int side = matching_.side(node); side >= 0) {
                const std::size_t p = place(node, side);
                const bool out = dual_.across[p] < 0;
                leaves = leaves || out;
                if (out || dual_.across[p] > static_cast<std::int32_t>(p)) {
                    ++before.matched;
                    before.cost += cost(p);
                }
            }
        std::vector<WeightedMatching::Edge> edges;
        std::vector<std::size_t> places;
        for (std::int32_t i = 0; i < outside; ++i)
            for (int side = 0; side < 3; ++side) {
                const std::size_t p = place(nodes_[at(i)], side);
                const std::int32_t across = dual_.across[p];
                if (dual_.stage[p] == TriangleDual::never || across == TriangleDual::none)
                    continue;
                const std::int32_t j = across >= 0 ? place_[at(across / 3)] : leaves ? outside : -1;
                if (j > i) {
                    edges.push_back({{i, j}, -cost(p)});
                    places.push_back(p);
                }
            }
        WeightedMatching best(nodes_.size() + (leaves ? 1 : 0), edges);
        best.run();
        for (std::int32_t i = 0; i < outside; ++i)
            if (const std::int32_t e = best.edge_of(i); e >= 0 && edges[at(e)].ends[0] == i) {
                ++after.matched;
                after.cost += cost(places[at(e)]);
            }
        if (before < after)
            take(best, places);
        for (const std::int32_t node : nodes_)
            place_[at(node)] = -1;
    }

    void take(const WeightedMatching &best, const std::vector<std::size_t> &places) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const std::int32_t e = best.edge_of(static_cast<std::int32_t>(i));
            if (e < 0) {
                matching_.take(nodes_[i], -1);
                continue;
            }
            const std::size_t p = places[at(e)];
            const std::int32_t other = dual_.across[p];
            const bool is_first = static_cast<std::int32_t>(p / 3) == nodes_[i];
            matching_.take(nodes_[i], is_first ? static_cast<int>(p % 3) : other % 3);
        }
    }

    const TriangleDual &dual_;
    Matching &matching_;
    std::vector<std::int32_t> place_; // of each node in the window, -1: not in it
    std::vector<std::int32_t> nodes_;
    std::vector<std::uint8_t> seen_; // of each node: windows of so many sizes need not begin there any more
};

} // namespace

void match_windows(const TriangleDual &dual, Matching &matching, std::span<const std::int8_t> sides_before) {
    Windows(dual, matching).run(sides_before);
}

} // namespace alphamst::quadrangulate
