#include "quadrangulate/matching.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace alphamst::quadrangulate {
namespace {

// Nodes with at most three edges each, and of what is left some sides that lead outside.
TriangleDual random_graph(std::mt19937 &random, int n_nodes, int n_edges, int n_outside) {
    const auto size = static_cast<std::size_t>(3 * n_nodes);
    TriangleDual dual{std::vector<std::int32_t>(size, TriangleDual::none), std::vector<float>(size),
                      std::vector<std::uint8_t>(size, TriangleDual::never)};
    std::vector<std::int32_t> places(size);
    for (std::size_t p = 0; p < size; ++p)
        places[p] = static_cast<std::int32_t>(p);
    std::shuffle(places.begin(), places.end(), random);
    const auto take = [&] {
        const std::int32_t p = places.back();
        places.pop_back();
        return p;
    };
    for (int e = 0; e < n_edges; ++e) {
        const std::int32_t p = take(), q = take();
        if (p / 3 == q / 3)
            continue;
        for (const auto &[from, to] : {std::pair{p, q}, std::pair{q, p}}) {
            dual.across[static_cast<std::size_t>(from)] = to;
            dual.cost[static_cast<std::size_t>(from)] = static_cast<float>((7 * e) % 11);
            dual.stage[static_cast<std::size_t>(from)] = static_cast<std::uint8_t>(e % 3);
        }
    }
    for (int i = 0; i < n_outside; ++i) {
        const auto p = static_cast<std::size_t>(take());
        dual.across[p] = TriangleDual::outside;
        dual.stage[p] = 1;
    }
    return dual;
}

// The most nodes that can be matched, by trying everything.
int most_matched(const TriangleDual &dual, int stage, unsigned taken) {
    int node = 0;
    const auto n = static_cast<int>(dual.n_nodes());
    while (node < n && (taken >> node & 1) != 0)
        ++node;
    if (node == n)
        return 0;
    int most = most_matched(dual, stage, taken | 1u << node);
    for (int side = 0; side < 3; ++side) {
        const auto p = static_cast<std::size_t>(3 * node + side);
        const std::int32_t across = dual.across[p];
        if (across == TriangleDual::none || dual.stage[p] > stage)
            continue;
        if (across == TriangleDual::outside)
            most = std::max(most, 1 + most_matched(dual, stage, taken | 1u << node));
        else if ((taken >> (across / 3) & 1) == 0)
            most = std::max(most, 2 + most_matched(dual, stage, taken | 1u << node | 1u << (across / 3)));
    }
    return most;
}

struct Tally {
    int matched = 0;
    double cost = 0;
};

Tally tally(const TriangleDual &dual, const Matching &matching) {
    Tally result;
    for (int node = 0; node < static_cast<int>(dual.n_nodes()); ++node) {
        if (matching.side(node) < 0)
            continue;
        ++result.matched;
        result.cost +=
            static_cast<double>(dual.cost[static_cast<std::size_t>(3 * node + matching.side(node))]);
        if (const int mate = matching.mate(node); mate >= 0) {
            EXPECT_EQ(matching.mate(mate), node);
        }
    }
    return result;
}

TEST(Matching, IsOfLargestCardinalityAtEveryStage) {
    std::mt19937 random(1);
    int left_over = 0, later = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const int n = 4 + trial % 9;
        const TriangleDual dual = random_graph(random, n, (3 * n - trial % 3) / 2 - trial % 5, trial % 3);
        Matching matching(dual);
        matching.take_cheapest(0);
        int before = 0;
        for (std::uint8_t stage = 0; stage < 3; ++stage) {
            matching.augment(stage);
            const int matched = tally(dual, matching).matched;
            ASSERT_EQ(matched, most_matched(dual, stage, 0)) << "trial " << trial << " stage " << int(stage);
            later += stage > 0 && matched > before;
            before = matched;
        }
        left_over += before < n;
    }
    // Or nothing of this has been tried.
    EXPECT_GT(left_over, 100);
    EXPECT_GT(later, 100);
}

TEST(Matching, GetsCheaperAndNoSmaller) {
    std::mt19937 random(2);
    int cheaper = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const TriangleDual dual = random_graph(random, 30, 44, trial % 3);
        Matching matching(dual);
        matching.augment(2);
        const Tally before = tally(dual, matching);
        matching.improve();
        const Tally after = tally(dual, matching);
        ASSERT_EQ(after.matched, before.matched);
        ASSERT_LE(after.cost, before.cost);
        cheaper += after.cost < before.cost;
    }
    EXPECT_GT(cheaper, 250);
}

// A ring of hexagon shape has two matchings; the local search finds the cheaper one.
TEST(Matching, ExchangesTheEdgesOfACycle) {
    TriangleDual dual{std::vector<std::int32_t>(18, TriangleDual::none), std::vector<float>(18),
                      std::vector<std::uint8_t>(18, TriangleDual::never)};
    for (std::int32_t node = 0; node < 6; ++node) {
        const std::int32_t p = 3 * node, q = 3 * ((node + 1) % 6) + 1;
        for (const auto &[from, to] : {std::pair{p, q}, std::pair{q, p}}) {
            dual.across[static_cast<std::size_t>(from)] = to;
            dual.cost[static_cast<std::size_t>(from)] = node == 0 ? 1.0F : node % 2 == 0 ? 6.0F : 5.0F;
            dual.stage[static_cast<std::size_t>(from)] = 0;
        }
    }
    Matching matching(dual);
    matching.take_cheapest(0);
    matching.augment(0);
    matching.improve();
    EXPECT_EQ(tally(dual, matching).cost, 2 * (1 + 6 + 6));
    dual.cost[0] = dual.cost[4] = 4;
    matching.improve();
    EXPECT_EQ(tally(dual, matching).cost, 2 * (5 + 5 + 5));
}

} // namespace
} // namespace alphamst::quadrangulate
