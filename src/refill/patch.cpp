#include "refill/patch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "reference/statistics.h"
#include "refill/buffer_ring.h"
#include "refill/cavity.h"

namespace alphamst::refill {
namespace {

std::int64_t singular(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += valence != 4 ? count : 0;
    return sum;
}

[[noreturn]] void refuse_count(const Cavity &cavity, const Goal &goal) {
    const std::int64_t least = static_cast<std::int64_t>(cavity.window.loop.size()) / 2 - 1;
    std::string text = "no filling with " + std::to_string(goal.faces) + " faces was found";
    text += goal.faces < least ? "; the boundary of " + std::to_string(cavity.window.loop.size()) +
                                     " edges needs at least " + std::to_string(least)
                               : "; try another alpha or a rounder patch";
    throw Refusal{Fault::no_filling, text};
}

// Least number of singular vertices that any filling of this boundary has.
std::int64_t bound(const Cavity &cavity, const mesh::QuadMesh &mesh) {
    const auto &window = cavity.window;
    std::int64_t forced = 0;
    for (std::size_t i = 0; i < window.loop.size(); ++i)
        forced += !mesh.on_boundary(window.loop[i]) && window.outside[i] >= 4;
    return forced;
}

// The best filling so far and where it came from.
struct Best {
    std::optional<Evaluation> evaluation;
    std::map<int, std::int64_t> valences;
    std::int64_t number = -1;
};

// A smallest scaled Jacobian (Verdict's acceptable one) above which other fillings of the same
// numbers are not tried.
constexpr double comfortable = 0.3;
// Nothing is asked of shapes and of the number of poor quads but the smallest scaled Jacobian.
constexpr double any_shape = 0, any_number = 1e18;

// Tries fillings in their order and keeps the best shape. The first that fits sets the numbers
// that were predicted.
class Choice {
    // Faces embedded in all before a valid filling is no longer bettered by others like it.
    static constexpr std::int64_t most_polish = 2000;
    // Likewise before nothing is expected any more to be better than the present filling.
    static constexpr std::int64_t most_hope = 20000;

public:
    Choice(const Cavity &cavity, Evaluator &evaluator, const Trace &trace, const Goal &goal,
           const Settings &settings)
        : cavity_(cavity), evaluator_(evaluator), trace_(trace), goal_(goal), settings_(settings),
          present_(cavity.present()), singular_before_(singular(cavity.valences(cavity.old))),
          // Larger than the least quality, by whatever that is.
          bounds_{std::nextafter(settings.min_quality, 2.0), any_shape, any_number, 0} {}

    // Without an evaluation where nothing is as good as what is there.
    Best run() {
        each([&](PlacedFilling shape) { return !try_one(std::move(shape)); });
        if (first_faces_ < 0)
            refuse_count(cavity_, goal_);
        if (best_.number < 0 && !present_)
            throw Refusal{Fault::geometry, why_none()};
        return std::move(best_);
    }

    Prediction first() {
        std::optional<Prediction> found;
        each([&](const PlacedFilling &shape) {
            found = {static_cast<std::int64_t>(shape.filling.quads.size()),
                     singular(cavity_.valences(shape.filling))};
            return false;
        });
        if (!found)
            refuse_count(cavity_, goal_);
        return *found;
    }

private:
    std::string why_none() const {
        const int far = trace_.of(Refused::distance);
        std::string text = "none of " + std::to_string(tried_) + " fillings could be given a valid shape";
        if (far > 0)
            text += "; " + std::to_string(far) +
                    " of them would be farther from the surface than AMST_OPT_TOLERANCE";
        return text + "; try another alpha, a rounder patch or a larger number of candidates";
    }

    // Visits the fillings that fit until one is refused; the present one comes before the
    // first that has at least as many singularities.
    template <class Visit> void each(const Visit &visit) {
        auto visit_one = [&](const Cavity::Candidate &candidate) {
            PlacedFilling shape = candidate.build();
            return !cavity_.fits(shape.filling) || visit(std::move(shape));
        };
        bool present_left = present_.has_value();
        for (const Cavity::Generator &generator : cavity_.generators()) {
            tried_here_ = 0;
            for (Cavity::Group group = generator(); !group.empty(); group = generator())
                for (const Cavity::Candidate &candidate : group) {
                    if (present_ && candidate.singularities >= present_->singularities &&
                        std::exchange(present_left, false) && !visit_one(*present_))
                        return;
                    if (!visit_one(candidate))
                        return;
                }
        }
        if (present_left)
            visit_one(*present_);
    }

    bool is_old(const fill::Filling &filling) const { return present_ && filling.quads == cavity_.old.quads; }

    // Whether the search is over. Fillings with other numbers than the first are tried only if none
    // with the same is valid, or, where the old quality is to be kept, good enough.
    bool try_one(PlacedFilling shape) {
        const fill::Filling &filling = shape.filling;
        auto valences = cavity_.valences(filling);
        const auto faces = static_cast<std::int64_t>(filling.quads.size());
        const std::int64_t singular_now = singular(valences);
        if (goal_.keep_quality && singular_now > singular_before_)
            return false; // better on the mesh boundary alone
        if (first_faces_ < 0) {
            first_faces_ = faces;
            first_singular_ = singular_now;
        }
        const bool as_predicted = faces == first_faces_ && singular_now == first_singular_;
        if (faces != first_faces_ && !goal_.any_count)
            return false; // the predicted count is kept, come what may
        if (best_.number >= 0 && !goal_.keep_quality && (!as_predicted || tried_ * faces > most_polish))
            return true;
        if (tried_here_ >= settings_.candidates && !is_old(filling))
            return false;
        if (!evaluator_.fits(filling) ||
            (goal_.keep_quality && tried_ * faces > most_hope && !is_old(filling)))
            return false;
        later_ += as_predicted ? 0 : 1;
        ++tried_;
        ++tried_here_;
        return judge(shape, std::move(valences), as_predicted || goal_.keep_quality ? 0 : later_);
    }

    // Whether the filling is good enough to end the search.
    bool judge(const PlacedFilling &shape, std::map<int, std::int64_t> valences, std::int64_t number) {
        auto evaluation = evaluator_.evaluate(shape, bounds_);
        if (!evaluation)
            return false;
        const double quality = evaluation->shape.scaled_jacobian;
        if (best_.number < 0 || better(*evaluation, *best_.evaluation))
            best_ = {std::move(evaluation), std::move(valences), number};
        return quality >=
               (goal_.keep_quality ? cavity_.old_quality : std::min(cavity_.old_quality, comfortable));
    }

    // Of equal numbers the one along the cross field, where there is one.
    bool better(const Evaluation &now, const Evaluation &best) const {
        if (cavity_.reference().cross_field != nullptr &&
            std::min(now.shape.scaled_jacobian, best.shape.scaled_jacobian) >= comfortable)
            return now.replacement.alignment_error < best.replacement.alignment_error;
        return now.shape.scaled_jacobian > best.shape.scaled_jacobian;
    }

    const Cavity &cavity_;
    Evaluator &evaluator_;
    const Trace &trace_;
    const Goal &goal_;
    const Settings &settings_;
    const std::optional<Cavity::Candidate> present_;
    const std::int64_t singular_before_;
    const ShapeBounds bounds_;
    Best best_;
    std::int64_t first_faces_ = -1, first_singular_ = -1, later_ = 0, tried_ = 0, tried_here_ = 0;
};

Proposal finish(Proposal proposal, std::chrono::steady_clock::time_point start) {
    proposal.outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return proposal;
}

// The faces around a patch matter where features run along its border.
std::vector<int> buffer_of(const mesh::QuadMesh &mesh, const Cavity &cavity) {
    if (!mesh.curves || !cavity.curved())
        return {};
    std::vector<int> faces;
    for (const int v : cavity.window.loop)
        for (const int f : mesh.faces_around(v))
            if (!std::binary_search(cavity.window.faces.begin(), cavity.window.faces.end(), f))
                faces.push_back(f);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

} // namespace

std::int64_t wanted_faces(double alpha, std::size_t faces) {
    return std::llround(std::min(alpha * static_cast<double>(faces), 4e18));
}

Proposal propose(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
                 const reference::Reference &reference) {
    const auto start = std::chrono::steady_clock::now();
    Proposal proposal;
    Outcome &outcome = proposal.outcome;
    outcome.faces_before = outcome.faces_after = static_cast<std::int64_t>(patch.faces.size());
    outcome.faces_wanted = goal.faces;
    try {
        const Cavity cavity(mesh, patch, goal, settings, reference);
        outcome.valences_before = outcome.valences_after = cavity.valences(cavity.old);
        outcome.singular_before = outcome.singular_after = singular(outcome.valences_before);
        outcome.singular_bound = bound(cavity, mesh);
        outcome.quality_before = outcome.quality_after = reference::least_quality(mesh, patch.faces);
        const BufferRing buffer(mesh, cavity, buffer_of(mesh, cavity), true);
        Evaluator evaluator(mesh, cavity, buffer, settings, proposal.trace);
        Best best = Choice(cavity, evaluator, proposal.trace, goal, settings).run();
        proposal.unchanged = !best.evaluation;
        if (proposal.unchanged)
            return finish(std::move(proposal), start);
        proposal.replacement = std::move(best.evaluation->replacement);
        const Replacement &taken = proposal.replacement;
        outcome.quality_after =
            reference::least_quality(mesh, taken.window.loop, taken.filling.quads, taken.points);
        outcome.faces_after = static_cast<std::int64_t>(taken.filling.quads.size());
        outcome.valences_after = std::move(best.valences);
        outcome.singular_after = singular(outcome.valences_after);
        outcome.candidate = best.number;
    } catch (const Refusal &refusal) {
        outcome.fault = refusal.fault;
        outcome.text = refusal.text;
    }
    return finish(std::move(proposal), start);
}

Prediction first_choice(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal,
                        const Settings &settings, const reference::Reference &reference) {
    try {
        const Cavity cavity(mesh, patch, goal, settings, reference);
        const BufferRing buffer(mesh, cavity, {}, true);
        Trace trace;
        Evaluator evaluator(mesh, cavity, buffer, settings, trace);
        return Choice(cavity, evaluator, trace, goal, settings).first();
    } catch (const Refusal &refusal) {
        throw Failure(refusal.fault, refusal.text);
    }
}

mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Replacement &replacement) {
    return mesh.replace_disk(replacement.window.faces, replacement.window.loop, replacement.filling.quads,
                             replacement.points);
}

} // namespace alphamst::refill
