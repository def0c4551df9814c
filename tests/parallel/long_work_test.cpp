#include "parallel/long_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "failure.h"
#include "parallel/workers.h"
#include "stop.h"

namespace alphamst::parallel {
namespace {

const auto nothing = [] {};

TEST(LongWork, DoesEachPieceOnceForAnyNumberOfThreads) {
    for (const int threads : {1, 2, 8, 0})
        for (const std::size_t n : {0u, 1u, 7u}) {
            std::vector<std::atomic<int>> done(n);
            run_long(
                n, threads, [&](std::size_t i) { ++done[i]; }, nothing);
            for (const std::atomic<int> &times : done)
                EXPECT_EQ(times, 1);
        }
}

TEST(LongWork, OneThreadIsTheCallers) {
    const std::thread::id here = std::this_thread::get_id();
    run_long(
        3, 1, [&](std::size_t) { EXPECT_EQ(std::this_thread::get_id(), here); }, nothing);
}

TEST(LongWork, TheCallerIsCalledWhileItWaits) {
    if (concurrency(2) < 2)
        GTEST_SKIP() << "one core";
    const std::thread::id here = std::this_thread::get_id();
    std::atomic<int> begun = 0;
    std::atomic<bool> waited = false;
    run_long(
        2, 2,
        [&](std::size_t) {
            ++begun;
            while (begun < 2) // one piece each
                std::this_thread::yield();
            while (std::this_thread::get_id() != here && !waited)
                std::this_thread::yield();
        },
        [&] {
            EXPECT_EQ(std::this_thread::get_id(), here);
            waited = true;
        });
    EXPECT_TRUE(waited);
}

// The others would go on for ever.
TEST(LongWork, WhatAPieceThrowsStopsTheOthers) {
    for (const int threads : {1, 2}) {
        std::atomic<int> ended = 0;
        const auto work = [&](std::size_t i) {
            if (i == 0)
                throw std::runtime_error("piece 0");
            while (true)
                Stop::point();
            ++ended;
        };
        EXPECT_THROW(run_long(4, threads, work, nothing), std::runtime_error);
        EXPECT_EQ(ended, 0);
    }
}

TEST(LongWork, WhatTheCallerThrowsAsItWaitsStopsTheOthers) {
    if (concurrency(2) < 2)
        GTEST_SKIP() << "one core";
    const std::thread::id here = std::this_thread::get_id();
    std::atomic<int> begun = 0;
    const auto work = [&](std::size_t) {
        ++begun;
        while (begun < 2)
            std::this_thread::yield();
        while (std::this_thread::get_id() != here)
            Stop::point();
    };
    EXPECT_THROW(run_long(2, 2, work, [] { throw std::runtime_error("stop"); }), std::runtime_error);
}

TEST(LongWork, EveryThreadAsksWhatTheCallerAsks) {
    std::atomic<bool> cancelled = false;
    const Stop::Ask ask = [&] {
        if (cancelled)
            throw Failure(Fault::cancelled, "cancelled");
    };
    const Stop stop(&ask);
    const auto work = [&](std::size_t i) {
        if (i == 1)
            cancelled = true;
        while (true)
            Stop::point();
    };
    cancelled = concurrency(2) < 2;
    EXPECT_THROW(run_long(2, 2, work, nothing), Failure);
}

} // namespace
} // namespace alphamst::parallel
