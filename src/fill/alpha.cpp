#include "fill/alpha.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "stop.h"

namespace alphamst::fill {
namespace {

// A candidate by its numbers; its parts are solved only for the ones that are returned.
struct Plan {
    Sides outer, core;
    int bridge;
    int core_singularities;
    std::int64_t core_faces;
    std::vector<std::int64_t> transition_faces; // of changed sides; -1: unchanged
    int singularities;
    std::int64_t faces;
    double stretch;
};

double thinness(const Sides &sides) {
    const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
    return std::log(static_cast<double>(*high) / *low);
}

class Search {
public:
    explicit Search(const AlphaQuery &query) : query_(query) {}

    // Richer families are searched only when the simpler ones miss the count.
    std::vector<Plan> run() {
        const int p = query_.perimeter;
        for (int level = 4; level <= query_.most_singularities && plans_.empty(); level += 2)
            for (int b = 1; ring_faces(b, p) + p / 2 - 1 <= query_.most_faces; ++b) {
                Stop::point();
                if (level == 4)
                    for (std::int64_t f = query_.fewest_faces; f <= query_.most_faces; ++f) {
                        Stop::point();
                        rectangle_core(b, f);
                        triangle_core(b, f);
                    }
                else if (level == 6) {
                    pair_core(b);
                    changed_sides(b, 1);
                    pentagon_core(b);
                } else if (level == 8) {
                    changed_sides(b, 2);
                    hexagon_core(b);
                } else if (level == 12)
                    changed_sides(b, 4);
            }
        return std::move(plans_);
    }

private:
    void add(Plan plan) {
        if (plan.faces < query_.fewest_faces || plan.faces > query_.most_faces ||
            plan.singularities < query_.least_singularities || plan.singularities > query_.most_singularities)
            return;
        plans_.push_back(std::move(plan));
    }
    void add_rings(const Sides &core, int b, int inside, std::int64_t core_faces, double stretch) {
        const auto corners = core.size();
        add({core, core, b, inside, core_faces, std::vector<std::int64_t>(corners, -1),
             static_cast<int>(corners) + inside, core_faces + ring_faces(b, query_.perimeter), stretch});
    }

    void rectangle_core(int b, std::int64_t faces) {
        const std::int64_t inner = faces - ring_faces(b, query_.perimeter), half = query_.perimeter / 2;
        const auto root = static_cast<std::int64_t>(
            std::llround(std::sqrt(static_cast<double>(std::max<std::int64_t>(0, half * half - 4 * inner)))));
        if (inner < 1 || root * root != half * half - 4 * inner || (half - root) % 2 != 0)
            return;
        const int c0 = static_cast<int>((half + root) / 2), c1 = static_cast<int>((half - root) / 2);
        if (c1 >= 1)
            add_rings({c0, c1, c0, c1}, b, 0, inner, thinness({c0, c1}));
    }

    void triangle_core(int b, std::int64_t faces) {
        const std::int64_t inner = faces - ring_faces(b, query_.perimeter);
        const int half = query_.perimeter / 2;
        for (int h0 = 1; 3 * h0 <= half; ++h0) // h1 h2 = inner - h0 (h1 + h2)
            for (int h1 = h0; h0 + 2 * h1 <= half; ++h1) {
                const int h2 = half - h0 - h1;
                if (static_cast<std::int64_t>(h0) * h1 + static_cast<std::int64_t>(h2) * (h0 + h1) == inner)
                    add_rings({h2 + h1, h0 + h2, h1 + h0}, b, 1, inner, 0.3 + thinness({h0, h1, h2}));
            }
    }

    // A rectangle-like core whose opposite sides differ carries one 3-5 pair.
    void pair_core(int b) {
        const int half = query_.perimeter / 2;
        const std::int64_t inner = query_.faces - ring_faces(b, query_.perimeter);
        for (int d1 = 1; d1 <= std::min(8, half / 3); ++d1)
            for (int d2 = d1 % 2; d2 <= d1; d2 += 2) {
                const int sum = half - (d1 + d2) / 2; // n2 + n3
                for (int n2 = 2; n2 + 2 <= sum; ++n2) {
                    const Sides sides{n2 + d1, sum - n2 + d2, n2, sum - n2};
                    const auto form = pair(sides);
                    if (!form)
                        continue;
                    for (int u = 1; u <= form->most_u; ++u) {
                        const std::int64_t rest = inner - form->faces(u, 0);
                        if (rest % d1 != 0 || rest / d1 < 1 || rest / d1 > form->most_v)
                            continue;
                        add_rings(sides, b, 2, inner, thinness(sides));
                        break;
                    }
                }
            }
    }

    // N = 5 with nearly even spokes.
    void pentagon_core(int b) {
        const int half = query_.perimeter / 2, even = half / 5;
        const std::int64_t inner = query_.faces - ring_faces(b, query_.perimeter);
        for (int code = 0; code < 625; ++code) {
            std::vector<int> h(5);
            for (int i = 0, rest = code; i < 4; ++i, rest /= 5)
                h[static_cast<std::size_t>(i)] = even + rest % 5 - 2;
            h[4] = half - h[0] - h[1] - h[2] - h[3];
            if (*std::min_element(h.begin(), h.end()) < 1 || spoke_faces(h) != inner)
                continue;
            Sides sides;
            for (std::size_t i = 0; i < 5; ++i)
                sides.push_back(h[(i + 4) % 5] + h[(i + 1) % 5]);
            add_rings(sides, b, 1, inner, 1 + thinness(h));
        }
    }

    // N = 6 with nearly even sides and two valence-5 vertices inside.
    void hexagon_core(int b) {
        const std::int64_t p = query_.perimeter, inner = query_.faces - ring_faces(b, query_.perimeter);
        if (p < 18 || 32 * inner < p * p || 20 * inner > p * p) // out of reach of such a core
            return;
        Sides sides(6);
        for (std::size_t i = 0, left = static_cast<std::size_t>(p); i < 6; ++i) {
            sides[i] = static_cast<int>(left / (6 - i));
            left -= static_cast<std::size_t>(sides[i]);
        }
        add_rings(sides, b, 2, inner, 2);
    }

    // `changed` transitions of a rectangular core gain or lose 2 kappa edges through a
    // 3-5 pair each: faces b lo + kappa^2 + 2 kappa v, 1 <= v <= b - kappa - 1.
    void changed_sides(int b, int changed) {
        const int half = query_.perimeter / 2;
        for (int kappa = -(b - 2); kappa <= b - 2; ++kappa) {
            const int size = std::abs(kappa), core_half = half - changed * kappa;
            if (size == 0)
                continue;
            for (int c0 = 2; c0 + 2 <= core_half; ++c0) {
                const int c1 = core_half - c0;
                Sides core{c0, c1, c0, c1}, outer = core;
                std::int64_t fixed = static_cast<std::int64_t>(c0) * c1;
                bool positive = true;
                for (int i = 0; i < 4; ++i) {
                    const bool own = changed == 4 || (changed == 2 && i % 2 == 0) || i == 0;
                    int &s = outer[static_cast<std::size_t>(i)];
                    const int c = s;
                    s += own ? 2 * kappa : 0;
                    positive = positive && s >= 2;
                    fixed += static_cast<std::int64_t>(b) * std::min(s, c) + (own ? size * size : 0);
                }
                const std::int64_t rest = query_.faces - fixed;
                const std::int64_t most = b - size - 1;
                if (!positive || rest < 2 * size * changed || rest > 2 * size * changed * most ||
                    rest % (2 * size) != 0)
                    continue;
                Plan plan{outer,
                          core,
                          b,
                          0,
                          static_cast<std::int64_t>(c0) * c1,
                          {-1, -1, -1, -1},
                          4 + 2 * changed,
                          query_.faces,
                          thinness(core) + 0.5 * thinness(outer) + 0.3 * std::abs(changed - 4)};
                std::int64_t steps = rest / (2 * size);
                for (int i = 0, left = changed; i < 4; ++i) {
                    const auto k = static_cast<std::size_t>(i);
                    if (outer[k] == core[k])
                        continue;
                    const std::int64_t v = std::clamp<std::int64_t>(steps / left, 1, most);
                    steps -= v;
                    --left;
                    plan.transition_faces[k] = static_cast<std::int64_t>(b) * std::min(outer[k], core[k]) +
                                               size * size + 2 * size * v;
                }
                add(std::move(plan));
            }
        }
    }

    const AlphaQuery &query_;
    std::vector<Plan> plans_;
};

bool solve_part(Template &part, const Sides &sides, int singularities, std::int64_t faces,
                std::uint64_t seed) {
    PolygonQuery query;
    query.sides = sides;
    query.singularities = singularities;
    query.fewest_faces = query.most_faces = query.faces = faces;
    query.seed = seed;
    auto found = solve(query, 1);
    if (found.empty())
        return false;
    part = std::move(found.front());
    return true;
}

} // namespace

std::vector<AlphaTemplate> solve(const AlphaQuery &query, std::size_t most) {
    std::vector<Plan> plans;
    if (query.perimeter >= 6 && query.perimeter % 2 == 0)
        plans = Search(query).run();
    std::stable_sort(plans.begin(), plans.end(), [&](const Plan &a, const Plan &b) {
        const auto miss_a = std::abs(a.faces - query.faces), miss_b = std::abs(b.faces - query.faces);
        if (miss_a != miss_b)
            return miss_a < miss_b;
        return a.singularities != b.singularities ? a.singularities < b.singularities : a.stretch < b.stretch;
    });
    std::vector<AlphaTemplate> result;
    for (const Plan &plan : plans) {
        if (result.size() >= most)
            break;
        AlphaTemplate chosen{plan.outer, plan.core,  plan.bridge,        {},
                             {},         plan.faces, plan.singularities, plan.stretch};
        bool complete =
            solve_part(chosen.centre, plan.core, plan.core_singularities, plan.core_faces, query.seed);
        for (std::size_t i = 0; i < plan.core.size() && complete; ++i) {
            const int b = plan.bridge, s = plan.outer[i], c = plan.core[i];
            const bool changed = plan.transition_faces[i] >= 0;
            complete =
                solve_part(chosen.transitions.emplace_back(), {s, b, c, b}, changed ? 2 : 0,
                           changed ? plan.transition_faces[i] : static_cast<std::int64_t>(b) * s, query.seed);
        }
        if (complete)
            result.push_back(std::move(chosen));
    }
    return result;
}

Filling build(const AlphaTemplate &chosen, int offset) {
    const std::size_t n = chosen.core.size();
    const int perimeter = std::accumulate(chosen.outer.begin(), chosen.outer.end(), 0);
    Filling whole{perimeter, perimeter, {}};
    std::vector<int> core_loop, core_corner;
    for (const int c : chosen.core) {
        core_corner.push_back(whole.vertices);
        for (int k = 0; k < c; ++k)
            core_loop.push_back(whole.vertices++);
    }
    std::vector<std::vector<int>> bridges; // from the boundary inwards
    for (std::size_t i = 0, outer = static_cast<std::size_t>(offset); i < n; ++i) {
        bridges.push_back({static_cast<int>(outer) % perimeter});
        for (int k = 1; k < chosen.bridge; ++k)
            bridges.back().push_back(whole.vertices++);
        bridges.back().push_back(core_corner[i]);
        outer += static_cast<std::size_t>(chosen.outer[i]);
    }
    append(whole, build(chosen.centre, chosen.core), core_loop);
    for (std::size_t i = 0, first = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const int s = chosen.outer[i], c = chosen.core[i], b = chosen.bridge;
        std::vector<int> loop;
        for (int k = 0; k < s; ++k)
            loop.push_back((bridges[i][0] + k) % perimeter);
        loop.insert(loop.end(), bridges[next].begin(), bridges[next].end());
        for (int k = c - 1; k > 0; --k)
            loop.push_back(core_loop[first + static_cast<std::size_t>(k)]);
        for (int k = b; k > 0; --k)
            loop.push_back(bridges[i][static_cast<std::size_t>(k)]);
        append(whole, build(chosen.transitions[i], {s, b, c, b}), loop);
        first += static_cast<std::size_t>(c);
    }
    return whole;
}

} // namespace alphamst::fill
