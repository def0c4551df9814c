// Where few windows still save singularities: which sizes are worth their effort, learned from what
// they saved so far.
#pragma once

#include <vector>

namespace alphamst::adapt {

// Singularities wander in windows of one size, then windows of another look for fewer. Effort: faces of the
// windows that were tried.
class ExpectedGain {
public:
    struct Yield {
        double saved, effort;
        double rate() const { return saved / effort; }
    };
    struct Search : Yield {
        int wander, size; // faces of a window
    };

    // before: singular vertices that there were at first; more of them are worth more. effort: times as much
    // is spent.
    ExpectedGain(int singular, int before, int faces, int largest, double effort = 1);

    // The one that is expected to save most for its effort.
    Search &best();
    void learn(Search &search, double saved, double effort);

    // So few singularities are worth the more the fewer they are; more are while they go on to become fewer.
    bool worthwhile(int singular) const;

private:
    std::vector<Search> searches_;
    int before_;
    double faces_, spent_ = 0;
    Yield lately_;
};

} // namespace alphamst::adapt
