#include "fill/reading.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "index.h"

namespace alphamst::fill {
namespace {

// A face spans less than a straight angle; the margin keeps it well shaped.
constexpr double widest_corner = 175;
constexpr double degree = 3.14159265358979323846 / 180;

} // namespace

Readings::Readings(const Request &request) : request_(request), random_(request.seed + 1) {
    collect_stages();
}

int Readings::least() const {
    int least = 1 << 20;
    for (const Stage &stage : stages_)
        least = std::min(least, stage.least);
    return least;
}

const std::vector<Reading> &Readings::up_to(int k) {
    bool more = false;
    for (Stage &stage : stages_)
        if (!stage.read && stage.least <= k) {
            stage.read = more = true;
            read(stage.front);
        }
    if (more)
        std::stable_sort(readings_.begin(), readings_.end(), [](const Reading &a, const Reading &b) {
            return a.least != b.least ? a.least < b.least : a.count_error < b.count_error;
        });
    return readings_;
}

// Whether giving the vertex this letter on the front makes it irregular.
bool Readings::changes(const Front &front, std::size_t position, int letter) const {
    const auto id = static_cast<std::size_t>(front.ids[position]);
    if (id >= request_.word.size())
        return letter != front.word[position];
    const int laid = request_.word[id] - front.word[position];
    return request_.regular[id] != 0 && letter + laid != request_.regular[id];
}

bool Readings::allowed(const Front &front, std::size_t position, int letter) const {
    const auto id = static_cast<std::size_t>(front.ids[position]);
    if (id >= request_.angles.size())
        return true;
    const int laid = request_.word[id] - front.word[position];
    const double angle = request_.angles[id] / (letter + laid);
    return angle < widest_corner && std::sin(angle * degree) >= request_.least_sine;
}

// Irregular boundary vertices that are no longer on the front.
int Readings::buried(const Front &front) const {
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
void Readings::collect_stages() {
    Front front(request_.word);
    const std::int64_t most = request_.any_count ? 2 * request_.faces : request_.faces + request_.tolerance;
    for (int step = 0; step < 64; ++step) {
        const auto laid = static_cast<std::int64_t>(front.quads.size());
        if (laid + static_cast<std::int64_t>(front.word.size()) / 2 - 1 > most)
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
void Readings::add_stage(Front front) {
    Stage stage{std::make_shared<const Front>(std::move(front)), 0, false};
    const Front &here = *stage.front;
    int flattened = buried(here), corners = 0;
    for (std::size_t i = 0; i < here.word.size(); ++i) {
        corners += here.word[i] == 1;
        if (here.word[i] > 2) {
            flattened += changes(here, i, 2);
            if (!allowed(here, i, 2))
                return; // this vertex cannot become flat
        }
    }
    stage.least = flattened + (corners <= 4 ? 4 - corners : corners - 4);
    stages_.push_back(std::move(stage));
}

// Reads the front as flat, and as polygons with 1 to 6 of its corners kept.
void Readings::read(const std::shared_ptr<const Front> &front) {
    const std::size_t length = front->word.size();
    int base = buried(*front);
    std::vector<int> pool, flats, forced; // forced: corners that cannot become flat
    for (std::size_t i = 0; i < length; ++i) {
        const int letter = front->word[i];
        if (letter == 1)
            (allowed(*front, i, 2) ? pool : forced).push_back(static_cast<int>(i));
        else if (letter == 2 && allowed(*front, i, 1))
            flats.push_back(static_cast<int>(i));
        base += changes(*front, i, 2);
    }
    if (forced.empty())
        add(front, {}, base);
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
                cost += changes(*front, static_cast<std::size_t>(c), 1) -
                        changes(*front, static_cast<std::size_t>(c), 2);
            add(front, std::move(chosen), cost);
        }
}

// n corners, ascending, all forced ones and some of the pool: in the first rounds evenly spread from
// one of them, then at random. Empty if the even places coincide.
std::vector<int> Readings::choose(const std::vector<int> &pool, const std::vector<int> &forced, int n,
                                  int round, int length) {
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
        const int missing = std::clamp(n - static_cast<int>(chosen.size()), 0, static_cast<int>(rest.size()));
        random_.shuffle_front(rest, at(missing));
        chosen.insert(chosen.end(), rest.begin(), rest.begin() + missing);
    }
    std::sort(chosen.begin(), chosen.end());
    if (std::adjacent_find(chosen.begin(), chosen.end()) != chosen.end() ||
        static_cast<int>(chosen.size()) != n)
        chosen.clear();
    return chosen;
}

void Readings::add(const std::shared_ptr<const Front> &front, std::vector<int> corners, int base) {
    const int length = static_cast<int>(front->word.size());
    Reading reading{front, std::move(corners), {}, base, 0, 0, 0};
    const std::size_t n = reading.corners.size();
    for (std::size_t i = 0; i < n; ++i)
        reading.sides.push_back(i + 1 < n ? reading.corners[i + 1] - reading.corners[i]
                                          : length - reading.corners[i] + reading.corners[0]);
    reading.least = base + (n == 0 ? 4 : least_singularities(reading.sides));
    const double rest = static_cast<double>(request_.faces) - static_cast<double>(front->quads.size());
    reading.natural =
        n == 4 ? 0.25 * (reading.sides[0] + reading.sides[2]) * (reading.sides[1] + reading.sides[3])
               : length * length / 16.0;
    reading.count_error = std::abs(std::log(std::max(1.0, rest) / reading.natural));
    if (n == 0)
        reading.count_error = rest < 1.5 * length ? 10 : 0.2;
    readings_.push_back(std::move(reading));
}

} // namespace alphamst::fill
