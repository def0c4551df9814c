// The Cholesky factors of a symmetric matrix of blocks of 2 by 2: of the two coordinates of vertices.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace alphamst::geometry {

// A = L D L^T row by row, see T. A. Davis, Algorithm 849 (2005), there for numbers. Blocks share their
// indices, which makes it several times faster than one for numbers; nothing is known of pivots, so that A
// must be positive definite.
class BlockCholesky {
public:
    // pairs: indices below n of the blocks beside the diagonal that are not 0, in any order, each once or
    // more. The order of elimination is that of least degrees (AMD).
    BlockCholesky(int n, std::span<const std::array<int, 2>> pairs);

    // Where the block in a row and a column is, or the one that is its transpose. It must be there.
    struct Slot {
        int block = -1;
        bool transposed = false;
    };
    Slot slot(int row, int column) const;

    void set_zero();
    // To a block on the diagonal, which its transpose is equal to, or to one beside it and, by symmetry, to
    // its transpose.
    void add(Slot slot, const Eigen::Matrix2d &block) {
        auto &sum = values_[static_cast<std::size_t>(slot.block)];
        if (slot.transposed)
            sum += block.transpose();
        else
            sum += block;
    }
    double trace() const;

    // Of A with a number added to its diagonal; false if that is not positive definite.
    bool factor(double shift);
    // After a factor.
    Eigen::VectorXd solve(const Eigen::VectorXd &right) const;

private:
    void analyse();

    // In the order of elimination: the blocks of a row up to the diagonal, which comes last.
    std::vector<int> place_; // of an index, in the order of elimination
    std::vector<int> first_, column_;
    std::vector<Eigen::Matrix2d> values_;
    // By columns: those of L transposed, below the diagonal, and the inverse of D.
    std::vector<int> parent_, factor_first_, factor_row_;
    std::vector<Eigen::Matrix2d> factor_, inverse_;
};

} // namespace alphamst::geometry
