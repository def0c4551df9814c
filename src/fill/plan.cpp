#include "fill/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "fill/alpha.h"
#include "fill/exact.h"
#include "fill/library.h"
#include "fill/polygon.h"
#include "fill/reading.h"

namespace alphamst::fill {
namespace {

// Face counts over the natural one that polygons with N corners and 0, 2 or 4 more than their
// fewest singularities were measured to reach.
struct Reach {
    double low, high;
};
constexpr Reach reaches[6][3] = {
    {{0.25, 4.0}, {1, 0}, {1, 0}},           {{0.2, 2.0}, {0.15, 3.9}, {1, 0}},
    {{0.5, 1.8}, {0.3, 1.9}, {1, 0}},        {{0.6, 1.25}, {0.2, 1.9}, {0.4, 1.6}},
    {{0.45, 1.05}, {0.3, 1.5}, {0.25, 1.6}}, {{0.5, 0.9}, {0.3, 1.1}, {0.3, 1.4}}};

} // namespace

// Levels are numbers of singularities: for each, templates for the readings that can have it,
// until some have the wanted face count.
class Plan::Search {
public:
    explicit Search(Request request)
        : request_(std::move(request)), readings_(request_), random_(request_.seed + 1),
          level_(readings_.least()) {}

    std::vector<Candidate> next() {
        if (request_.word.size() < 4 || request_.word.size() % 2 != 0)
            return {};
        if (!waiting_.empty())
            return std::exchange(waiting_, {});
        while (phase_ < 2) {
            std::vector<Candidate> group = search_levels();
            if (!exact_done_) {
                exact_done_ = true;
                std::vector<Candidate> better =
                    exact_fillings(group.empty() ? -1 : group.front().singularities);
                if (!better.empty()) {
                    waiting_ = std::move(group);
                    return better;
                }
            }
            if (!group.empty())
                return group;
            if (found_ || request_.any_count || request_.tolerance == 0)
                break;
            ++phase_; // now with the tolerance
            slack_ = request_.tolerance;
            level_ = readings_.least();
            solves_ = most_solves;
        }
        phase_ = 2;
        return {};
    }

private:
    static constexpr int most_solves = 48; // templates looked for, each a search of its own
    static constexpr int most_levels = 40;

    std::vector<Candidate> search_levels();
    std::vector<Candidate> exact_fillings(int best);
    bool reachable(const Reading &option, int inside) const;
    void try_polygon(const Reading &option, int singularities, std::vector<Candidate> &group);
    void try_flat(const Reading &option, int singularities, std::vector<Candidate> &group);

    std::int64_t lowest() const {
        if (!request_.any_count)
            return request_.faces - slack_;
        return request_.fewest > 0 ? request_.fewest : request_.faces / 2;
    }
    std::int64_t highest() const {
        if (!request_.any_count)
            return request_.faces + slack_;
        return request_.most_faces > 0 ? request_.most_faces : 2 * request_.faces;
    }

    const Request request_;
    Readings readings_;
    Random random_;
    int level_, phase_ = 0, solves_ = most_solves;
    std::int64_t slack_ = 0;
    bool found_ = false, exact_done_ = false;
    std::vector<Candidate> waiting_;
};

// The group of the next level that has any.
std::vector<Candidate> Plan::Search::search_levels() {
    std::vector<Candidate> group;
    const int last = std::min(readings_.least() + most_levels, request_.fewer_than - 1);
    for (; level_ <= last && solves_ > 0 && group.empty(); ++level_) {
        int tries = 0;
        for (const Reading &option : readings_.up_to(level_)) {
            const int surplus = level_ - option.least;
            const bool flat = option.corners.empty();
            if (surplus < 0)
                break;
            if (surplus % 2 != 0 || surplus > (flat ? 8 : 4) || !reachable(option, level_ - option.changed))
                continue;
            if (++tries > 12 || --solves_ < 0 || static_cast<int>(group.size()) >= request_.most)
                break;
            if (flat)
                try_flat(option, level_, group);
            else
                try_polygon(option, level_, group);
        }
    }
    found_ = found_ || !group.empty();
    std::stable_sort(group.begin(), group.end(), [&](const Candidate &a, const Candidate &b) {
        const auto miss_a = std::abs(a.faces - request_.faces), miss_b = std::abs(b.faces - request_.faces);
        return miss_a != miss_b ? miss_a < miss_b : a.stretch < b.stretch;
    });
    if (static_cast<int>(group.size()) > request_.most)
        group.resize(static_cast<std::size_t>(request_.most));
    return group;
}

// Small words: the exact filler, for every number of singularities below `best`; -1: none is known.
std::vector<Candidate> Plan::Search::exact_fillings(int best) {
    std::vector<Candidate> group;
    const int length = static_cast<int>(request_.word.size());
    const std::int64_t most = std::min<std::int64_t>(
        most_faces,
        request_.any_count ? std::min(highest(), request_.faces + request_.faces / 2) : request_.faces);
    if (length > 40 || request_.faces > most ||
        *std::max_element(request_.word.begin(), request_.word.end()) > 4 || request_.node_limit <= 0)
        return group;
    int base = 0;
    for (std::size_t i = 0; i < request_.word.size(); ++i)
        base += request_.regular[i] != 0 && request_.regular[i] != request_.word[i];
    const int excess = index(request_.word);
    if (best < 0)
        best = std::min(base + std::abs(excess) + 6, request_.fewer_than);
    ExactFiller filler(request_.node_limit);
    try {
        for (int k = std::abs(excess); base + k < best; k += 2) {
            const int v3 = (k + excess) / 2, v5 = (k - excess) / 2;
            const FaceSet counts = filler.faces(request_.word, v3, v5, static_cast<int>(most));
            std::int64_t nearest = -1;
            for (std::int64_t f = std::max<std::int64_t>(1, request_.fewest); f <= most; ++f)
                if (counts[static_cast<std::size_t>(f)] &&
                    (nearest < 0 || std::abs(f - request_.faces) < std::abs(nearest - request_.faces)))
                    nearest = f;
            if (nearest < 0 || (!request_.any_count && nearest != request_.faces))
                continue;
            std::set<std::vector<std::array<int, 4>>> different;
            for (std::uint64_t seed = 0; seed < 6; ++seed) {
                auto filling = filler.fill(request_.word, v3, v5, static_cast<int>(nearest), seed);
                if (filling && different.insert(filling->quads).second)
                    group.push_back({nearest, base + k, 0.1 * static_cast<double>(seed),
                                     [f = std::move(*filling)] { return f; }});
            }
            return group;
        }
    } catch (const TooHard &) {
    }
    return group;
}

// Whether a filling of the option with that many singularities inside can have the wanted
// number of faces; exact where a closed form says so.
bool Plan::Search::reachable(const Reading &option, int inside) const {
    if (option.corners.empty())
        return true;
    if (!has_types(static_cast<int>(option.sides.size()), inside))
        return false;
    if (request_.any_count)
        return true;
    const std::int64_t faces = request_.faces - static_cast<std::int64_t>(option.front->quads.size());
    const std::size_t n = option.sides.size();
    auto near = [&](std::int64_t count) { return std::abs(count - faces) <= slack_; };
    if (inside == 0)
        return near(static_cast<std::int64_t>(option.sides[0]) * option.sides[1]);
    if (inside == 1 && (n == 3 || n == 5))
        return near(spoke_faces(*spokes(option.sides)));
    if (inside == 2 && n == 4) {
        const auto form = pair(option.sides);
        if (!form)
            return false;
        const std::int64_t ends[] = {form->faces(1, 1), form->faces(1, form->most_v),
                                     form->faces(form->most_u, 1), form->faces(form->most_u, form->most_v)};
        return *std::min_element(ends, ends + 4) - slack_ <= faces &&
               faces <= *std::max_element(ends, ends + 4) + slack_;
    }
    const auto surplus = static_cast<std::size_t>(option.changed + inside - option.least) / 2;
    const double ratio = static_cast<double>(faces) / option.natural;
    const Reach reach = reaches[n - 1][std::min<std::size_t>(surplus, 2)];
    return reach.low <= ratio && ratio <= reach.high;
}

void Plan::Search::try_polygon(const Reading &option, int singularities, std::vector<Candidate> &group) {
    PolygonQuery query;
    const auto laid = static_cast<std::int64_t>(option.front->quads.size());
    query.sides = option.sides;
    query.singularities = singularities - option.changed;
    query.fewest_faces = lowest() - laid;
    query.most_faces = highest() - laid;
    query.faces = request_.faces - laid;
    query.seed = random_();
    query.effort = request_.any_count ? 3 : 8;
    query.enough = 6;
    query.walks = 10;
    const int boundary = static_cast<int>(request_.word.size());
    for (Template &t : solve(query, 4)) {
        double mean = t.evenness / static_cast<double>(t.x.size()), spread = 0;
        for (const int copies : t.x)
            spread += std::pow(std::log(static_cast<double>(copies)) - mean, 2);
        const double stretch = std::sqrt(spread / static_cast<double>(t.x.size())) + option.count_error;
        group.push_back({t.faces + laid, singularities, stretch, [option, t = std::move(t), boundary] {
                             const Filling rest =
                                 rotated(build(t, option.sides),
                                         (static_cast<int>(option.front->word.size()) - option.corners[0]) %
                                             static_cast<int>(option.front->word.size()));
                             return option.front->close(rest, boundary);
                         }});
    }
}

void Plan::Search::try_flat(const Reading &option, int singularities, std::vector<Candidate> &group) {
    AlphaQuery query;
    const auto laid = static_cast<std::int64_t>(option.front->quads.size());
    query.perimeter = static_cast<int>(option.front->word.size());
    query.least_singularities = query.most_singularities = singularities - option.changed;
    query.fewest_faces = std::max<std::int64_t>(1, lowest() - laid);
    query.most_faces = highest() - laid;
    query.faces = request_.faces - laid;
    query.seed = random_();
    const int boundary = static_cast<int>(request_.word.size());
    for (AlphaTemplate &t : solve(query, 3))
        for (int turn = 0; turn < 3; ++turn) {
            const int offset = static_cast<int>(random_() % static_cast<std::uint64_t>(query.perimeter));
            group.push_back(
                {t.faces + laid, singularities, t.stretch + 0.2 * turn,
                 [option, t, offset, boundary] { return option.front->close(build(t, offset), boundary); }});
        }
}

Plan::Plan(Request request) : search_(std::make_unique<Search>(std::move(request))) {}
Plan::~Plan() = default;
Plan::Plan(Plan &&) noexcept = default;

std::vector<Candidate> Plan::next() { return search_->next(); }

std::vector<Candidate> plan(const Request &request) {
    Plan groups(request);
    std::vector<Candidate> all;
    for (std::vector<Candidate> group = groups.next(); !group.empty(); group = groups.next()) {
        for (Candidate &candidate : group)
            if (static_cast<int>(all.size()) < request.most)
                all.push_back(std::move(candidate));
        if (static_cast<int>(all.size()) >= request.most)
            break;
    }
    return all;
}

} // namespace alphamst::fill
