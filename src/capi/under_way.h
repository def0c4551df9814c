// An operation of a context while it runs: no other may begin, its progress is told, and it can be cancelled.
#pragma once

#include <memory>
#include <thread>

#include "capi/handles.h"
#include "settings.h"
#include "stop.h"

namespace alphamst::capi {

class UnderWay {
public:
    // Failure: state, if there is one under way.
    explicit UnderWay(std::shared_ptr<Context> context);
    ~UnderWay();
    UnderWay(const UnderWay &) = delete;
    UnderWay &operator=(const UnderWay &) = delete;

    // Throws Failure (cancelled), as Stop::point() does from now on. Not to be called when this is gone.
    const Progress &progress() const { return progress_; }

private:
    void tell(double fraction, const char *stage);
    void ask();

    std::shared_ptr<Context> context_;
    const std::thread::id caller_ = std::this_thread::get_id();
    double told_ = 0; // fraction, and its stage
    const char *stage_ = "start";
    int asked_ = 0; // by the caller's thread since it told anything
    Progress progress_;
    Stop::Ask ask_;
    Stop stop_;
};

} // namespace alphamst::capi
