#include "fill/start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "fill/library.h"

namespace {

using namespace alphamst::fill;

// Whether any multiplicities have these side lengths.
bool possible(const Layout &type, const Sides &sides, Multiplicities &x, std::size_t j = 0) {
    const std::vector<int> lengths = side_lengths(type, x);
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (lengths[i] > sides[i])
            return false;
    if (j == x.size())
        return lengths == sides;
    for (x[j] = 1; x[j] <= 8; ++x[j])
        if (possible(type, sides, x, j + 1))
            return true;
    x[j] = 1;
    return false;
}

TEST(Start, EveryChordHasItsTurnWithTheSidesItEndsOn) {
    for (const int n : {3, 4, 5, 6})
        for (const Layout &type : types(n, n == 3 || n == 5 ? 1 : 2)) {
            const std::vector<Layout::Turn> order = start_order(type);
            ASSERT_EQ(order.size(), static_cast<std::size_t>(type.chords));
            std::set<std::size_t> chords;
            for (std::size_t p = 0; p < order.size(); ++p) {
                chords.insert(order[p].chord);
                std::size_t ends = 0;
                for (const std::vector<int> &side : type.incidence)
                    ends += side[order[p].chord] != 0;
                EXPECT_EQ(order[p].ends.size(), ends);
                for (const auto &end : order[p].ends) {
                    EXPECT_EQ(end.count, type.incidence[end.side][order[p].chord]);
                    int later = 0;
                    for (std::size_t q = p + 1; q < order.size(); ++q)
                        later += type.incidence[end.side][order[q].chord] != 0;
                    EXPECT_EQ(end.later, later);
                }
            }
            EXPECT_EQ(chords.size(), order.size());
        }
}

TEST(Start, TheTightestSideComesFirst) {
    Layout type;
    type.chords = 4;
    type.incidence = {{1, 1, 1, 0}, {0, 1, 0, 1}, {1, 0, 1, 1}};
    std::vector<std::size_t> chords;
    for (const Layout::Turn &turn : start_order(type))
        chords.push_back(turn.chord);
    EXPECT_EQ(chords, (std::vector<std::size_t>{1, 3, 0, 2}));
}

TEST(Start, HasTheSideLengthsAndFindsThemWhereThereAreAny) {
    std::mt19937 random(51);
    int found = 0, missed = 0, none = 0;
    for (int round = 0; round < 400; ++round) {
        const int n = 3 + round % 4;
        const std::vector<Layout> &all = types(n, n == 3 || n == 5 ? 1 : 2);
        const Layout &type = all[random() % all.size()];
        Sides sides;
        for (int i = 0; i < n; ++i)
            sides.push_back(2 + static_cast<int>(random() % 7));
        Multiplicities x(static_cast<std::size_t>(type.chords), 1);
        const bool any = possible(type, sides, x);
        const auto first = start(type, sides);
        if (first) {
            ++found;
            EXPECT_EQ(side_lengths(type, *first), sides);
            EXPECT_GE(*std::min_element(first->begin(), first->end()), 1);
            EXPECT_TRUE(any);
        }
        missed += any && !first;
        none += !any;
    }
    EXPECT_GT(found, 20);
    EXPECT_GT(none, 20);
    EXPECT_EQ(missed, 0);
}

} // namespace
