#include "adapt/expected_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace alphamst::adapt {
namespace {

constexpr std::array<std::pair<int, int>, 7> sizes = {
    {{16, 16}, {16, 30}, {16, 60}, {60, 100}, {60, 160}, {60, 250}, {60, 400}}};
constexpr double memory = 0.85; // of what the searches before did
// Effort for each face of the mesh: what is spent on `few` singularities, at least and at most. The sixth
// power leaves many alone.
constexpr double few = 30, effort_for_few = 30, least_effort = 25, most_effort = 200;
constexpr double effort_for_more = 60; // than there were at first
// Effort for each face that to save all of many singularities at the present rate may take.
constexpr double most_for_all = 250;

} // namespace

// Nothing is known yet: each is expected to save one the first time.
ExpectedGain::ExpectedGain(int singular, int before, int faces, int largest, double effort)
    : before_(before),
      faces_(effort * faces), lately_{1, 1.0 * singular * (sizes[0].first + sizes[0].second)} {
    for (const auto &[wander, wished] : sizes) {
        const int size = std::min(wished, largest);
        if (searches_.empty() || size > searches_.back().size || wander > searches_.back().wander)
            searches_.push_back({{1, static_cast<double>(singular) * (wander + size)}, wander, size});
    }
}

ExpectedGain::Search &ExpectedGain::best() {
    return *std::max_element(searches_.begin(), searches_.end(),
                             [](const Search &a, const Search &b) { return a.rate() < b.rate(); });
}

void ExpectedGain::learn(Search &search, double saved, double effort) {
    search.saved += saved;
    search.effort += effort;
    lately_.saved = memory * lately_.saved + saved;
    lately_.effort = memory * lately_.effort + effort;
    spent_ += effort;
}

bool ExpectedGain::worthwhile(int singular) const {
    const double most =
        std::clamp(effort_for_few * std::pow(few / std::max(1, singular), 6), least_effort, most_effort);
    return spent_ < (singular > before_ ? std::max(most, effort_for_more) : most) * faces_ ||
           lately_.rate() * most_for_all * faces_ >= singular;
}

} // namespace alphamst::adapt
