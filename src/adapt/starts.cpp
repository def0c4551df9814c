#include "adapt/starts.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

#include "adapt/log.h"
#include "index.h"
#include "parallel/long_work.h"
#include "parallel/workers.h"
#include "random.h"

namespace alphamst::adapt {
namespace {

class Starts {
public:
    Starts(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress, const Search &search,
           const std::function<Price(const Outcome &)> &price)
        : mesh_(mesh), settings_(settings), progress_(progress), search_(search), price_(price),
          n_(at(settings.starts)), outcomes_(n_), fractions_(n_) {}

    Outcome run() {
        const auto start = std::chrono::steady_clock::now();
        begun_ = mesh_;
        draw_seeds();
        parallel::run_long(
            n_, settings_.threads, [this](std::size_t k) { search(k); }, [this] { tell("starts"); });
        tell("starts"); // of those that ended on other threads, too
        log_starts(settings_, outcomes_, best_);
        Outcome outcome = std::move(outcomes_[best_]);
        outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return outcome;
    }

private:
    void draw_seeds() {
        Random luck(settings_.seed);
        seeds_.assign(1, settings_.seed);
        while (seeds_.size() < n_)
            seeds_.push_back(luck());
    }

    void search(std::size_t k) {
        Settings settings = settings_;
        settings.starts = 1;
        settings.seed = seeds_[k];
        settings.threads = std::max(1, parallel::concurrency(settings_.threads) / settings_.starts);
        settings.log = nullptr; // the lines of several searches would be mixed, and come on their threads
        mesh::QuadMesh tried = begun_;
        Outcome outcome = search_(tried, settings, [this, k](double fraction, const char *stage) {
            fractions_[k].store(fraction, std::memory_order_relaxed);
            if (std::this_thread::get_id() == caller_)
                tell(stage);
        });
        keep_better(k, std::move(tried), std::move(outcome));
    }

    // No more meshes are kept than there are threads, and the best.
    void keep_better(std::size_t k, mesh::QuadMesh tried, Outcome outcome) {
        const std::lock_guard lock(mutex_);
        outcomes_[k] = std::move(outcome);
        fractions_[k].store(1, std::memory_order_relaxed);
        if (any_ && std::pair(price_(outcomes_[best_]), best_) < std::pair(price_(outcomes_[k]), k))
            return;
        any_ = true;
        best_ = k;
        mesh_ = std::move(tried);
    }

    // On the calling thread.
    void tell(const char *stage) const {
        const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
        progress_(sum / static_cast<double>(n_), stage);
    }

    mesh::QuadMesh &mesh_;
    const Settings &settings_;
    const Progress &progress_;
    const Search &search_;
    const std::function<Price(const Outcome &)> &price_;
    const std::size_t n_;
    const std::thread::id caller_ = std::this_thread::get_id();
    mesh::QuadMesh begun_;
    std::vector<std::uint64_t> seeds_;
    std::vector<Outcome> outcomes_;
    std::vector<std::atomic<double>> fractions_;
    std::mutex mutex_;
    bool any_ = false;
    std::size_t best_ = 0;
};

} // namespace

Outcome best_of_starts(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress,
                       const Search &search, const std::function<Price(const Outcome &)> &price) {
    if (settings.starts == 1)
        return search(mesh, settings, progress);
    return Starts(mesh, settings, progress, search, price).run();
}

} // namespace alphamst::adapt
