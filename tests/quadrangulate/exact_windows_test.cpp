#include "quadrangulate/exact_windows.h"

#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

// A cycle of nodes; edge e leads from node e to the next one.
TriangleDual cycle(int n) {
    const auto size = static_cast<std::size_t>(3 * n);
    TriangleDual dual{std::vector<std::int32_t>(size, TriangleDual::none), std::vector<float>(size),
                      std::vector<std::uint8_t>(size, TriangleDual::never)};
    for (int e = 0; e < n; ++e) {
        const int p = 3 * e, q = 3 * ((e + 1) % n) + 1;
        dual.across[std::size_t(p)] = q;
        dual.across[std::size_t(q)] = p;
        dual.stage[std::size_t(p)] = dual.stage[std::size_t(q)] = 0;
    }
    return dual;
}

void set(TriangleDual &dual, int e, std::uint8_t stage, float cost) {
    for (const std::int32_t p : {3 * e, dual.across[std::size_t(3 * e)]}) {
        dual.stage[std::size_t(p)] = stage;
        dual.cost[std::size_t(p)] = cost;
    }
}

void take_every_second(Matching &matching, int n, int first) {
    for (int e = first; e < n; e += 2) {
        matching.take(e, 0);
        matching.take((e + 1) % n, 1);
    }
}

// The other half of a cycle that is too long to be found by exchanging edges one by one.
TEST(ExactWindows, GoAroundLongCycles) {
    constexpr int n = 400;
    TriangleDual dual = cycle(n);
    for (int e = 1; e < n; e += 2)
        set(dual, e, 0, 5);
    set(dual, 0, 1, 1);
    Matching matching(dual);
    take_every_second(matching, n, 0);
    match_windows(dual, matching);
    EXPECT_EQ(matching.side(0), 1);
    EXPECT_EQ(matching.mate(0), n - 1);
}

// One edge of a stage outweighs any number of the one before.
TEST(ExactWindows, StagesCount) {
    constexpr int n = 40;
    TriangleDual dual = cycle(n);
    for (int e = 1; e < n; e += 2)
        set(dual, e, 1, 9);
    set(dual, 0, 2, 1);
    Matching matching(dual);
    take_every_second(matching, n, 0);
    match_windows(dual, matching);
    EXPECT_EQ(matching.mate(0), n - 1);
    set(dual, 1, 2, 2);
    take_every_second(matching, n, 1);
    match_windows(dual, matching);
    EXPECT_EQ(matching.mate(0), 1);
}

TEST(ExactWindows, WhatIsGoodStays) {
    TriangleDual dual = cycle(10);
    for (int e = 1; e < 10; e += 2)
        set(dual, e, 0, 5);
    Matching matching(dual);
    take_every_second(matching, 10, 1);
    match_windows(dual, matching);
    EXPECT_EQ(matching.mate(0), 9);
}

TEST(ExactWindows, NotAgainAroundWhatHasNotChanged) {
    constexpr int n = 40;
    TriangleDual dual = cycle(n);
    set(dual, 0, 1, 1);
    Matching matching(dual);
    take_every_second(matching, n, 0);
    match_windows(dual, matching, std::vector<std::int8_t>(n, 0));
    EXPECT_EQ(matching.mate(0), n - 1); // node 1 had side 0, and has 1
    take_every_second(matching, n, 0);
    match_windows(dual, matching, matching.sides());
    EXPECT_EQ(matching.mate(0), 1);
}

// As many lead outside as before, but where it is cheapest.
TEST(ExactWindows, OneLeadsOutside) {
    constexpr int n = 9;
    TriangleDual dual = cycle(n);
    for (int node = 0; node < n; ++node) {
        dual.across[std::size_t(3 * node + 2)] = TriangleDual::outside;
        dual.stage[std::size_t(3 * node + 2)] = 4;
        dual.cost[std::size_t(3 * node + 2)] = node == 4 ? 1 : 2;
    }
    Matching matching(dual);
    matching.take(0, 2);
    for (int e = 1; e < n; e += 2) {
        matching.take(e, 0);
        matching.take(e + 1, 1);
    }
    match_windows(dual, matching);
    for (int node = 0; node < n; ++node)
        EXPECT_EQ(matching.side(node) == 2, node == 4);
}

} // namespace
} // namespace alphamst::quadrangulate
