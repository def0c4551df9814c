// Crosses: four directions at right angles at every node of a surface, which change little from one node
// to the next and follow guides where there are some.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "pace.h"
#include "surface/rosy.h"

namespace alphamst::surface {

// The nodes of a surface and which are beside which.
struct Links {
    std::vector<Frame> frames;      // [node]
    std::vector<std::size_t> begin; // [nodes + 1] in the next two
    std::vector<int> neighbours;    // each link is with both of its nodes
    std::vector<double> weights;    // above 0, the same at both
};

// A direction in space that the cross of a node shall have among its own; its weight is to be seen beside
// those of links. A node may have several.
struct Guide {
    int node;
    Eigen::Vector3d direction;
    double weight;
};

// One of the four directions of each node, in its plane and of length one. The crosses minimise the sum
// over links and guides of weight * (1 - cos(4 * angle)), as far as `sweeps` of Gauss and Seidel lead on each
// level of a hierarchy of merged nodes, the coarsest first (after Jakob, Tarini, Panozzo and Sorkine-Hornung
// 2015). Costs O(sweeps * (nodes + links)) on a surface; the same for the same input.
std::vector<Eigen::Vector3d> solve_cross_field(const Links &links, std::span<const Guide> guides, int sweeps,
                                               const Pace &pace = {});

} // namespace alphamst::surface
