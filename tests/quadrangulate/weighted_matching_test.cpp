#include "quadrangulate/weighted_matching.h"

#include <gtest/gtest.h>

#include <random>

namespace alphamst::quadrangulate {
namespace {

struct Value {
    int edges = 0;
    std::int64_t weight = 0;
    bool operator<(const Value &other) const {
        return edges != other.edges ? edges < other.edges : weight < other.weight;
    }
};

using Edges = std::vector<WeightedMatching::Edge>;

// By trying everything.
Value best(const Edges &edges, std::size_t first, unsigned taken) {
    if (first == edges.size())
        return {};
    Value value = best(edges, first + 1, taken);
    const unsigned both = 1U << edges[first].ends[0] | 1U << edges[first].ends[1];
    if ((taken & both) == 0) {
        Value with = best(edges, first + 1, taken | both);
        ++with.edges;
        with.weight += edges[first].weight;
        if (value < with)
            value = with;
    }
    return value;
}

// Also says whether it is one.
Value found(std::size_t n, const Edges &edges) {
    WeightedMatching matching(n, edges);
    matching.run();
    Value value;
    for (std::int32_t v = 0; v < std::int32_t(n); ++v) {
        const std::int32_t e = matching.edge_of(v);
        if (e < 0)
            continue;
        const auto [a, b] = edges[std::size_t(e)].ends;
        EXPECT_TRUE(v == a || v == b);
        EXPECT_EQ(matching.edge_of(v == a ? b : a), e);
        if (v == a) {
            ++value.edges;
            value.weight += edges[std::size_t(e)].weight;
        }
    }
    return value;
}

TEST(WeightedMatching, IsTheBest) {
    int perfect = 0, odd = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        const std::size_t n = 2 + random() % 11, m = n + random() % n;
        const std::int64_t range = seed % 2 == 0 ? 5 : 100000;
        Edges edges;
        for (std::size_t e = 0; e < m; ++e) {
            const auto v = std::int32_t(random() % n), w = std::int32_t(random() % n);
            if (v != w)
                edges.push_back({{v, w}, std::int64_t(random()) % range - range / 2});
        }
        const Value expected = best(edges, 0, 0), value = found(n, edges);
        EXPECT_EQ(value.edges, expected.edges) << seed;
        if (2 * std::size_t(expected.edges) == n) {
            ++perfect;
            EXPECT_EQ(value.weight, expected.weight) << seed;
        }
        odd += n % 2 == 1;
    }
    EXPECT_GT(perfect, 500);
    EXPECT_GT(odd, 500);
}

// Blossoms in blossoms: three pentagons around a triangle.
TEST(WeightedMatching, OddCyclesInOddCycles) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        Edges edges;
        const auto add = [&](int v, int w) {
            edges.push_back({{std::int32_t(v), std::int32_t(w)}, std::int64_t(random() % 50)});
        };
        for (int p = 0; p < 3; ++p) {
            for (int k = 0; k < 5; ++k)
                add(5 * p + k, 5 * p + (k + 1) % 5);
            add(5 * p, 5 * ((p + 1) % 3));
            add(5 * p + 2, 15);
        }
        const Value expected = best(edges, 0, 0), value = found(16, edges);
        EXPECT_EQ(value.edges, 8);
        EXPECT_EQ(value.weight, expected.weight) << seed;
    }
}

TEST(WeightedMatching, NoEdges) {
    WeightedMatching matching(3, {});
    matching.run();
    EXPECT_EQ(matching.edge_of(0), -1);
}

} // namespace
} // namespace alphamst::quadrangulate
