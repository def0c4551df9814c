#include "adapt/expected_gain.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace alphamst::adapt {
namespace {

constexpr int faces = 3000;

// Searches in turn that save nothing, until it is no longer worth it; the effort that took.
double in_vain(int singular, int before = 1000) {
    ExpectedGain expected_gain(singular, before, faces, 400);
    double spent = 0;
    while (expected_gain.worthwhile(singular)) {
        ExpectedGain::Search &search = expected_gain.best();
        const double effort = singular * (search.wander + search.size);
        expected_gain.learn(search, 0, effort);
        spent += effort;
        if (spent > 1e9)
            break;
    }
    return spent;
}

TEST(ExpectedGain, TriesTheCheapestFirstAndAllInTheEnd) {
    ExpectedGain expected_gain(40, 1000, faces, 400);
    std::set<std::pair<int, int>> tried;
    for (int i = 0; i < 200; ++i) {
        ExpectedGain::Search &search = expected_gain.best();
        if (tried.empty()) {
            EXPECT_EQ(std::pair(search.wander, search.size), std::pair(16, 16));
        }
        tried.insert({search.wander, search.size});
        expected_gain.learn(search, 0, 40.0 * (search.wander + search.size));
    }
    EXPECT_EQ(tried.size(), 7u);
}

TEST(ExpectedGain, StaysWithWhatSaves) {
    ExpectedGain expected_gain(40, 1000, faces, 400);
    int large = 0;
    for (int i = 0; i < 100; ++i) {
        ExpectedGain::Search &search = expected_gain.best();
        const bool saves = search.size == 160;
        large += saves;
        expected_gain.learn(search, saves ? 2 : 0, 40.0 * (search.wander + search.size));
    }
    EXPECT_GT(large, 60);
}

TEST(ExpectedGain, NoWindowIsLargerThanTheLargest) {
    for (const int largest : {10, 100, 160, 200}) {
        ExpectedGain expected_gain(40, 1000, faces, largest);
        for (int i = 0; i < 100; ++i) {
            ExpectedGain::Search &search = expected_gain.best();
            EXPECT_LE(search.size, largest);
            expected_gain.learn(search, 0, 40.0 * (search.wander + search.size));
        }
    }
}

TEST(ExpectedGain, TheFewerThereAreTheLongerItGoesOn) {
    EXPECT_GT(in_vain(16), 1.5 * in_vain(24));
    EXPECT_GT(in_vain(24), 2 * in_vain(30));
    EXPECT_GT(in_vain(30), 1.1 * in_vain(50));
    EXPECT_LT(in_vain(16), 250.0 * faces);
    EXPECT_LT(in_vain(200), 40.0 * faces);
    EXPECT_GT(in_vain(1), 0);
}

TEST(ExpectedGain, MoreThanThereWereAreWorthMore) {
    EXPECT_EQ(in_vain(60, 60), in_vain(60));
    EXPECT_GT(in_vain(60, 59), 1.5 * in_vain(60));
}

TEST(ExpectedGain, ManyAreWorthItWhileTheyBecomeFewer) {
    ExpectedGain expected_gain(400, 1000, faces, 400);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(expected_gain.worthwhile(400)) << i;
        ExpectedGain::Search &search = expected_gain.best();
        expected_gain.learn(search, 0.02 * 400, 400.0 * (search.wander + search.size));
    }
    int more = 0;
    for (; more < 1000 && expected_gain.worthwhile(400); ++more)
        expected_gain.learn(expected_gain.best(), 0, 400.0 * 32);
    EXPECT_LT(more, 100);
}

TEST(ExpectedGain, WithLessEffortEndsSooner) {
    const auto tries = [](double effort) {
        ExpectedGain expected_gain(40, 40, faces, 400, effort);
        int count = 0;
        for (; expected_gain.worthwhile(40); ++count)
            expected_gain.learn(expected_gain.best(), 0, 100);
        return count;
    };
    EXPECT_LT(3 * tries(0.2), tries(1));
    EXPECT_GT(tries(3), 2 * tries(1));
}

} // namespace
} // namespace alphamst::adapt
