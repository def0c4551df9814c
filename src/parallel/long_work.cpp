#include "parallel/long_work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "failure.h"
#include "parallel/workers.h"
#include "stop.h"

namespace alphamst::parallel {
namespace {

// Often enough for a caller that cancels by what its progress function returns.
constexpr std::chrono::milliseconds pause(10);

class LongWork {
public:
    LongWork(std::size_t n, const std::function<void(std::size_t)> &work)
        : n_(n), work_(work), ask_of_caller_(Stop::of_this_thread()) {}

    void run(std::size_t helpers, const std::function<void()> &wait) {
        std::vector<std::jthread> threads;
        try {
            threads.reserve(helpers);
            while (threads.size() < helpers) {
                threads.emplace_back([this] { help(); });
                change_running(1);
            }
        } catch (const std::system_error &) {
            // There are no more threads; those that there are do it.
        } catch (...) {
            keep(std::current_exception());
        }
        take_pieces();
        wait_for_others(wait);
        threads.clear();
        if (thrown_)
            std::rethrow_exception(thrown_);
    }

private:
    void help() {
        take_pieces();
        change_running(-1);
    }

    // A helper may have ended before it is counted.
    void change_running(int by) {
        const std::lock_guard lock(mutex_);
        running_ += by;
        ended_.notify_one();
    }

    void take_pieces() {
        const Stop stop(&ask_);
        try {
            for (std::size_t i = next_++; i < n_ && !failed_; i = next_++)
                work_(i);
        } catch (...) {
            keep(std::current_exception());
        }
    }

    void wait_for_others(const std::function<void()> &wait) {
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, pause, [this] { return running_ == 0; })) {
            lock.unlock();
            try {
                if (!failed_)
                    wait();
            } catch (...) {
                keep(std::current_exception());
            }
            lock.lock();
        }
    }

    // The first one counts: those after it may be no more than its consequence.
    void keep(std::exception_ptr thrown) {
        const std::lock_guard lock(mutex_);
        if (!thrown_)
            thrown_ = std::move(thrown);
        failed_ = true;
    }

    void ask() const {
        if (failed_.load(std::memory_order_relaxed))
            throw Failure(Fault::cancelled, "another thread of the operation has failed");
        if (ask_of_caller_ != nullptr)
            (*ask_of_caller_)();
    }

    const std::size_t n_;
    const std::function<void(std::size_t)> &work_;
    const Stop::Ask *ask_of_caller_;
    const Stop::Ask ask_ = [this] { ask(); };
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    std::condition_variable ended_;
    int running_ = 0; // helpers
    std::exception_ptr thrown_;
};

} // namespace

void run_long(std::size_t n, int threads, const std::function<void(std::size_t)> &work,
              const std::function<void()> &wait) {
    const std::size_t most = static_cast<std::size_t>(concurrency(threads));
    LongWork(n, work).run(std::min(most, std::max<std::size_t>(n, 1)) - 1, wait);
}

} // namespace alphamst::parallel
