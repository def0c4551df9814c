#include "fill/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "fill/library.h"
#include "fill/start.h"
#include "fill/walk.h"

namespace alphamst::fill {
namespace {

double evenness(const Multiplicities &x) {
    double sum = 0;
    for (const int copies : x)
        sum += std::log(static_cast<double>(copies));
    return sum;
}

// The sides from another one on, or backwards.
struct Turn {
    Sides sides;
    int first;
    bool mirror;
};

std::vector<Turn> different_turns(const Sides &sides) {
    const int n = static_cast<int>(sides.size());
    std::vector<Turn> turns;
    for (const bool mirror : {false, true})
        for (int first = 0; first < n; ++first) {
            Sides turned;
            for (int i = 0; i < n; ++i)
                turned.push_back(sides[static_cast<std::size_t>((mirror ? first - i + n : first + i) % n)]);
            if (std::none_of(turns.begin(), turns.end(),
                             [&](const Turn &old) { return old.sides == turned; }))
                turns.push_back({std::move(turned), first, mirror});
        }
    return turns;
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
    const std::vector<Turn> turns = different_turns(query.sides);
    std::uint64_t seed = query.seed;
    int exact = 0, walks = 0;
    for (const Layout &type : types(static_cast<int>(query.sides.size()), query.singularities))
        for (const Turn &turn : turns) {
            const auto x = start(type, turn.sides);
            if (!x)
                continue;
            if (walks++ >= query.walks && (!all.empty() || query.fewest_faces == query.most_faces))
                return best(query, std::move(all), most);
            const WalkQuery goal{query.fewest_faces, query.most_faces, query.faces, query.effort, ++seed};
            for (Found &found : walk(type, *x, goal)) {
                const double even = evenness(found.x);
                exact += found.faces == query.faces;
                all.push_back({&type, std::move(found.x), turn.first, turn.mirror, found.faces,
                               type.singularities(), even});
            }
            if (exact >= query.enough)
                return best(query, std::move(all), most);
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
