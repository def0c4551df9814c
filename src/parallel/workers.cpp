#include "parallel/workers.h"

#include <algorithm>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "stop.h"

namespace alphamst::parallel {

// Asked for more than the cores or than the program allows, TBB prints a warning.
int concurrency(int threads) {
    if (threads == 1)
        return 1; // without a word to TBB, which never ends where it finds no memory to begin
    const std::size_t allowed =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const int most =
        std::min(tbb::info::default_concurrency(), static_cast<int>(std::min<std::size_t>(allowed, 4096)));
    return threads == 0 ? most : std::min(threads, most);
}

// Made once: it costs more than many a piece of work.
struct Workers::Arena {
    explicit Arena(int threads) : threads(threads) {}
    tbb::task_arena threads;
};

Workers::Workers(int threads) : count_(concurrency(threads)) {
    if (count_ > 1)
        arena_ = std::make_shared<Arena>(count_);
}

void Workers::run(std::size_t n, const std::function<void(std::size_t, std::size_t)> &work) const {
    if (!arena_ || n < 2) {
        for (std::size_t i = 0; i < n; ++i)
            work(i, 0);
        return;
    }
    // Each piece is its own task: they differ in size by orders of magnitude.
    const Stop::Ask *ask = Stop::of_this_thread();
    arena_->threads.execute([&] {
        tbb::parallel_for(
            std::size_t{0}, n,
            [&](std::size_t i) {
                const Stop stop(ask);
                work(i, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
            },
            tbb::simple_partitioner());
    });
}

} // namespace alphamst::parallel
