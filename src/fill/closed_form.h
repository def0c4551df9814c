// Closed forms for polygons: disks with N corners of one face and flat sides of n_0 ..
// n_{N-1} edges, singularities strictly inside.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace alphamst::fill {

using Sides = std::vector<int>;

// One singularity of valence N (Tarini 2021): spokes h_i to side i with
// n_i = h_{i-1} + h_{i+1}, N = 3 or 5; nothing unless every h_i >= 1.
std::optional<std::vector<int>> spokes(const Sides &sides);
// Faces of that filling: sum of h_i h_{i+1}.
std::int64_t spoke_faces(const std::vector<int> &h);

// A 3-5 pair in a four-sided patch, sides turned and mirrored so that
// n0 - n2 >= |n1 - n3|: F(u, v) = n1 n2 - (n1 - n3) u + (n0 - n2) v + a c.
struct Pair {
    int d1, d2, a, c;   // d1 = n0 - n2, d2 = n1 - n3, a = (d1 - d2) / 2, c = (d1 + d2) / 2
    int most_u, most_v; // 1 <= u <= most_u, 1 <= v <= most_v
    std::int64_t faces(int u, int v) const {
        return base - static_cast<std::int64_t>(d2) * u + static_cast<std::int64_t>(d1) * v;
    }
    std::int64_t base;
};
std::optional<Pair> pair(const Sides &sides);

// b closed rings around a boundary of p edges: b p faces, no singularity.
constexpr std::int64_t ring_faces(int b, int p) { return static_cast<std::int64_t>(b) * p; }

// Fewest valence-3/5 vertices of a polygon with 1 to 6 corners and sides >= 3; -1 if
// the perimeter is odd. From exhaustive search with the exact filler; a chord that
// returns to its own side cuts off two corners and so costs two valence-3 vertices.
int least_singularities(const Sides &n);

} // namespace alphamst::fill
