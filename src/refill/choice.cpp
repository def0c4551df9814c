#include "refill/choice.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "reference/statistics.h"

namespace alphamst::refill {
namespace {

// In singular vertices: what an error of sizes by a factor of 2 costs, rms over the patch, and what a
// smallest scaled Jacobian costs that is lower by 1 than one that does. From trials on four meshes: at 4,
// one patch in twenty gets a web of long thin rings; at 8, there are a third more singular vertices and sizes
// are hardly better.
constexpr double price_of_size = 6, price_of_shape = 40;
// And what it costs to halve the shortest edge, over the root of the wanted area, below a quarter: time steps
// of explicit solvers go with it, and in a few patches of a coast they fell to a third for two singular
// vertices.
constexpr double short_edge = 0.25, price_of_short_edge = 4, shortest_edge = 1e-3;
// Where singular vertices are to be saved and any count will do, sizes and shapes cost so much of that.
constexpr double saving = 0.4;
// Fillings with so many singular vertices more than the fewest compete: with 10, nothing was gained.
constexpr int levels = 8;
// No filling was seen to come nearer to its sizes, rms.
constexpr double best_size_error = 0.25;
// Faces laid out of one generator before a valid filling is no longer bettered. With twice that, refining by
// 4 takes a quarter more time and nothing is better.
constexpr std::int64_t most_effort = 1500;
// Before a patch is left. Of large patches so many fillings are laid out all the same.
constexpr std::int64_t most_hope = 10000;
constexpr int least_layouts = 4;
// What a few do not find on a surface is found in parts.
constexpr std::int64_t most_hope_on_surface = 2000;
// What a new filling must be better by than one that can stay.
constexpr double least_gain = 1;
// Of sizes against shapes, where the wanted weight costs a corner.
constexpr double smaller_weights[] = {0.3, 0.1};
// Where faces get too small.
constexpr double heavy_size_weight = 0.95;
// And what a degree costs by which edges turn away from the cross field: four weigh as much as a singular
// vertex.
constexpr double price_of_turn = 0.25;
constexpr int most_compared = 4;
// log2 of the smallest face over what is wanted, below which each halving costs so much.
constexpr double small = -2, price_of_small = 8;
// Fillings of a level that are compared: their order by stretch says something.
constexpr int most_of_level = 5;
// A smallest scaled Jacobian above which other generators and weights are not asked. With .3, Verdict's
// acceptable one, its median is .38 instead of .45 where a patch is refined by 4.
constexpr double comfortable = 0.4;
// Nothing is asked of shapes and of the number of poor quads but the smallest scaled Jacobian.
constexpr double any_shape = 0, any_number = 1e18;

} // namespace

double price_of(const SizeError &sizes, double scaled_jacobian, double enough) {
    const double edge = std::clamp(sizes.shortest_edge, shortest_edge, short_edge);
    return price_of_size * sizes.rms + price_of_short_edge * std::log2(short_edge / edge) +
           price_of_small * std::max(0.0, small - sizes.least) +
           price_of_shape * std::max(0.0, enough - scaled_jacobian);
}

double price_of(const Outcome &outcome) {
    const SizeError sizes{outcome.size_error_after, std::log2(outcome.least_area_after),
                          outcome.shortest_edge_after};
    return static_cast<double>(outcome.singular_after) + price_of(sizes, outcome.quality_after, enough);
}

FillingChoice::FillingChoice(const Cavity &cavity, Evaluator &evaluator, Trace &trace, const Goal &goal,
                             const Settings &settings)
    : cavity_(cavity), evaluator_(evaluator), trace_(trace), goal_(goal), settings_(settings),
      present_(cavity.present()), singular_before_(reference::singular(cavity.valences(cavity.old))),
      price_(goal.any_count ? saving : 1), best_score_(std::numeric_limits<double>::infinity()) {
    const SizeError old = cavity.old_size_error();
    old_least_ = old.least;
    if (present_ && cavity.old_shape.valid)
        best_score_ = score(singular_before_, old, evaluator.before().scaled_jacobian) +
                      price_of_turn * cavity.old_alignment_error() - least_gain;
}

double FillingChoice::score(std::int64_t singular, const SizeError &sizes, double scaled_jacobian) const {
    const double wanted = present_ ? enough : std::min(cavity_.old_quality, enough);
    return static_cast<double>(singular) + price_ * price_of(sizes, scaled_jacobian, wanted);
}

Chosen FillingChoice::run() {
    for (const Cavity::Generator &generator : cavity_.generators()) {
        next_.clear();
        tried_ = 0;
        if (best_.evaluation)
            effort_ = 0;
        std::vector<Ranked> pool;
        for (bool more = true; more && tried_ < settings_.candidates && !over();) {
            pool.clear();
            more = collect(generator, pool);
            lay_out(pool);
        }
        if (good())
            break;
    }
    if (present_ && !good()) {
        std::vector<Ranked> pool;
        tried_ = 0;
        add(present_->build(), pool);
        lay_out(pool);
    }
    if (!best_.evaluation && !present_)
        refuse();
    return std::move(best_);
}

bool FillingChoice::spent() const {
    const std::int64_t hope = cavity_.curved() ? most_hope_on_surface : most_hope;
    return layouts_ >= least_layouts &&
           static_cast<double>(effort_) >=
               settings_.effort * static_cast<double>(best_.evaluation ? most_effort : hope);
}

bool FillingChoice::over() const { return good() || spent(); }

bool FillingChoice::good() const {
    return best_.evaluation &&
           best_.evaluation->shape.scaled_jacobian >= std::min(cavity_.old_quality, comfortable);
}

void FillingChoice::refuse() const {
    if (offered_ == 0) {
        const auto loop = static_cast<std::int64_t>(cavity_.window.loop.size());
        std::string text = "no filling with " + std::to_string(goal_.faces) + " faces was found";
        text += goal_.faces < loop / 2 - 1 ? "; the boundary of " + std::to_string(loop) +
                                                 " edges needs at least " + std::to_string(loop / 2 - 1)
                                           : "; try another alpha or a rounder patch";
        throw Refusal{Fault::no_filling, text};
    }
    const int far = trace_.of(Refused::distance), small_ones = trace_.of(Refused::size);
    std::string text =
        "none of " + std::to_string(trace_.candidates) + " fillings could be given a valid shape";
    if (small_ones > 0)
        text += "; " + std::to_string(small_ones) +
                " of them would have faces below AMST_OPT_LEAST_SIZE of the wanted area";
    if (far > 0)
        text +=
            "; " + std::to_string(far) + " of them would be farther from the surface than AMST_OPT_TOLERANCE";
    throw Refusal{Fault::geometry,
                  text + "; try another alpha, a rounder patch or a larger number of candidates"};
}

// The fillings of some levels of singularities; false if there are no more.
bool FillingChoice::collect(const Cavity::Generator &generator, std::vector<Ranked> &pool) {
    const std::size_t most = 4 * static_cast<std::size_t>(settings_.candidates);
    int fewest = -1;
    double least = std::numeric_limits<double>::infinity();
    while (true) {
        if (next_.empty())
            next_ = generator();
        if (next_.empty())
            return false;
        const int singularities = next_.front().singularities;
        if (fewest < 0)
            fewest = singularities;
        // One with more must have better sizes to win, and some are as good as can be.
        if (pool.size() >= most || singularities > fewest + (goal_.any_count ? 0 : levels) ||
            singularities + price_ * price_of_size * best_size_error > least)
            return true;
        int of_level = 0;
        for (const Cavity::Candidate &candidate : std::exchange(next_, {})) {
            if (++of_level > most_of_level)
                break;
            if (faces_ < 0)
                faces_ = candidate.faces;
            if (candidate.faces != faces_ && !goal_.any_count)
                continue; // the first count is kept, come what may
            if (add(candidate.build(), pool))
                least = std::min(least, pool.back().rank);
        }
    }
}

bool FillingChoice::add(PlacedFilling shape, std::vector<Ranked> &pool) {
    Ranked ranked{std::move(shape)};
    const fill::Filling &filling = ranked.shape.filling;
    if (!cavity_.fits(filling))
        return false;
    ++offered_;
    ranked.singular = reference::singular(cavity_.valences(filling));
    if (present_ && ranked.singular > singular_before_)
        return false;
    const double most_quality = cavity_.most_quality(filling);
    if (most_quality < bounds().scaled_jacobian) {
        ++trace_.candidates;
        return trace_.refuse(Refused::shape);
    }
    ranked.rank = score(ranked.singular, {cavity_.predicted_size_error(ranked.shape), 0, 1}, most_quality);
    pool.push_back(std::move(ranked));
    return true;
}

// Where the old filling can stay, nothing may get worse; else the quality is larger than the least, by
// whatever that is.
ShapeBounds FillingChoice::bounds() const {
    return {
        std::max(goal_.keep_quality ? cavity_.old_quality : -1, std::nextafter(settings_.min_quality, 2.0)),
        any_shape, any_number, 0};
}

// Lays the filling out and takes it if it is better than the best; where that costs a corner, sizes get
// less weight. Whether its shapes are good.
bool FillingChoice::judge(const Ranked &ranked, std::int64_t number) {
    PlacedFilling shape = ranked.shape;
    std::vector<double> weights{settings_.size_weight};
    std::ranges::copy_if(smaller_weights, std::back_inserter(weights),
                         [&](double weight) { return weight < weights.front(); });
    for (const double weight : weights) {
        auto evaluation = evaluate(shape, weight);
        if (evaluation && weight == weights.front() && is_too_small(*evaluation))
            evaluation = evaluate(shape, heavy_size_weight);
        if (!evaluation)
            return false;
        if (is_too_small(*evaluation)) {
            trace_.refuse(Refused::size);
            return false;
        }
        shape.positions = evaluation->flat; // from where other weights are near
        const double quality = evaluation->shape.scaled_jacobian;
        const SizeError sizes = evaluation->size_error;
        const double price =
            score(ranked.singular, sizes, quality) + price_of_turn * evaluation->replacement.alignment_error;
        if (price < best_score_) {
            best_score_ = price;
            best_ = {std::move(evaluation), cavity_.valences(ranked.shape.filling), number};
        }
        if (quality >= std::min(cavity_.old_quality, comfortable))
            return true;
        if (score(ranked.singular, sizes, enough) >= best_score_)
            break; // nor would a better shape help
    }
    return false;
}

std::optional<Evaluation> FillingChoice::evaluate(const PlacedFilling &shape, double size_weight) {
    ++layouts_;
    effort_ += static_cast<std::int64_t>(shape.filling.quads.size());
    return evaluator_.evaluate(shape, bounds(), size_weight);
}

bool FillingChoice::is_too_small(const Evaluation &evaluation) const {
    return evaluation.size_error.least < std::min(std::log2(settings_.least_size), old_least_);
}

void FillingChoice::lay_out(std::vector<Ranked> &pool) {
    std::stable_sort(pool.begin(), pool.end(),
                     [](const Ranked &a, const Ranked &b) { return a.rank < b.rank; });
    // The first that is well shaped does, as laying out three gained nothing that could be measured; but how
    // it lies to a cross field only the layout tells.
    const int most = cavity_.reference().cross_field != nullptr ? most_compared : 1;
    std::int64_t number = 0;
    int well_shaped = 0;
    for (const Ranked &ranked : pool) {
        if (tried_ >= settings_.candidates || spent() || well_shaped >= most)
            return;
        if (!evaluator_.fits(ranked.shape.filling))
            continue;
        ++tried_;
        well_shaped += judge(ranked, number++);
    }
}

} // namespace alphamst::refill
