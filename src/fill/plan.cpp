#include "fill/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <set>

#include "fill/alpha.h"
#include "fill/exact.h"
#include "fill/front.h"
#include "fill/polygon.h"
#include "fill/random.h"

namespace alphamst::fill {
namespace {

// A face spans less than a straight angle; the margin keeps it well shaped.
constexpr double widest_corner = 175;

// What is left after a front was advanced, read as a polygon: `corners` keep one
// face, all other front vertices become flat.
struct Option {
    std::shared_ptr<const Front> front;
    std::vector<int> corners; // front positions, ascending; empty: flat all round
    Sides sides;
    int changed = 0; // vertices that become singular (or cease to be) by this reading
    int least = 0;   // changed + fewest singularities inside
    double misfit = 0; // |log| of wanted over natural face count
};

class Planner {
public:
    explicit Planner(const Request &request) : request_(request), random_(request.seed + 1) {}

    std::vector<Candidate> run() {
        if (request_.word.size() < 4 || request_.word.size() % 2 != 0)
            return {};
        collect_options();
        exact_fillings();
        template_fillings();
        sort();
        return std::move(candidates_);
    }

private:
    int position_cost(const Front &front, std::size_t position, int letter) const {
        const auto id = static_cast<std::size_t>(front.ids[position]);
        if (id < request_.word.size()) {
            // Compared with the wanted letter at this vertex less what was laid at it.
            const int laid = request_.word[id] - front.word[position];
            return request_.regular[id] != 0 && letter + laid != request_.regular[id];
        }
        return letter != front.word[position];
    }
    bool allowed(const Front &front, std::size_t position, int letter) const {
        const auto id = static_cast<std::size_t>(front.ids[position]);
        if (id >= request_.angles.size() || request_.angles.empty())
            return true;
        const int laid = request_.word[id] - front.word[position];
        return request_.angles[id] < widest_corner * (letter + laid);
    }
    int buried_cost(const Front &front) const; // boundary vertices no longer on the front

    void collect_options();
    void add_readings(const std::shared_ptr<const Front> &front);
    void add_option(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base);
    void exact_fillings();
    void template_fillings();
    void try_polygon(const Option &option, int singularities, std::size_t most);
    void try_flat(const Option &option, int singularities);
    void sort();

    std::int64_t lowest() const { return request_.any_count ? request_.faces / 2 : request_.faces - slack_; }
    std::int64_t highest() const { return request_.any_count ? 2 * request_.faces : request_.faces + slack_; }

    const Request &request_;
    Random random_;
    std::vector<Option> options_;
    std::vector<Candidate> candidates_;
    std::int64_t slack_ = 0;
};

int Planner::buried_cost(const Front &front) const {
    std::vector<char> open(request_.word.size(), 0);
    for (const int id : front.ids)
        if (static_cast<std::size_t>(id) < open.size())
            open[static_cast<std::size_t>(id)] = 1;
    int cost = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
        cost += !open[i] && request_.regular[i] != 0 && request_.word[i] != request_.regular[i];
    return cost;
}

void Planner::collect_options() {
    Front front(request_.word);
    for (int stage = 0; stage < 64; ++stage) {
        const auto laid = static_cast<std::int64_t>(front.quads.size());
        if (laid + static_cast<std::int64_t>(front.word.size()) / 2 - 1 > highest() + request_.tolerance)
            break;
        add_readings(std::make_shared<const Front>(front));
        if (stage == 0 || front.concaves() == 0) {
            Front ring = front;
            if (ring.offset())
                add_readings(std::make_shared<const Front>(std::move(ring)));
        }
        if (front.concaves() == 0 || !front.cancel_concave())
            break;
    }
    std::stable_sort(options_.begin(), options_.end(), [](const Option &a, const Option &b) {
        return a.least != b.least ? a.least < b.least : a.misfit < b.misfit;
    });
}

// Reads the front as flat, and as polygons with 1 to 6 of its corners kept.
void Planner::add_readings(const std::shared_ptr<const Front> &front) {
    const std::size_t length = front->word.size();
    int base = buried_cost(*front);
    std::vector<int> pool, flats;
    for (std::size_t i = 0; i < length; ++i) {
        const int letter = front->word[i];
        if (letter == 1)
            pool.push_back(static_cast<int>(i));
        else if (!allowed(*front, i, 2))
            return; // this vertex cannot become flat
        else if (letter == 2 && allowed(*front, i, 1))
            flats.push_back(static_cast<int>(i));
        base += position_cost(*front, i, 2);
    }
    add_option(front, {}, base);
    // Without enough corners some flat vertices are made into corners, spread evenly.
    for (std::size_t k = 0; k < 8 && pool.size() < 6 && !flats.empty(); ++k) {
        const int v = flats[k * flats.size() / 8];
        if (std::find(pool.begin(), pool.end(), v) == pool.end())
            pool.push_back(v);
    }
    std::sort(pool.begin(), pool.end());
    std::set<std::vector<int>> seen;
    for (int n = 1; n <= 6 && n <= static_cast<int>(pool.size()); ++n)
        for (int round = 0; round < (n <= 2 ? 12 : 60); ++round) {
            std::vector<int> chosen = pool;
            if (static_cast<int>(pool.size()) > n) {
                if (round < static_cast<int>(pool.size())) { // evenly spread along the front
                    chosen.clear();
                    const int first = pool[static_cast<std::size_t>(round)];
                    for (int k = 0; k < n; ++k) {
                        const int aim = (first + k * static_cast<int>(length) / n) % static_cast<int>(length);
                        chosen.push_back(*std::min_element(pool.begin(), pool.end(), [&](int a, int b) {
                            auto away = [&](int p) {
                                const int d = std::abs(p - aim);
                                return std::min(d, static_cast<int>(length) - d);
                            };
                            return away(a) < away(b);
                        }));
                    }
                } else {
                    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
                        std::swap(chosen[k], chosen[k + random_() % (chosen.size() - k)]);
                    chosen.resize(static_cast<std::size_t>(n));
                }
                std::sort(chosen.begin(), chosen.end());
                if (std::unique(chosen.begin(), chosen.end()) != chosen.end())
                    continue;
            }
            if (!seen.insert(chosen).second)
                continue;
            int cost = base;
            for (const int c : chosen)
                cost += position_cost(*front, static_cast<std::size_t>(c), 1) -
                        position_cost(*front, static_cast<std::size_t>(c), 2);
            add_option(front, std::move(chosen), cost);
        }
}

void Planner::add_option(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base) {
    const int length = static_cast<int>(front->word.size());
    Option option{front, std::move(corners), {}, base, 0, 0};
    const std::size_t n = option.corners.size();
    for (std::size_t i = 0; i < n; ++i)
        option.sides.push_back(i + 1 < n ? option.corners[i + 1] - option.corners[i]
                                         : length - option.corners[i] + option.corners[0]);
    option.least = base + (n == 0 ? 4 : least_singularities(option.sides));
    const double rest = static_cast<double>(request_.faces) - static_cast<double>(front->quads.size());
    double natural = length * length / 16.0;
    if (n == 4)
        natural = 0.25 * (option.sides[0] + option.sides[2]) * (option.sides[1] + option.sides[3]);
    else if (n == 3)
        natural = length * length / 21.0;
    option.misfit = std::abs(std::log(std::max(1.0, rest) / natural));
    if (n == 0)
        option.misfit = rest < 1.5 * length ? 10 : 0.2;
    options_.push_back(std::move(option));
}

// Small words: the exact filler, for every number of singularities below the best known.
void Planner::exact_fillings() {
    const int length = static_cast<int>(request_.word.size());
    const std::int64_t most = std::min<std::int64_t>(most_faces, request_.any_count ? request_.faces + request_.faces / 2
                                                                                    : request_.faces);
    if (length > 40 || request_.faces > most || *std::max_element(request_.word.begin(), request_.word.end()) > 4 ||
        request_.node_limit <= 0)
        return;
    int base = 0;
    for (std::size_t i = 0; i < request_.word.size(); ++i)
        base += request_.regular[i] != 0 && request_.regular[i] != request_.word[i];
    const int excess = index(request_.word);
    const auto filler = std::make_shared<ExactFiller>(request_.node_limit);
    try {
        for (int k = std::abs(excess); k <= std::abs(excess) + 4; k += 2) {
            const int v3 = (k + excess) / 2, v5 = (k - excess) / 2;
            const FaceSet counts = filler->faces(request_.word, v3, v5, static_cast<int>(most));
            std::int64_t best = -1;
            for (std::int64_t f = 1; f <= most; ++f)
                if (counts[static_cast<std::size_t>(f)] &&
                    (best < 0 || std::abs(f - request_.faces) < std::abs(best - request_.faces)))
                    best = f;
            if (best < 0 || (!request_.any_count && best != request_.faces))
                continue;
            std::set<std::vector<std::array<int, 4>>> different;
            for (std::uint64_t seed = 0; seed < 6; ++seed) {
                auto filling = filler->fill(request_.word, v3, v5, static_cast<int>(best), seed);
                if (filling && different.insert(filling->quads).second)
                    candidates_.push_back({best, base + k, 0.1 * static_cast<double>(seed),
                                           [f = std::move(*filling)] { return f; }});
            }
            return;
        }
    } catch (const TooHard &) {
    }
}

void Planner::try_polygon(const Option &option, int singularities, std::size_t most) {
    PolygonQuery query;
    const auto laid = static_cast<std::int64_t>(option.front->quads.size());
    query.sides = option.sides;
    query.singularities = singularities - option.changed;
    query.fewest_faces = lowest() - laid;
    query.most_faces = highest() - laid;
    query.faces = request_.faces - laid;
    query.seed = random_();
    query.effort = request_.any_count ? 3 : 12;
    query.enough = 8;
    const int boundary = static_cast<int>(request_.word.size());
    for (Template &t : solve(query, most)) {
        double mean = t.evenness / static_cast<double>(t.x.size()), spread = 0;
        for (const int copies : t.x)
            spread += std::pow(std::log(static_cast<double>(copies)) - mean, 2);
        const double stretch = std::sqrt(spread / static_cast<double>(t.x.size())) + option.misfit;
        candidates_.push_back({t.faces + laid, singularities, stretch,
                               [option, t = std::move(t), boundary] {
                                   const Filling rest = rotated(build(t, option.sides),
                                                                (static_cast<int>(option.front->word.size()) -
                                                                 option.corners[0]) %
                                                                    static_cast<int>(option.front->word.size()));
                                   return option.front->close(rest, boundary);
                               }});
    }
}

void Planner::try_flat(const Option &option, int singularities) {
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
            candidates_.push_back({t.faces + laid, singularities, t.stretch + 0.2 * turn,
                                   [option, t, offset, boundary] {
                                       return option.front->close(build(t, offset), boundary);
                                   }});
        }
}

void Planner::template_fillings() {
    if (options_.empty())
        return;
    const int limit = candidates_.empty() ? 1 << 20 : candidates_.front().singularities;
    for (slack_ = 0; slack_ <= request_.tolerance; slack_ += request_.tolerance) {
        const int first = options_.front().least;
        int found_at = -1;
        for (int k = first; k <= std::min(limit, first + 40); ++k) {
            int tries = 0;
            for (const Option &option : options_) {
                if (option.least > k)
                    break;
                const bool flat = option.corners.empty();
                if ((k - option.least) % 2 != 0 || k - option.least > (flat ? 8 : 4))
                    continue;
                if (++tries > 24 || (found_at == k && static_cast<int>(candidates_.size()) >= request_.most))
                    break;
                if (flat)
                    try_flat(option, k);
                else
                    try_polygon(option, k, 4);
                if (!candidates_.empty() && found_at < 0)
                    found_at = k;
            }
            if (static_cast<int>(candidates_.size()) >= request_.most && found_at >= 0)
                break;
            if (found_at >= 0 && k >= found_at + 6)
                break;
        }
        if (!candidates_.empty() || request_.any_count || request_.tolerance == 0)
            break;
    }
}

void Planner::sort() {
    std::stable_sort(candidates_.begin(), candidates_.end(), [&](const Candidate &a, const Candidate &b) {
        const auto miss_a = std::abs(a.faces - request_.faces), miss_b = std::abs(b.faces - request_.faces);
        if (request_.any_count) {
            if (a.singularities != b.singularities)
                return a.singularities < b.singularities;
            return miss_a != miss_b ? miss_a < miss_b : a.stretch < b.stretch;
        }
        if (miss_a != miss_b)
            return miss_a < miss_b;
        return a.singularities != b.singularities ? a.singularities < b.singularities : a.stretch < b.stretch;
    });
    if (static_cast<int>(candidates_.size()) > request_.most)
        candidates_.resize(static_cast<std::size_t>(request_.most));
}

} // namespace

std::vector<Candidate> plan(const Request &request) { return Planner(request).run(); }

} // namespace alphamst::fill
