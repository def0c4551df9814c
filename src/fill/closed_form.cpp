#include "fill/closed_form.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace alphamst::fill {

std::optional<std::vector<int>> spokes(const Sides &sides) {
    const std::size_t n = sides.size();
    if ((n != 3 && n != 5) || std::accumulate(sides.begin(), sides.end(), 0) % 2 != 0)
        return std::nullopt;
    std::vector<int> h(n);
    for (std::size_t i = 0; i < n; ++i) {
        auto side = [&](std::size_t offset) { return sides[(i + offset) % n]; };
        const int twice =
            n == 3 ? side(2) + side(1) - side(0) : side(4) + side(0) + side(1) - side(3) - side(2);
        h[i] = twice / 2;
        if (twice < 2)
            return std::nullopt;
    }
    return h;
}

std::int64_t spoke_faces(const std::vector<int> &h) {
    std::int64_t faces = 0;
    for (std::size_t i = 0; i < h.size(); ++i)
        faces += static_cast<std::int64_t>(h[i]) * h[(i + 1) % h.size()];
    return faces;
}

std::optional<Pair> pair(const Sides &sides) {
    if (sides.size() != 4 || std::accumulate(sides.begin(), sides.end(), 0) % 2 != 0)
        return std::nullopt;
    Sides n = sides;
    for (int turn = 0; turn < 8; ++turn) {
        if (n[0] - n[2] >= std::abs(n[1] - n[3]))
            break;
        if (turn == 3)
            std::reverse(n.begin(), n.end());
        else
            std::rotate(n.begin(), n.begin() + 1, n.end());
    }
    Pair pair{};
    pair.d1 = n[0] - n[2];
    pair.d2 = n[1] - n[3];
    pair.a = (pair.d1 - pair.d2) / 2;
    pair.c = (pair.d1 + pair.d2) / 2;
    pair.most_u = n[2] - 1;
    pair.most_v = n[3] - pair.a - 1;
    pair.base = static_cast<std::int64_t>(n[1]) * n[2] + static_cast<std::int64_t>(pair.a) * pair.c;
    if (pair.d1 == 0 || pair.most_u < 1 || pair.most_v < 1)
        return std::nullopt;
    return pair;
}

namespace {

// Two valence-5 vertices in a hexagon: take off the chords between opposite sides of one or two
// neighbouring classes and the two side triples must be triangles.
bool two_fives(const Sides &n) {
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const int most_a = std::min(n[a], n[a + 3]), most_b = std::min(n[b], n[b + 3]);
        for (int ta = 0; ta < most_a; ++ta)
            for (int tb = 0; tb < most_b; ++tb) {
                Sides rest = n;
                rest[a] -= ta, rest[a + 3] -= ta, rest[b] -= tb, rest[b + 3] -= tb;
                if (spokes({rest[0], rest[2], rest[4]}) && spokes({rest[1], rest[3], rest[5]}))
                    return true;
            }
    }
    return false;
}

} // namespace

int least_singularities(const Sides &n) {
    const int total = std::accumulate(n.begin(), n.end(), 0);
    const int longest = *std::max_element(n.begin(), n.end());
    const int margin = 2 * longest - total;
    if (total % 2 != 0)
        return -1;
    switch (n.size()) {
    case 1:
        return 3;
    case 2:
        return 2;
    case 3:
        return spokes(n) ? 1 : 3;
    case 4:
        return n[0] == n[2] && n[1] == n[3] ? 0 : margin <= -4 ? 2 : 4;
    case 5:
        return spokes(n) ? 1 : margin <= -6 ? 3 : 5;
    case 6:
        return two_fives(n) ? 2 : margin <= -8 ? 4 : 6;
    default:
        return std::abs(static_cast<int>(n.size()) - 4);
    }
}

} // namespace alphamst::fill
