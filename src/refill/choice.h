// Which filling a patch gets: of those that its generators offer, the best by singularities, sizes and
// shapes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "outcome.h"
#include "refill/cavity.h"
#include "refill/evaluate.h"
#include "settings.h"

namespace alphamst::refill {

// A smallest scaled Jacobian that does, or the old one where that is lower.
inline constexpr double enough = 0.5;

// What sizes and a smallest scaled Jacobian below `enough` cost, in singular vertices.
double price_of(const SizeError &sizes, double scaled_jacobian, double enough);

// What an outcome costs: its singular vertices, and that of its sizes and shapes.
double price_of(const Outcome &outcome);

// What was taken. Without an evaluation nothing is better than what is there.
struct Chosen {
    std::optional<Evaluation> evaluation;
    std::map<int, std::int64_t> valences;
    std::int64_t number = -1; // place in the order in which fillings were predicted to be good
};

class FillingChoice {
public:
    // All of them must outlive it.
    FillingChoice(const Cavity &cavity, Evaluator &evaluator, Trace &trace, const Goal &goal,
                  const Settings &settings);

    // Throws Refusal where there is no filling.
    Chosen run();

private:
    // A filling that is not laid out yet.
    struct Ranked {
        PlacedFilling shape;
        std::int64_t singular = 0;
        double rank = 0;
    };

    bool collect(const Cavity::Generator &generator, std::vector<Ranked> &pool);
    bool add(PlacedFilling shape, std::vector<Ranked> &pool);
    void lay_out(std::vector<Ranked> &pool);
    // In singular vertices; less is better.
    double score(std::int64_t singular, const SizeError &sizes, double scaled_jacobian) const;
    bool good() const;
    bool over() const;
    bool spent() const;
    ShapeBounds bounds() const;
    bool judge(const Ranked &ranked, std::int64_t number);
    std::optional<Evaluation> evaluate(const PlacedFilling &shape, double size_weight);
    bool is_too_small(const Evaluation &evaluation) const;
    [[noreturn]] void refuse() const;

    const Cavity &cavity_;
    Evaluator &evaluator_;
    Trace &trace_;
    const Goal &goal_;
    const Settings &settings_;
    const std::optional<Cavity::Candidate> present_;
    const std::int64_t singular_before_;
    std::int64_t faces_ = -1; // of the first filling: others must have them, too, unless any count will do
    std::vector<Cavity::Candidate> next_; // taken from the generator, for the next pool
    Chosen best_;
    const double price_; // of sizes and shapes
    double best_score_, old_least_ = 0;
    int offered_ = 0, tried_ = 0;
    std::int64_t effort_ = 0; // faces laid out
    int layouts_ = 0;
};

} // namespace alphamst::refill
