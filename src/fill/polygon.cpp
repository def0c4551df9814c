#include "fill/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "fill/library.h"
#include "fill/random.h"

namespace alphamst::fill {
namespace {

// Multiplicities >= 1 with given side lengths, near the middle of what is possible.
class Start {
public:
    Start(const Layout &type, const Sides &sides) : type_(type) {
        const auto chords = static_cast<std::size_t>(type.chords);
        x_.assign(chords, 1);
        for (std::size_t i = 0; i < sides.size(); ++i)
            rest_.push_back(sides[i] -
                            std::accumulate(type.incidence[i].begin(), type.incidence[i].end(), 0));
        // A side with few open chords is the tightest; its chords come first.
        std::vector<char> used(chords, 0);
        while (order_.size() < chords) {
            std::size_t best = 0;
            int fewest = 99;
            for (std::size_t i = 0; i < rest_.size(); ++i) {
                int open = 0;
                for (std::size_t j = 0; j < chords; ++j)
                    open += !used[j] && type.incidence[i][j] != 0;
                if (open > 0 && open < fewest)
                    fewest = open, best = i;
            }
            const std::size_t before = order_.size();
            for (std::size_t j = 0; j < chords; ++j)
                if (!used[j] && (fewest == 99 || type.incidence[best][j] != 0)) {
                    used[j] = 1;
                    order_.push_back(j);
                }
            if (order_.size() == before)
                break;
        }
    }

    std::optional<Multiplicities> find() {
        if (*std::min_element(rest_.begin(), rest_.end()) < 0 || !visit(0))
            return std::nullopt;
        return x_;
    }

private:
    bool visit(std::size_t position) {
        if (position == order_.size())
            return std::all_of(rest_.begin(), rest_.end(), [](int r) { return r == 0; });
        if (--budget_ < 0)
            return false;
        const std::size_t j = order_[position];
        int most = 1 << 20, low = 0, sharing = 1;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const int ends = type_.incidence[i][j];
            if (ends == 0)
                continue;
            most = std::min(most, rest_[i] / ends);
            int later = 0;
            for (std::size_t p = position + 1; p < order_.size(); ++p)
                later += type_.incidence[i][order_[p]] != 0;
            sharing = std::max(sharing, later + 1);
            if (later == 0)
                low = std::max(low, rest_[i] % ends == 0 ? rest_[i] / ends : 1 << 21);
        }
        if (most == 1 << 20)
            most = 0; // a cyclic chord: one copy
        const int middle = std::clamp(most / sharing, low, std::max(low, most));
        for (int step = 0; low <= most && step <= 2 * (most - low); ++step) {
            const int value = middle + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
            if (value < low || value > most)
                continue;
            change(j, value);
            if (visit(position + 1))
                return true;
            change(j, -value);
        }
        return false;
    }

    void change(std::size_t j, int by) {
        x_[j] += by;
        for (std::size_t i = 0; i < rest_.size(); ++i)
            rest_[i] -= type_.incidence[i][j] * by;
    }

    const Layout &type_;
    Multiplicities x_;
    std::vector<int> rest_;
    std::vector<std::size_t> order_;
    int budget_ = 400;
};

double evenness(const Multiplicities &x) {
    double sum = 0;
    for (const int copies : x)
        sum += std::log(static_cast<double>(copies));
    return sum;
}

struct Steps {
    std::int64_t fewest, most; // t with x + t z >= 1
};

Steps steps(const Multiplicities &x, const Multiplicities &z) {
    Steps range{-1000000, 1000000};
    for (std::size_t j = 0; j < x.size(); ++j) {
        const int spare = x[j] - 1; // entries of a move are -2 to 2: halving beats division
        if (z[j] > 0)
            range.fewest = std::max<std::int64_t>(range.fewest, -(spare >> (z[j] - 1)));
        else if (z[j] < 0)
            range.most = std::min<std::int64_t>(range.most, spare >> (-z[j] - 1));
    }
    return range;
}

Multiplicities moved(const Multiplicities &x, const Multiplicities &z, std::int64_t t) {
    Multiplicities y = x;
    for (std::size_t j = 0; j < y.size(); ++j)
        y[j] += static_cast<int>(t) * z[j];
    return y;
}

// F(x + t z) = F + t g + t^2 q.
struct Change {
    std::int64_t g, q;
    std::int64_t at(std::int64_t t) const { return t * (g + t * q); }
};

Change change_along(const Layout::Move &move, const Multiplicities &x) {
    return {std::inner_product(x.begin(), x.end(), move.slope.begin(), std::int64_t{0}), move.curvature};
}

// Steps t in range nearest to F(t) = wanted: around the real roots or the vertex.
std::array<std::int64_t, 5> promising(Change change, std::int64_t wanted, Steps range) {
    const auto g = static_cast<double>(change.g), q = static_cast<double>(change.q);
    std::array<double, 2> roots{0, 0};
    if (change.q == 0) {
        if (change.g != 0)
            roots.fill(static_cast<double>(wanted) / g);
    } else {
        const double root = std::sqrt(std::max(0.0, g * g + 4 * q * static_cast<double>(wanted)));
        roots = {(-g + root) / (2 * q), (-g - root) / (2 * q)};
    }
    std::array<std::int64_t, 5> t{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto floor = static_cast<std::int64_t>(std::floor(std::clamp(roots[i], -1e6, 1e6)));
        t[2 * i] = std::clamp(floor, range.fewest, range.most);
        t[2 * i + 1] = std::clamp(floor + 1, range.fewest, range.most);
    }
    return t;
}

// Climbs to where the product of the multiplicities is largest.
void centre(const Layout &type, Multiplicities &x) {
    for (int round = 0; round < 12; ++round) {
        double best = 1 + 1e-9;
        const Layout::Move *move = nullptr;
        std::int64_t step = 0;
        for (const Layout::Move &candidate : type.moves) {
            const Steps range = steps(x, candidate.z);
            for (const std::int64_t t : {-4, -1, 1, 4}) {
                if (t < range.fewest || t > range.most)
                    continue;
                double gain = 1;
                for (std::size_t j = 0; j < x.size(); ++j)
                    if (candidate.z[j] != 0)
                        gain *= static_cast<double>(x[j] + t * candidate.z[j]) / x[j];
                if (gain > best) {
                    best = gain;
                    move = &candidate;
                    step = t;
                }
            }
        }
        if (move == nullptr)
            return;
        x = moved(x, move->z, step);
    }
}

// Walks over the multiplicities of one type from the centre and collects those in range.
class Walk {
public:
    Walk(const Layout &type, const PolygonQuery &query, std::uint64_t seed)
        : type_(type), query_(query), random_(seed) {}

    void run(Multiplicities x) {
        collect(x, face_count(type_, x));
        for (int step = 0; step < query_.effort && !type_.moves.empty(); ++step) {
            const std::int64_t faces = face_count(type_, x);
            std::int64_t nearest = std::abs(faces - query_.faces);
            Multiplicities best;
            for (const Layout::Move &move : type_.moves) {
                const Multiplicities &z = move.z;
                const Steps range = steps(x, z);
                if (range.fewest >= range.most)
                    continue;
                const Change change = change_along(move, x);
                for (const std::int64_t t : promising(change, query_.faces - faces, range)) {
                    const std::int64_t reached = faces + change.at(t);
                    const std::int64_t miss = std::abs(reached - query_.faces);
                    if (t != 0 && reached >= query_.fewest_faces && reached <= query_.most_faces)
                        collect(moved(x, z, t), reached);
                    if (miss < nearest)
                        nearest = miss, best = moved(x, z, t);
                }
            }
            if (enough())
                return;
            if (!best.empty()) {
                x = std::move(best);
                continue;
            }
            if (nearest > 8 + query_.faces / 16)
                return; // the count is out of reach here
            const auto &z = type_.moves[random_() % type_.moves.size()].z;
            const Steps range = steps(x, z);
            const auto width = static_cast<std::uint64_t>(range.most - range.fewest + 1);
            x = moved(x, z, range.fewest + static_cast<std::int64_t>(random_() % width));
        }
    }

    std::vector<Template> found;

private:
    void collect(const Multiplicities &x, std::int64_t faces) {
        if (faces < query_.fewest_faces || faces > query_.most_faces)
            return;
        for (const Template &old : found)
            if (old.x == x)
                return;
        found.push_back({&type_, x, 0, false, faces, type_.singularities(), evenness(x)});
    }
    bool enough() const {
        return std::count_if(found.begin(), found.end(),
                             [&](const Template &t) { return t.faces == query_.faces; }) >= 12;
    }

    const Layout &type_;
    const PolygonQuery &query_;
    Random random_;
};

Sides turned(const Sides &sides, int first, bool mirror) {
    const int n = static_cast<int>(sides.size());
    Sides result;
    for (int i = 0; i < n; ++i)
        result.push_back(sides[static_cast<std::size_t>(mirror ? (first - i + 2 * n) % n : (first + i) % n)]);
    return result;
}

std::vector<Template> best(const PolygonQuery &query, std::vector<Template> all, std::size_t most) {
    std::stable_sort(all.begin(), all.end(), [&](const Template &a, const Template &b) {
        const auto miss_a = std::abs(a.faces - query.faces), miss_b = std::abs(b.faces - query.faces);
        return miss_a != miss_b ? miss_a < miss_b : a.evenness > b.evenness;
    });
    if (all.size() > most)
        all.resize(most);
    return all;
}

} // namespace

std::vector<Template> solve(const PolygonQuery &query, std::size_t most) {
    std::vector<Template> all;
    const int n = static_cast<int>(query.sides.size());
    std::uint64_t seed = query.seed;
    int exact = 0, walks = 0;
    for (const Layout &type : types(n, query.singularities)) {
        std::vector<Sides> tried;
        for (int mirror = 0; mirror < 2; ++mirror)
            for (int first = 0; first < n; ++first) {
                const Sides sides = turned(query.sides, first, mirror != 0);
                if (std::find(tried.begin(), tried.end(), sides) != tried.end())
                    continue;
                tried.push_back(sides);
                auto x = Start(type, sides).find();
                if (!x)
                    continue;
                centre(type, *x);
                if (walks++ >= query.walks && (!all.empty() || query.fewest_faces == query.most_faces))
                    return best(query, std::move(all), most);
                Walk walk(type, query, ++seed);
                walk.run(std::move(*x));
                for (Template &t : walk.found) {
                    t.first_side = first;
                    t.mirrored = mirror != 0;
                    exact += t.faces == query.faces;
                    all.push_back(std::move(t));
                }
                if (exact >= query.enough)
                    return best(query, std::move(all), most);
            }
    }
    return best(query, std::move(all), most);
}

Filling build(const Template &chosen, const Sides &sides) {
    Filling filling = expand(*chosen.type, chosen.x);
    // The type's boundary starts at the corner before its first side. Mirrored, that side
    // runs backwards: its start is the end of the polygon's side.
    if (chosen.mirrored) {
        filling = mirrored(filling);
        const int length = sides[static_cast<std::size_t>(chosen.first_side)];
        filling = rotated(filling, filling.boundary - length);
    }
    const int before = std::accumulate(sides.begin(), sides.begin() + chosen.first_side, 0);
    return rotated(filling, (filling.boundary - before) % filling.boundary);
}

} // namespace alphamst::fill
