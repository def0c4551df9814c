// A long piece of work on the calling thread tells now and then how far it is, and can be stopped there.
#pragma once

#include <algorithm>
#include <cstddef>

#include "settings.h"

namespace alphamst {

class Pace {
public:
    // Tells nobody.
    Pace() = default;
    // stage: a static English word. The work goes from one fraction of the operation to the other.
    Pace(const Progress &progress, const char *stage, double from = 0, double to = 1)
        : progress_(&progress), stage_(stage), from_(from), to_(to), told_(from) {}

    // So much of this work is done, 0..1. Throws what the progress throws.
    void reach(double part) const {
        told_ = std::max(told_, from_ + (to_ - from_) * std::min(part, 1.0));
        tell();
    }
    // A step of some microseconds, or n of them; where that was many since it was told, it is again.
    void step(std::size_t n = 1) const {
        constexpr std::size_t often = 2000; // some milliseconds
        steps_ += n;
        if (steps_ >= often)
            tell();
    }
    // A part of this work.
    Pace part(double from, double to) const {
        Pace pace = *this;
        pace.from_ = from_ + (to_ - from_) * from;
        pace.to_ = from_ + (to_ - from_) * to;
        pace.told_ = pace.from_;
        return pace;
    }

private:
    void tell() const {
        steps_ = 0;
        if (progress_ != nullptr)
            (*progress_)(told_, stage_);
    }

    const Progress *progress_ = nullptr;
    const char *stage_ = "";
    double from_ = 0, to_ = 1;
    mutable double told_ = 0; // what is told is no part of what is reckoned
    mutable std::size_t steps_ = 0;
};

} // namespace alphamst
