#include "geometry/colour.h"

#include <cstdint>

namespace alphamst::geometry {

std::vector<std::vector<int>> colour(const Problem &problem) {
    constexpr int none = -1;
    std::vector<int> of(static_cast<std::size_t>(problem.stars.vertices()), none);
    std::vector<std::vector<int>> classes;
    std::vector<int> seen; // [class] the last vertex with a neighbour of it
    for (int v = 0; v < problem.stars.vertices(); ++v) {
        const auto star = problem.stars.at(v);
        if (problem.fixed[static_cast<std::size_t>(v)] || star.empty())
            continue;
        for (const Sector &s : star)
            for (const int w : {s.next, s.opposite, s.previous})
                if (const int c = of[static_cast<std::size_t>(w)]; c != none)
                    seen[static_cast<std::size_t>(c)] = v;
        std::size_t c = 0;
        while (c < classes.size() && seen[c] == v)
            ++c;
        if (c == classes.size()) {
            classes.emplace_back();
            seen.push_back(none);
        }
        classes[c].push_back(v);
        of[static_cast<std::size_t>(v)] = static_cast<int>(c);
    }
    return classes;
}

} // namespace alphamst::geometry
