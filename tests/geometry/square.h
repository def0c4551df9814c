// Squares of quads for the tests of this folder.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "geometry/embed.h"

namespace alphamst::geometry::samples {

struct Square {
    std::vector<std::array<int, 4>> quads;
    std::vector<char> fixed;
    Points points;
};

// An n x n grid, its boundary fixed, its interior moved at random by up to `noise`.
inline Square noisy(int n, double noise, unsigned seed) {
    Square s;
    std::mt19937 random(seed);
    const auto shift = [&] {
        return noise * (2.0 * static_cast<double>(random()) / std::mt19937::max() - 1);
    };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const bool inside = i > 0 && j > 0 && i < n && j < n;
            const double x = inside ? shift() : 0, y = inside ? shift() : 0;
            s.fixed.push_back(!inside);
            s.points.emplace_back(i + x, j + y);
            const int v = j * (n + 1) + i;
            if (i < n && j < n)
                s.quads.push_back({v, v + 1, v + n + 2, v + n + 1});
        }
    return s;
}

} // namespace alphamst::geometry::samples
