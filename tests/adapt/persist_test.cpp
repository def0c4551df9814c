#include "adapt/persist.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace alphamst::adapt {
namespace {

constexpr int faces = 3000;

// Searches in turn that save nothing, until it is no longer worth it; the effort that took.
double in_vain(int singular, int before = 1000) {
    Persistence persistence(singular, before, faces, 400);
    double spent = 0;
    while (persistence.worthwhile(singular)) {
        Persistence::Search &search = persistence.best();
        const double effort = singular * (search.wander + search.size);
        persistence.learn(search, 0, effort);
        spent += effort;
        if (spent > 1e9)
            break;
    }
    return spent;
}

TEST(Persistence, TriesTheCheapestFirstAndAllInTheEnd) {
    Persistence persistence(40, 1000, faces, 400);
    std::set<std::pair<int, int>> tried;
    for (int i = 0; i < 200; ++i) {
        Persistence::Search &search = persistence.best();
        if (tried.empty()) {
            EXPECT_EQ(std::pair(search.wander, search.size), std::pair(16, 16));
        }
        tried.insert({search.wander, search.size});
        persistence.learn(search, 0, 40.0 * (search.wander + search.size));
    }
    EXPECT_EQ(tried.size(), 7u);
}

TEST(Persistence, StaysWithWhatSaves) {
    Persistence persistence(40, 1000, faces, 400);
    int large = 0;
    for (int i = 0; i < 100; ++i) {
        Persistence::Search &search = persistence.best();
        const bool saves = search.size == 160;
        large += saves;
        persistence.learn(search, saves ? 2 : 0, 40.0 * (search.wander + search.size));
    }
    EXPECT_GT(large, 60);
}

TEST(Persistence, NoWindowIsLargerThanTheLargest) {
    for (const int largest : {10, 100, 160, 200}) {
        Persistence persistence(40, 1000, faces, largest);
        for (int i = 0; i < 100; ++i) {
            Persistence::Search &search = persistence.best();
            EXPECT_LE(search.size, largest);
            persistence.learn(search, 0, 40.0 * (search.wander + search.size));
        }
    }
}

TEST(Persistence, TheFewerThereAreTheLongerItGoesOn) {
    EXPECT_GT(in_vain(16), 1.5 * in_vain(24));
    EXPECT_GT(in_vain(24), 2 * in_vain(30));
    EXPECT_GT(in_vain(30), 1.1 * in_vain(50));
    EXPECT_LT(in_vain(16), 250.0 * faces);
    EXPECT_LT(in_vain(200), 40.0 * faces);
    EXPECT_GT(in_vain(1), 0);
}

TEST(Persistence, MoreThanThereWereAreWorthMore) {
    EXPECT_EQ(in_vain(60, 60), in_vain(60));
    EXPECT_GT(in_vain(60, 59), 1.5 * in_vain(60));
}

TEST(Persistence, ManyAreWorthItWhileTheyBecomeFewer) {
    Persistence persistence(400, 1000, faces, 400);
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(persistence.worthwhile(400)) << i;
        Persistence::Search &search = persistence.best();
        persistence.learn(search, 0.02 * 400, 400.0 * (search.wander + search.size));
    }
    int more = 0;
    for (; more < 1000 && persistence.worthwhile(400); ++more)
        persistence.learn(persistence.best(), 0, 400.0 * 32);
    EXPECT_LT(more, 100);
}

} // namespace
} // namespace alphamst::adapt
