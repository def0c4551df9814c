#include "adapt/workers.h"

#include <algorithm>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace alphamst::adapt {
namespace {

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

} // namespace

Workers::Workers(int threads) : count_(concurrency(threads)) {}

void Workers::run(std::size_t n, const std::function<void(std::size_t)> &work) const {
    if (count_ == 1 || n < 2) {
        for (std::size_t i = 0; i < n; ++i)
            work(i);
        return;
    }
    // Each piece is its own task: they differ in size by orders of magnitude.
    tbb::task_arena(count_).execute(
        [&] { tbb::parallel_for(std::size_t{0}, n, work, tbb::simple_partitioner()); });
}

} // namespace alphamst::adapt
