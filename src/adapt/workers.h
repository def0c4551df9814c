// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace alphamst::adapt {

class Workers {
public:
    // At most so many threads; 0: as many as there are cores.
    explicit Workers(int threads);

    int count() const { return count_; }

    // Calls work(0) .. work(n - 1) in any order, and returns when all have ended.
    void run(std::size_t n, const std::function<void(std::size_t)> &work) const;

private:
    int count_;
};

} // namespace alphamst::adapt
