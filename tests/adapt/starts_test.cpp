#include "adapt/starts.h"

#include <mutex>
#include <stdexcept>
#include <thread>

#include "run.h"

namespace alphamst::adapt::samples {
namespace {

Price singular_price(const Outcome &outcome) {
    return {false, false, 0, static_cast<double>(outcome.singular_after)};
}

// A search that moves a vertex by what its seed says.
struct Draws {
    std::vector<std::uint64_t> seeds;
    std::mutex mutex;

    Outcome operator()(mesh::QuadMesh &mesh, const Settings &settings, const Progress &) {
        const std::lock_guard lock(mutex);
        seeds.push_back(settings.seed);
        EXPECT_EQ(settings.starts, 1);
        EXPECT_EQ(settings.log, nullptr);
        Outcome outcome;
        outcome.singular_after = static_cast<std::int64_t>(settings.seed % 5);
        auto place = mesh.point(0);
        place[0] += 1e-3 * static_cast<double>(settings.seed % 1000);
        mesh.set_point(0, place);
        return outcome;
    }
};

Outcome run_draws(mesh::QuadMesh &mesh, Draws &draws, int starts, int threads) {
    Settings settings;
    settings.starts = starts;
    settings.threads = threads;
    settings.seed = 4;
    return best_of_starts(
        mesh, settings, silent,
        [&](mesh::QuadMesh &m, const Settings &s, const Progress &p) { return draws(m, s, p); },
        singular_price);
}

TEST(Starts, TheFirstHasTheSeedItselfAndAllDiffer) {
    mesh::QuadMesh mesh = grid(3, 3);
    Draws draws;
    run_draws(mesh, draws, 20, 1);
    EXPECT_EQ(draws.seeds.front(), 4u);
    EXPECT_EQ(std::set(draws.seeds.begin(), draws.seeds.end()).size(), 20u);
}

TEST(Starts, TheFirstOfTheBestIsKeptOnAnyNumberOfThreads) {
    std::set<std::uint64_t> digests;
    for (const int threads : {1, 2, 8}) {
        mesh::QuadMesh mesh = grid(3, 3), expected = mesh;
        Draws draws, again;
        const Outcome outcome = run_draws(mesh, draws, 20, threads);
        if (threads == 1) {
            const auto first =
                std::ranges::min_element(draws.seeds, {}, [](std::uint64_t seed) { return seed % 5; });
            EXPECT_EQ(outcome.singular_after, static_cast<std::int64_t>(*first % 5));
            Settings settings;
            settings.seed = *first;
            again(expected, settings, silent);
            EXPECT_EQ(mesh.checksum(), expected.checksum());
        }
        digests.insert(mesh.checksum());
    }
    EXPECT_EQ(digests.size(), 1u);
}

TEST(Starts, OneIsTheSearchItself) {
    mesh::QuadMesh mesh = grid(3, 3);
    Settings settings;
    settings.log = std::make_shared<Log>();
    bool same = false;
    best_of_starts(
        mesh, settings, silent,
        [&](mesh::QuadMesh &m, const Settings &s, const Progress &p) {
            same = &m == &mesh && &s == &settings && &p == &silent && s.log != nullptr;
            return Outcome();
        },
        singular_price);
    EXPECT_TRUE(same);
}

TEST(Starts, ProgressIsToldOnTheCallersThreadAndEndsAtOne) {
    mesh::QuadMesh mesh = grid(3, 3);
    Settings settings;
    settings.starts = 6;
    settings.threads = 2;
    const std::thread::id here = std::this_thread::get_id();
    double told = 0;
    const Progress progress = [&](double fraction, const char *) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        EXPECT_GE(fraction, told);
        EXPECT_LE(fraction, 1);
        told = fraction;
    };
    best_of_starts(
        mesh, settings, progress,
        [&](mesh::QuadMesh &, const Settings &, const Progress &tell) {
            for (const double fraction : {0.25, 0.5, 1.0})
                tell(fraction, "stage");
            return Outcome();
        },
        singular_price);
    EXPECT_EQ(told, 1);
}

TEST(Starts, AFailureIsPassedOn) {
    for (const int threads : {1, 2}) {
        mesh::QuadMesh mesh = grid(3, 3);
        Settings settings;
        settings.starts = 4;
        settings.threads = threads;
        EXPECT_THROW(best_of_starts(
                         mesh, settings, silent,
                         [](mesh::QuadMesh &, const Settings &, const Progress &) -> Outcome {
                             throw std::runtime_error("no");
                         },
                         singular_price),
                     std::runtime_error);
    }
}

// Of searches that differ.
TEST(Starts, OfAWholeMeshTheBestIsFound) {
    mesh::QuadMesh one = unstructured(12, 7), three = one;
    Settings settings;
    settings.starts = 3;
    settings.threads = 2;
    auto log = std::make_shared<Log>();
    log->level = log_stages;
    std::vector<std::string> lines;
    log->say = [&](int, const std::string &line) { lines.push_back(line); };
    settings.log = log;
    const Outcome best = adapt_whole(three, 1.3, settings, silent);
    const Outcome first = adapt_whole(one, 1.3, {}, silent);
    three.check();
    EXPECT_EQ(best.faces_after, best.faces_wanted);
    EXPECT_LE(best.singular_after, first.singular_after);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].find("start 0: "), 0u);
    EXPECT_EQ(std::ranges::count_if(lines, [](const std::string &line) { return line.ends_with(", kept"); }),
              1);
}

} // namespace
} // namespace alphamst::adapt::samples
