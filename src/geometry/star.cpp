#include "geometry/star.h"

namespace alphamst::geometry {

Stars::Stars(Quads quads, int vertices)
    : first_(static_cast<std::size_t>(vertices) + 1, 0), sectors_(4 * quads.size()) {
    // Counting sort: after filling, first_[v] has moved from the end to the start of v.
    for (const auto &quad : quads)
        for (const int v : quad)
            ++first_[static_cast<std::size_t>(v)];
    std::size_t sum = 0;
    for (auto &f : first_)
        f = sum += f;
    for (std::size_t q = quads.size(); q-- > 0;)
        for (std::size_t k = 0; k < 4; ++k)
            sectors_[--first_[static_cast<std::size_t>(quads[q][k])]] = {
                quads[q][(k + 1) % 4], quads[q][(k + 2) % 4], quads[q][(k + 3) % 4], static_cast<int>(q)};
}

void grow(const Stars &stars, std::span<const char> fixed, int layers, std::vector<int> &set,
          std::vector<char> &member) {
    std::size_t begin = 0;
    for (int layer = 0; layer < layers; ++layer) {
        const std::size_t end = set.size();
        for (std::size_t i = begin; i < end; ++i)
            for (const Sector &s : stars.at(set[i]))
                for (const int v : {s.next, s.opposite, s.previous}) {
                    const auto w = static_cast<std::size_t>(v);
                    if (!fixed[w] && !member[w]) {
                        member[w] = 1;
                        set.push_back(v);
                    }
                }
        begin = end;
    }
}

} // namespace alphamst::geometry
