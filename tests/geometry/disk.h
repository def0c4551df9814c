// Disks of quads with their loop first, and loops to put them in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "geometry/embed.h"

namespace alphamst::geometry::samples {

using QuadList = std::vector<std::array<int, 4>>;

struct Disk {
    QuadList quads;
    int boundary = 0, vertices = 0;
    std::vector<int> loop; // names the boundary vertices had
};

// Renumbers quads so that the loop comes first, counter-clockwise from its smallest vertex.
inline Disk disk(const QuadList &quads) {
    std::set<std::pair<int, int>> edges;
    for (const auto &q : quads)
        for (std::size_t k = 0; k < 4; ++k)
            edges.insert({q[k], q[(k + 1) % 4]});
    std::map<int, int> next, name;
    for (const auto &[a, b] : edges)
        if (!edges.count({b, a}))
            next[a] = b;
    Disk d;
    int v = next.begin()->first;
    do {
        name.insert({v, static_cast<int>(name.size())});
        d.loop.push_back(v);
        v = next[v];
    } while (v != d.loop.front());
    d.boundary = static_cast<int>(name.size());
    for (const auto &q : quads) {
        d.quads.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
            d.quads.back()[k] = name.insert({q[k], static_cast<int>(name.size())}).first->second;
    }
    d.vertices = static_cast<int>(name.size());
    return d;
}

template <class Keep> QuadList grid(int n, int m, Keep keep) {
    QuadList quads;
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            if (keep(i, j)) {
                const int v = j * (n + 1) + i;
                quads.push_back({v, v + 1, v + n + 2, v + n + 1});
            }
    return quads;
}
inline QuadList grid(int n, int m) {
    return grid(n, m, [](int, int) { return true; });
}

// Layers of quads around a disk: its corners become vertices of valence 3.
inline QuadList surround(QuadList quads, int layers) {
    for (int layer = 0; layer < layers; ++layer) {
        const std::vector<int> loop = disk(quads).loop;
        int first = 0;
        for (const auto &q : quads)
            for (const int v : q)
                first = std::max(first, v + 1);
        const int n = static_cast<int>(loop.size());
        for (int i = 0; i < n; ++i) {
            const int j = (i + 1) % n;
            quads.push_back(
                {loop[static_cast<std::size_t>(j)], loop[static_cast<std::size_t>(i)], first + i, first + j});
        }
    }
    return quads;
}

// The loop of a disk cut from a grid of n columns, each vertex (i, j) put at map(i, j).
template <class Map> Points place(const Disk &d, int n, Map map) {
    Points loop;
    for (const int v : d.loop)
        loop.push_back(map(v % (n + 1), v / (n + 1)));
    return loop;
}

inline Points star(int n, double amplitude) {
    Points loop;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n, r = 1 + amplitude * std::cos(5 * a);
        loop.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return loop;
}

} // namespace alphamst::geometry::samples
