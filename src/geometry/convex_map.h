// Maps to the plane that put every free vertex at a weighted mean of its neighbours (Floater 1997).
#pragma once

#include <Eigen/SparseLU>
#include <span>
#include <vector>

#include "geometry/parametrise.h"

namespace alphamst::geometry {

// Positive weights, not symmetric: the one of an edge is another seen from its other end.
class ConvexMap {
public:
    // The loop of the disk is on a circle of its length around the origin. Starts with the weights of mean
    // value coordinates.
    explicit ConvexMap(const Disk &disk);

    // Divides the weight of each vertex, for all of its neighbours, by its share.
    void weigh_down(std::span<const double> share);

    // None where there is no solution.
    Points solve();

private:
    struct Edge {
        int from, to; // free, any vertex
        double weight;
    };

    bool factorise();

    int boundary_;
    Points circle_;
    int free_;                // vertices
    std::vector<Edge> edges_; // by from
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factor_;
    bool analysed_ = false;
};

} // namespace alphamst::geometry
