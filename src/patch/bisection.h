// Two connected sides of a graph with few links between them: the graph grown from some nodes, or cut across
// its longest axes, then refined as by Fiduccia and Mattheyses (1982). The best of these is taken.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "pace.h"
#include "random.h"

namespace alphamst::patch {

// A connected graph whose nodes have places in space and at most four links, as faces have sides.
struct Graph {
    std::size_t size() const { return start.size() - 1; }
    std::span<const std::int32_t> neighbours(std::size_t node) const {
        const auto first = static_cast<std::size_t>(start[node]);
        return std::span(links).subspan(first, static_cast<std::size_t>(start[node + 1]) - first);
    }

    std::vector<std::int32_t> start{0}, links; // those of node i: links[start[i]] .. links[start[i + 1] - 1]
    std::vector<Eigen::Vector3d> places;
};

// Side of every node, 0 or 1. Side 0 has `wanted` nodes, one to size() - 1, or `slack` more or less; farther
// off only where its side would not be connected otherwise.
std::vector<char> bisect(const Graph &graph, std::size_t wanted, std::size_t slack, Random &random,
                         const Pace &pace);

} // namespace alphamst::patch
