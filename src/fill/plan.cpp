#include "fill/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <set>

#include "fill/alpha.h"
#include "fill/collapse.h"
#include "fill/exact.h"
#include "fill/front.h"
#include "fill/polygon.h"
#include "fill/random.h"

namespace alphamst::fill {
namespace {

// A face spans less than a straight angle; the margin keeps it well shaped.
constexpr double widest_corner = 175;
constexpr double degree = 3.14159265358979323846 / 180;

// What is left after a front was advanced, read as a polygon: `corners` keep one
// face, all other front vertices become flat.
struct Option {
    std::shared_ptr<const Front> front;
    std::vector<int> corners; // front positions, ascending; empty: flat all round
    Sides sides;
    int changed = 0; // vertices that become singular (or cease to be) by this reading
    int least = 0;   // changed + fewest singularities inside
    double natural = 0; // faces of a square-like filling of the sides
    double misfit = 0;  // |log| of wanted over natural face count
};

// Face counts over the natural one that polygons with N corners and 0, 2 or 4 more than their
// fewest singularities were measured to reach.
struct Reach {
    double low, high;
};
constexpr Reach reaches[6][3] = {{{0.25, 4.0}, {1, 0}, {1, 0}},           {{0.2, 2.0}, {0.15, 3.9}, {1, 0}},
                                 {{0.5, 1.8}, {0.3, 1.9}, {1, 0}},        {{0.6, 1.25}, {0.2, 1.9}, {0.4, 1.6}},
                                 {{0.45, 1.05}, {0.3, 1.5}, {0.25, 1.6}}, {{0.5, 0.9}, {0.3, 1.1}, {0.3, 1.4}}};

class Planner {
public:
    explicit Planner(const Request &request) : request_(request), random_(request.seed + 1) {}

    std::vector<Candidate> run() {
        if (request_.word.size() < 4 || request_.word.size() % 2 != 0)
            return {};
        collect_stages();
        template_fillings();
        sort();
        if (exact_fillings())
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
        const double angle = request_.angles[id] / (letter + laid);
        return angle < widest_corner && std::sin(angle * degree) >= request_.least_sine;
    }
    int buried_cost(const Front &front) const; // boundary vertices no longer on the front

    void collect_stages();
    void add_stage(Front front);
    void add_readings(const std::shared_ptr<const Front> &front);
    std::vector<int> choose(const std::vector<int> &pool, const std::vector<int> &forced, int n, int round,
                            int length);
    void add_option(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base);
    bool exact_fillings();
    void read_stages(int k);
    bool reachable(const Option &option, int inside) const;
    void template_fillings();
    void try_polygon(const Option &option, int singularities, std::size_t most);
    void try_flat(const Option &option, int singularities);
    void sort();

    std::int64_t lowest() const { return request_.any_count ? request_.faces / 2 : request_.faces - slack_; }
    std::int64_t highest() const { return request_.any_count ? 2 * request_.faces : request_.faces + slack_; }

    const Request &request_;
    Random random_;
    // A front and the fewest singularities that any reading of it can have.
    struct Stage {
        std::shared_ptr<const Front> front;
        int least = 0;
        bool read = false;
        int concave = 0;
    };
    std::vector<Stage> stages_;
    std::vector<Option> options_;
    std::vector<Candidate> candidates_;
    std::int64_t slack_ = 0;
    int solves_ = 0; // templates that may still be looked for
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

// Every front that cheap rows of quads lead to; their readings come later, as needed.
void Planner::collect_stages() {
    Front front(request_.word);
    for (int step = 0; step < 64; ++step) {
        const auto laid = static_cast<std::int64_t>(front.quads.size());
        if (laid + static_cast<std::int64_t>(front.word.size()) / 2 - 1 > highest() + request_.tolerance)
            break;
        add_stage(front);
        Front ring = front;
        if (ring.offset())
            add_stage(std::move(ring));
        if (front.concaves() == 0 || !front.cancel_concave())
            break;
    }
}

// The best case of a stage: its concave vertices become flat, three to six corners stay.
void Planner::add_stage(Front front) {
    Stage stage{std::make_shared<const Front>(std::move(front)), 0, false};
    const Front &here = *stage.front;
    int flattened = buried_cost(here), concave = 0, corners = 0;
    for (std::size_t i = 0; i < here.word.size(); ++i) {
        corners += here.word[i] == 1;
        concave += here.word[i] > 2;
        if (here.word[i] > 2) {
            flattened += position_cost(here, i, 2);
            if (!allowed(here, i, 2))
                return; // this vertex cannot become flat
        }
    }
    stage.least = flattened + (corners <= 4 ? 4 - corners : corners - 4);
    stage.concave = concave;
    stages_.push_back(std::move(stage));
}

// Reads the front as flat, and as polygons with 1 to 6 of its corners kept.
void Planner::add_readings(const std::shared_ptr<const Front> &front) {
    const std::size_t length = front->word.size();
    int base = buried_cost(*front);
    std::vector<int> pool, flats, forced; // forced: corners that cannot become flat
    for (std::size_t i = 0; i < length; ++i) {
        const int letter = front->word[i];
        if (letter == 1)
            (allowed(*front, i, 2) ? pool : forced).push_back(static_cast<int>(i));
        else if (letter == 2 && allowed(*front, i, 1))
            flats.push_back(static_cast<int>(i));
        base += position_cost(*front, i, 2);
    }
    if (forced.empty())
        add_option(front, {}, base);
    // Without enough corners some flat vertices are made into corners, spread evenly.
    for (std::size_t k = 0; k < 8 && pool.size() + forced.size() < 6 && !flats.empty(); ++k) {
        const int v = flats[k * flats.size() / 8];
        if (std::find(pool.begin(), pool.end(), v) == pool.end())
            pool.push_back(v);
    }
    std::sort(pool.begin(), pool.end());
    std::set<std::vector<int>> seen;
    const int most = std::min(6, static_cast<int>(pool.size() + forced.size()));
    for (int n = std::max(1, static_cast<int>(forced.size())); n <= most; ++n)
        for (int round = 0; round < (n <= 2 ? 8 : 32); ++round) {
            std::vector<int> chosen = choose(pool, forced, n, round, static_cast<int>(length));
            if (chosen.empty() || !seen.insert(chosen).second)
                continue;
            int cost = base;
            for (const int c : chosen)
                cost += position_cost(*front, static_cast<std::size_t>(c), 1) -
                        position_cost(*front, static_cast<std::size_t>(c), 2);
            add_option(front, std::move(chosen), cost);
        }
}

// n corners, ascending, all forced ones and some of the pool: in the first rounds evenly spread from
// one of them, then at random. Empty if the even places coincide.
std::vector<int> Planner::choose(const std::vector<int> &pool, const std::vector<int> &forced, int n, int round,
                                 int length) {
    std::vector<int> chosen = forced, rest = pool;
    if (round < static_cast<int>(pool.size())) {
        const int first = pool[static_cast<std::size_t>(round)];
        for (int k = 0; static_cast<int>(chosen.size()) < n; ++k) {
            const int aim = (first + k * length / n) % length;
            chosen.push_back(*std::min_element(pool.begin(), pool.end(), [&](int a, int b) {
                auto away = [&](int p) { return std::min(std::abs(p - aim), length - std::abs(p - aim)); };
                return away(a) < away(b);
            }));
        }
    } else {
        for (std::size_t k = 0; static_cast<int>(chosen.size()) < n && k < rest.size(); ++k) {
            std::swap(rest[k], rest[k + random_() % (rest.size() - k)]);
            chosen.push_back(rest[k]);
        }
    }
    std::sort(chosen.begin(), chosen.end());
    if (std::adjacent_find(chosen.begin(), chosen.end()) != chosen.end() || static_cast<int>(chosen.size()) != n)
        chosen.clear();
    return chosen;
}

void Planner::add_option(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base) {
    const int length = static_cast<int>(front->word.size());
    Option option{front, std::move(corners), {}, base, 0, 0, 0};
    const std::size_t n = option.corners.size();
    for (std::size_t i = 0; i < n; ++i)
        option.sides.push_back(i + 1 < n ? option.corners[i + 1] - option.corners[i]
                                         : length - option.corners[i] + option.corners[0]);
    option.least = base + (n == 0 ? 4 : least_singularities(option.sides));
    const double rest = static_cast<double>(request_.faces) - static_cast<double>(front->quads.size());
    option.natural = n == 4 ? 0.25 * (option.sides[0] + option.sides[2]) * (option.sides[1] + option.sides[3])
                            : length * length / 16.0;
    option.misfit = std::abs(std::log(std::max(1.0, rest) / option.natural));
    if (n == 0)
        option.misfit = rest < 1.5 * length ? 10 : 0.2;
    options_.push_back(std::move(option));
}

// Small words: the exact filler, for every number of singularities below that of the best template.
bool Planner::exact_fillings() {
    const int length = static_cast<int>(request_.word.size());
    const std::int64_t most =
        std::min<std::int64_t>(most_faces, request_.any_count ? request_.faces + request_.faces / 2 : request_.faces);
    if (length > 40 || request_.faces > most || *std::max_element(request_.word.begin(), request_.word.end()) > 4 ||
        request_.node_limit <= 0)
        return false;
    int base = 0;
    for (std::size_t i = 0; i < request_.word.size(); ++i)
        base += request_.regular[i] != 0 && request_.regular[i] != request_.word[i];
    const int excess = index(request_.word);
    const bool known = !candidates_.empty() &&
                       (request_.any_count || candidates_.front().faces == request_.faces);
    const int best = known ? candidates_.front().singularities : base + std::abs(excess) + 6;
    ExactFiller filler(request_.node_limit);
    try {
        for (int k = std::abs(excess); base + k < best; k += 2) {
            const int v3 = (k + excess) / 2, v5 = (k - excess) / 2;
            const FaceSet counts = filler.faces(request_.word, v3, v5, static_cast<int>(most));
            std::int64_t nearest = -1;
            for (std::int64_t f = 1; f <= most; ++f)
                if (counts[static_cast<std::size_t>(f)] &&
                    (nearest < 0 || std::abs(f - request_.faces) < std::abs(nearest - request_.faces)))
                    nearest = f;
            if (nearest < 0 || (!request_.any_count && nearest != request_.faces))
                continue;
            std::set<std::vector<std::array<int, 4>>> different;
            for (std::uint64_t seed = 0; seed < 6; ++seed) {
                auto filling = filler.fill(request_.word, v3, v5, static_cast<int>(nearest), seed);
                if (filling && different.insert(filling->quads).second)
                    candidates_.push_back({nearest, base + k, 0.1 * static_cast<double>(seed),
                                           [f = std::move(*filling)] { return f; }});
            }
            return true;
        }
    } catch (const TooHard &) {
    }
    return false;
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
    query.effort = request_.any_count ? 3 : 8;
    query.enough = 6;
    query.walks = 16;
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

// Reads the stages that can have k singularities at best.
void Planner::read_stages(int k) {
    bool more = false;
    for (Stage &stage : stages_)
        if (!stage.read && stage.least <= k) {
            stage.read = more = true;
            add_readings(stage.front);
        }
    if (more)
        std::stable_sort(options_.begin(), options_.end(), [](const Option &a, const Option &b) {
            return a.least != b.least ? a.least < b.least : a.misfit < b.misfit;
        });
}

// Whether a filling of the option with that many singularities inside can have the wanted
// number of faces; exact where a closed form says so.
bool Planner::reachable(const Option &option, int inside) const {
    if (request_.any_count || option.corners.empty())
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
        const std::int64_t ends[] = {form->faces(1, 1), form->faces(1, form->most_v), form->faces(form->most_u, 1),
                                     form->faces(form->most_u, form->most_v)};
        return *std::min_element(ends, ends + 4) - slack_ <= faces && faces <= *std::max_element(ends, ends + 4) + slack_;
    }
    const auto surplus = static_cast<std::size_t>(option.changed + inside - option.least) / 2;
    const double ratio = static_cast<double>(faces) / option.natural;
    const Reach reach = reaches[n - 1][std::min<std::size_t>(surplus, 2)];
    return reach.low <= ratio && ratio <= reach.high;
}

void Planner::template_fillings() {
    int first = 1 << 20;
    for (const Stage &stage : stages_)
        first = std::min(first, stage.least);
    for (slack_ = 0; slack_ <= request_.tolerance; slack_ += request_.tolerance) {
        int found_at = -1;
        solves_ = 48;
        for (int k = first; k <= first + 40 && solves_ > 0; ++k) {
            read_stages(k);
            int tries = 0;
            for (const Option &option : options_) {
                const int surplus = k - option.least;
                const bool flat = option.corners.empty();
                if (surplus < 0)
                    break;
                if (surplus % 2 != 0 || surplus > (flat ? 8 : 4) || !reachable(option, k - option.changed))
                    continue;
                if (++tries > 12 || --solves_ < 0 || (found_at == k && static_cast<int>(candidates_.size()) >= request_.most))
                    break;
                if (flat)
                    try_flat(option, k);
                else
                    try_polygon(option, k, 4);
                if (!candidates_.empty() && found_at < 0)
                    found_at = k;
            }
            if (found_at >= 0 && (static_cast<int>(candidates_.size()) >= request_.most || k >= found_at + 4))
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

std::vector<Candidate> plan(const Request &request) {
    std::vector<Candidate> candidates = Planner(request).run();
    return candidates.empty() && !request.any_count ? plan_by_collapse(request) : candidates;
}

} // namespace alphamst::fill
