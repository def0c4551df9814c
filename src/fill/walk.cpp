#include "fill/walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "random.h"
#include "stop.h"

namespace alphamst::fill {
namespace {

constexpr std::int16_t most_copies = 10000, most_steps = 4000; // keep sums in 16 bits

struct Steps {
    int fewest, most; // t with x + t z >= 1
};

Eight lower(Eight a, Eight b) { return a < b ? a : b; }

// Multiplicities and what can be taken from them; beyond the chords one copy, which no move changes.
class Place {
public:
    explicit Place(const Multiplicities &x) {
        for (std::size_t j = 0; j < most_chords; ++j)
            x_.set(j, j < x.size() ? x[j] : 1);
        take_stock();
    }

    // One or two copies a step are taken where the masks are open.
    Steps steps(const Move &move) const {
        const Eight back = left(move.adds_one, move.adds_two), ahead = left(move.takes_one, move.takes_two);
        // The lowest of eight, for both at once: four lanes each, then pairs, then neighbours.
        Eight lowest = lower(__builtin_shufflevector(back, ahead, 0, 1, 2, 3, 8, 9, 10, 11),
                             __builtin_shufflevector(back, ahead, 4, 5, 6, 7, 12, 13, 14, 15));
        lowest = lower(lowest, __builtin_shufflevector(lowest, lowest, 2, 3, 0, 1, 6, 7, 4, 5));
        lowest = lower(lowest, __builtin_shufflevector(lowest, lowest, 1, 0, 3, 2, 5, 4, 7, 6));
        return {-std::min<int>(lowest[0], most_steps), std::min<int>(lowest[4], most_steps)};
    }

    // Of the face count along the move.
    std::int64_t slope(const Move &move) const {
        std::int64_t sum = 0;
        for (std::size_t j = 0; j < 8; ++j)
            sum += x_.low[j] * move.slope.low[j] + x_.high[j] * move.slope.high[j];
        return sum;
    }

    Lanes moved(const Move &move, int t) const {
        const auto factor = static_cast<std::int16_t>(t);
        return {x_.low + move.z.low * factor, x_.high + move.z.high * factor};
    }

    void go(const Move &move, int t) {
        x_ = moved(move, t);
        take_stock();
    }

    const Lanes &x() const { return x_; }

    bool far() const {
        for (std::size_t j = 0; j < most_chords; ++j)
            if (x_[j] > most_copies)
                return true;
        return false;
    }

private:
    // Steps until a chord runs out.
    Eight left(const Lanes &one, const Lanes &two) const {
        return lower(lower(spare_.low | one.low, half_.low | two.low),
                     lower(spare_.high | one.high, half_.high | two.high));
    }

    void take_stock() {
        spare_ = {x_.low - 1, x_.high - 1};
        half_ = {spare_.low >> 1, spare_.high >> 1};
    }

    Lanes x_, spare_, half_;
};

// F(x + t z) = F + t g + t^2 q.
struct Change {
    std::int64_t g, q;
    std::int64_t at(std::int64_t t) const { return t * (g + t * q); }
};

// Steps t in range nearest to F(t) = wanted: around the real roots or the vertex.
std::array<int, 4> promising(Change change, std::int64_t wanted, Steps range) {
    const auto g = static_cast<double>(change.g), q = static_cast<double>(change.q);
    std::array<double, 2> roots{0, 0};
    if (change.q == 0) {
        if (change.g != 0)
            roots.fill(static_cast<double>(wanted) / g);
    } else {
        const double root = std::sqrt(std::max(0.0, g * g + 4 * q * static_cast<double>(wanted)));
        roots = {(-g + root) / (2 * q), (-g - root) / (2 * q)};
    }
    std::array<int, 4> t{};
    for (std::size_t i = 0; i < 2; ++i) {
        const int near = static_cast<int>(std::clamp(roots[i], -1e5, 1e5)), below = near - (near > roots[i]);
        t[2 * i] = std::clamp(below, range.fewest, range.most);
        t[2 * i + 1] = std::clamp(below + 1, range.fewest, range.most);
    }
    return t;
}

// log x for the multiplicities that are met all the time.
double logarithm(int x) {
    static const std::vector<double> table = [] {
        std::vector<double> logs(4096, 0);
        for (std::size_t i = 1; i < logs.size(); ++i)
            logs[i] = std::log(static_cast<double>(i));
        return logs;
    }();
    return static_cast<std::size_t>(x) < table.size() ? table[static_cast<std::size_t>(x)] : std::log(x);
}

void centre(const std::vector<Move> &moves, Place &place) {
    for (int round = 0; round < 12 && !place.far(); ++round) {
        Stop::point();
        double best = 1e-9;
        const Move *chosen = nullptr;
        int step = 0;
        for (const Move &move : moves) {
            const Steps range = place.steps(move);
            for (const int t : {-4, -1, 1, 4}) {
                if (t < range.fewest || t > range.most)
                    continue;
                double gain = 0;
                for (std::size_t j = 0; j < most_chords; ++j)
                    if (const int x = place.x()[j]; move.z[j] != 0)
                        gain += logarithm(x + t * move.z[j]) - logarithm(x);
                if (gain > best) {
                    best = gain;
                    chosen = &move;
                    step = t;
                }
            }
        }
        if (chosen == nullptr)
            return;
        place.go(*chosen, step);
    }
}

class Walk {
public:
    Walk(const Layout &type, const WalkQuery &query) : type_(type), query_(query), random_(query.seed) {}

    std::vector<Found> run(const Multiplicities &x) {
        if (type_.moves.empty()) {
            collect(Place(x).x(), face_count(type_, x));
            return std::move(found_);
        }
        Place place(x);
        if (!approach(place, face_count(type_, x)))
            return {};
        place = Place(x);
        centre(type_.moves, place);
        std::int64_t faces = face_count(type_, multiplicities(place.x()));
        collect(place.x(), faces);
        for (int step = 0; step < query_.effort && !place.far(); ++step) {
            const Next next = look_around(place, faces, true);
            if (exact_ >= enough)
                break;
            if (next.move != nullptr) {
                follow(place, faces, *next.move, next.t);
                continue;
            }
            if (!near(faces))
                break; // the count is out of reach here
            const Move &move = type_.moves[random_() % type_.moves.size()];
            const Steps range = place.steps(move);
            const auto width = static_cast<std::uint64_t>(range.most - range.fewest + 1);
            follow(place, faces, move, range.fewest + static_cast<int>(random_() % width));
        }
        return std::move(found_);
    }

private:
    static constexpr int enough = 12; // of the wanted count

    struct Next {
        const Move *move = nullptr; // nothing is nearer
        int t = 0;
    };

    bool in_range(std::int64_t faces) const {
        return faces >= query_.fewest_faces && faces <= query_.most_faces;
    }

    bool near(std::int64_t faces) const {
        return in_range(faces) || std::abs(faces - query_.faces) <= 8 + query_.faces / 16;
    }

    // Whether the count comes near by the best move each time: most types are ruled out so.
    bool approach(Place &place, std::int64_t faces) {
        for (int step = 0; step < 6 && !place.far() && !near(faces); ++step) {
            const Next next = look_around(place, faces, false);
            if (next.move == nullptr)
                return false;
            follow(place, faces, *next.move, next.t);
        }
        return near(faces);
    }

    static void follow(Place &place, std::int64_t &faces, const Move &move, int t) {
        faces += Change{place.slope(move), move.curvature}.at(t);
        place.go(move, t);
    }

    // The step to the nearest face count.
    Next look_around(const Place &place, std::int64_t faces, bool collecting) {
        Next next;
        std::int64_t nearest = std::abs(faces - query_.faces);
        for (const Move &move : type_.moves) {
            const Steps range = place.steps(move);
            if (range.fewest >= range.most)
                continue;
            const Change change{place.slope(move), move.curvature};
            for (const int t : promising(change, query_.faces - faces, range)) {
                const std::int64_t reached = faces + change.at(t);
                if (collecting && t != 0 && in_range(reached))
                    collect(place.moved(move, t), reached);
                if (const std::int64_t miss = std::abs(reached - query_.faces); miss < nearest) {
                    nearest = miss;
                    next = {&move, t};
                }
            }
        }
        return next;
    }

    void collect(const Lanes &x, std::int64_t faces) {
        if (!in_range(faces))
            return;
        Multiplicities copies = multiplicities(x);
        for (const Found &old : found_)
            if (old.x == copies)
                return;
        found_.push_back({std::move(copies), faces});
        exact_ += faces == query_.faces;
    }

    Multiplicities multiplicities(const Lanes &x) const {
        Multiplicities copies(static_cast<std::size_t>(type_.chords));
        for (std::size_t j = 0; j < copies.size(); ++j)
            copies[j] = x[j];
        return copies;
    }

    const Layout &type_;
    const WalkQuery &query_;
    Random random_;
    std::vector<Found> found_;
    int exact_ = 0;
};

} // namespace

std::vector<Found> walk(const Layout &type, const Multiplicities &x, const WalkQuery &query) {
    if (*std::max_element(x.begin(), x.end()) > most_copies)
        return {};
    return Walk(type, query).run(x);
}

} // namespace alphamst::fill
