// Surfaces for the tests of this folder.
#pragma once

#include <array>
#include <vector>

#include "surface/surface.h"

namespace alphamst::surface {

// A grid of n x m cells, each of two triangles, at places that `place` tells.
template <class Place> Surface grid(int n, int m, const Place &place) {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<int, 3>> triangles;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i)
            points.push_back(place(static_cast<double>(i) / n, static_cast<double>(j) / m));
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return {points, triangles};
}

} // namespace alphamst::surface
