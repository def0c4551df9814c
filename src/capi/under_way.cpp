#include "capi/under_way.h"

#include <algorithm>
#include <utility>

namespace alphamst::capi {

UnderWay::UnderWay(std::shared_ptr<Context> context)
    : context_(std::move(context)),
      progress_([this](double fraction, const char *stage) { tell(fraction, stage); }),
      ask_([this] { ask(); }), stop_(&ask_) {
    if (context_->busy.exchange(true, std::memory_order_acq_rel))
        context_->refuse_while_busy();
    context_->worker.store(caller_);
}

UnderWay::~UnderWay() {
    context_->worker.store({});
    context_->busy.store(false, std::memory_order_release);
}

void UnderWay::tell(double fraction, const char *stage) {
    told_ = std::clamp(fraction, told_, 1.0); // rounding must not let it fall
    context_->fraction.store(told_);
    stage_ = stage;
    asked_ = 0;
    bool stop = false;
    if (context_->progress != nullptr) {
        const Stop none(nullptr); // what the callback asks of the library is not stopped
        stop = context_->progress(context_->progress_user, told_, stage) != 0;
    }
    if (stop || context_->cancel.load())
        throw Failure(Fault::cancelled, "the operation was cancelled");
}

// On any thread; the caller is told again now and then, so that it can cancel by what its function returns.
void UnderWay::ask() {
    constexpr int often = 500; // points are some microseconds apart
    if (context_->cancel.load(std::memory_order_relaxed))
        throw Failure(Fault::cancelled, "the operation was cancelled");
    if (std::this_thread::get_id() == caller_ && ++asked_ >= often)
        tell(told_, stage_);
}

} // namespace alphamst::capi
