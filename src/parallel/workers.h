// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace alphamst::parallel {

// How many threads there are where so many are asked for; 0: as many as there are cores.
int concurrency(int threads);

class Workers {
public:
    // At most so many threads, see concurrency.
    explicit Workers(int threads);

    int count() const { return count_; }

    // Calls work(0, w) .. work(n - 1, w) in any order, and returns when all have ended. No two calls at a
    // time have the same w, 0 <= w < count().
    void run(std::size_t n, const std::function<void(std::size_t, std::size_t)> &work) const;

private:
    struct Arena;
    int count_;
    std::shared_ptr<Arena> arena_; // null for one thread
};

} // namespace alphamst::parallel
