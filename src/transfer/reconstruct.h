// Values on the cells of a mesh, from the means on those of another one that they overlap.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "transfer/cell.h"
#include "transfer/overlap.h"

namespace alphamst::transfer {

class Reconstruction {
public:
    // Overlaps that together are the cells of the mesh after the operation that are to have values. The mesh
    // before must outlive this.
    Reconstruction(const Cells &before, std::vector<Overlap> overlaps);

    // The means of these cells. linear: the field before is on each cell the linear function with its mean
    // and the gradient that fits its neighbours best (least squares, exact for linear functions), made less
    // steep until no overlap has a mean beyond those of the neighbours (Barth and Jespersen 1989); else it is
    // constant there.
    void average(std::span<const double> from, std::span<double> to, int components, bool linear);

private:
    // Of a cell before.
    struct Stencil {
        int cell;
        Eigen::Vector3d centroid;
        std::size_t begin, end; // in neighbours_ and weights_
    };
    struct Slope {
        Eigen::Vector3d gradient;
        double low, high; // of the cell and its neighbours
    };
    void fit();
    void fit(int cell, std::vector<std::optional<Eigen::Vector3d>> &centroids);
    // [stencils] of one component.
    std::vector<Slope> slopes(std::span<const double> from, std::size_t width, std::size_t component) const;

    const Cells before_;
    std::vector<Overlap> overlaps_;       // by cells after
    std::vector<std::size_t> stencil_of_; // [overlaps]
    std::vector<Stencil> stencils_;
    std::vector<int> neighbours_;
    std::vector<Eigen::Vector3d> weights_; // of the difference to each neighbour in the gradient
};

} // namespace alphamst::transfer
