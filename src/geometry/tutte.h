// The graph Laplacian of the free vertices with uniform weights (Tutte 1963), factored
// once for several sets of fixed positions.
#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "geometry/star.h"

namespace alphamst::geometry {

class Tutte {
public:
    // Free vertices have a closed star: each edge at one is the edge to next of one sector.
    Tutte(const Stars &stars, std::span<const char> fixed);

    // Puts every free vertex at the mean of its neighbours. False if the system is
    // singular (a free vertex not connected to a fixed one).
    bool solve(Points &points) const;

private:
    const Stars &stars_;
    std::vector<int> free_;  // vertices by unknown
    std::vector<int> index_; // unknown by vertex, -1 if fixed
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

// A loop with edges of these lengths on a circle of its length around the origin.
Points loop_on_circle(std::span<const double> lengths);

} // namespace alphamst::geometry
