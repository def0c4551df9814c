#include "parallel/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace alphamst::parallel {
namespace {

TEST(Workers, OneDoesEverythingInOrderWhereItIsAsked) {
    const Workers workers(1);
    EXPECT_EQ(workers.count(), 1);
    const std::thread::id here = std::this_thread::get_id();
    std::vector<std::size_t> order;
    workers.run(5, [&](std::size_t i, std::size_t worker) {
        EXPECT_EQ(worker, 0u);
        EXPECT_EQ(std::this_thread::get_id(), here);
        order.push_back(i);
    });
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    workers.run(0, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(Workers, AreNoMoreThanAskedForNorThanCores) {
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    EXPECT_GE(Workers(0).count(), 1);
    EXPECT_LE(Workers(0).count(), cores);
    EXPECT_LE(Workers(2).count(), 2);
    EXPECT_LE(Workers(100000).count(), cores);
}

TEST(Workers, DoEachPieceOnceAndNoTwoAtATimeWithOneNumber) {
    constexpr std::size_t n = 2000;
    const Workers workers(0);
    std::vector<std::atomic<int>> done(n), busy(static_cast<std::size_t>(workers.count()));
    std::atomic<int> wrong = 0;
    workers.run(n, [&](std::size_t i, std::size_t worker) {
        if (worker >= busy.size()) {
            ++wrong;
            return;
        }
        wrong += busy[worker].exchange(1) != 0;
        std::this_thread::yield();
        ++done[i];
        busy[worker] = 0;
    });
    EXPECT_EQ(wrong, 0);
    EXPECT_TRUE(
        std::all_of(done.begin(), done.end(), [](const std::atomic<int> &times) { return times == 1; }));
}

TEST(Workers, PassOnWhatAPieceThrows) {
    const Workers workers(0);
    EXPECT_THROW(workers.run(10,
                             [](std::size_t i, std::size_t) {
                                 if (i == 7)
                                     throw i;
                             }),
                 std::size_t);
}

} // namespace
} // namespace alphamst::parallel
