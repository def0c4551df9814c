// The library leaves alone what belongs to the whole process: handlers of signals, and the random numbers of
// the C library.
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include "alphamst/alphamst.h"

namespace {

constexpr std::int32_t methods[] = {AMST_DECOMPOSE_CLUSTERS, AMST_DECOMPOSE_PARTITION, AMST_DECOMPOSE_VORONOI,
                                    AMST_DECOMPOSE_MEDIAL, AMST_DECOMPOSE_SINGULARITIES};

class Process : public testing::Test {
protected:
    void SetUp() override {
        constexpr int side = 60;
        std::vector<double> points;
        std::vector<std::int32_t> faces;
        for (int j = 0; j <= side; ++j)
            for (int i = 0; i <= side; ++i)
                points.insert(points.end(), {1.0 * i, 1.0 * j});
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const int v = j * (side + 1) + i;
                faces.insert(faces.end(), {v, v + 1, v + side + 2, v + side + 1});
            }
        ASSERT_EQ(amst_context_create(0, &ctx), AMST_OK);
        ASSERT_EQ(amst_mesh_create(ctx, 2, points.data(), std::ssize(points) / 2, 0, 0, faces.data(),
                                   std::ssize(faces) / 4, 0, 0, 4, nullptr, &mesh),
                  AMST_OK);
    }
    void TearDown() override {
        amst_mesh_destroy(mesh);
        amst_context_destroy(ctx);
    }

    // The faces of all patches that a method makes.
    std::vector<amst_id> decompose(std::int32_t method) {
        std::vector<amst_id> all;
        amst_patches *set = nullptr;
        EXPECT_EQ(amst_patches_create(mesh, nullptr, &set), AMST_OK);
        EXPECT_EQ(amst_patches_decompose(set, method, nullptr), AMST_OK) << amst_last_error();
        std::int64_t patches = 0;
        EXPECT_EQ(amst_patches_get_count(set, &patches), AMST_OK);
        for (amst_id p = 0; p < patches; ++p) {
            std::int64_t n = 0;
            EXPECT_EQ(amst_patches_get_faces(set, p, nullptr, 0, &n), AMST_OK);
            const std::size_t before = all.size();
            all.resize(before + static_cast<std::size_t>(n) + 1, -1); // -1 ends a patch
            EXPECT_EQ(amst_patches_get_faces(set, p, all.data() + before, n, &n), AMST_OK);
        }
        amst_patches_destroy(set);
        return all;
    }

    amst_context *ctx = nullptr;
    amst_mesh *mesh = nullptr;
};

constexpr int watched[] = {SIGTERM, SIGABRT, SIGINT, SIGSEGV, SIGFPE};

bool handlers_are_the_defaults() {
    bool all = true;
    for (const int signal : watched) {
        struct sigaction now {};
        all = all && sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL;
    }
    return all;
}

// A thread looks all the time; what it does not see is seen by those that run after it.
TEST_F(Process, HandlersOfSignalsStayDuringAndAfter) {
    if (!handlers_are_the_defaults())
        GTEST_SKIP() << "a sanitizer has handlers of its own";
    std::atomic<bool> done{false}, same{true};
    std::thread watch([&] {
        while (!done)
            if (!handlers_are_the_defaults())
                same = false;
    });
    for (const std::int32_t method : methods)
        for (int i = 0; i < 20; ++i)
            decompose(method);
    done = true;
    watch.join();
    EXPECT_TRUE(same);
    EXPECT_TRUE(handlers_are_the_defaults());
}

TEST_F(Process, RandomNumbersOfTheCallerStay) {
    const auto draw = [&](bool between) {
        std::vector<int> numbers;
        std::srand(7);
        for (const std::int32_t method : methods) {
            numbers.push_back(std::rand());
            if (between)
                decompose(method);
        }
        numbers.push_back(std::rand());
        return numbers;
    };
    EXPECT_EQ(draw(true), draw(false));
}

TEST_F(Process, AThreadThatDrawsNumbersChangesNothing) {
    std::vector<std::vector<amst_id>> alone;
    for (const std::int32_t method : methods)
        alone.push_back(decompose(method));
    std::atomic<bool> done{false};
    std::thread draw([&] {
        while (!done)
            std::rand();
    });
    for (int round = 0; round < 5; ++round)
        for (std::size_t m = 0; m < std::size(methods); ++m)
            EXPECT_EQ(decompose(methods[m]), alone[m]) << "method " << methods[m];
    done = true;
    draw.join();
}

} // namespace
