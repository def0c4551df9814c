#include "geometry/block_cholesky.h"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

#include "index.h"
#include "stop.h"

namespace alphamst::geometry {
namespace {

// The place of each index in the order of elimination.
std::vector<int> order(int n, std::span<const std::array<int, 2>> pairs) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 1);
    for (const auto &[i, j] : pairs) {
        entries.emplace_back(i, j, 1);
        entries.emplace_back(j, i, 1);
    }
    Eigen::SparseMatrix<double> pattern(n, n);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> index_at;
    Eigen::AMDOrdering<int>()(pattern, index_at);
    std::vector<int> place(at(n));
    for (int k = 0; k < n; ++k)
        place[at(index_at.indices()[k])] = k;
    return place;
}

} // namespace

BlockCholesky::BlockCholesky(int n, std::span<const std::array<int, 2>> pairs)
    : place_(n > 0 ? order(n, pairs) : std::vector<int>()) {
    std::vector<std::array<int, 2>> blocks; // row, column
    for (int i = 0; i < n; ++i)
        blocks.push_back({i, i});
    for (const auto &[i, j] : pairs)
        blocks.push_back({std::max(place_[at(i)], place_[at(j)]), std::min(place_[at(i)], place_[at(j)])});
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    first_.assign(at(n) + 1, 0);
    for (const auto &[row, column] : blocks) {
        ++first_[at(row) + 1];
        column_.push_back(column);
    }
    for (std::size_t i = 0; i < at(n); ++i)
        first_[i + 1] += first_[i];
    values_.assign(blocks.size(), Eigen::Matrix2d::Zero());
    analyse();
}

// The elimination tree, and room for each column of the factor.
void BlockCholesky::analyse() {
    const std::size_t n = place_.size();
    parent_.assign(n, -1);
    std::vector<int> reached(n, -1), count(n, 0);
    for (std::size_t k = 0; k < n; ++k) {
        const int row = static_cast<int>(k);
        reached[k] = row;
        for (int p = first_[k]; p < first_[k + 1]; ++p)
            for (int i = column_[at(p)]; reached[at(i)] != row; i = parent_[at(i)]) {
                if (parent_[at(i)] < 0)
                    parent_[at(i)] = row;
                ++count[at(i)];
                reached[at(i)] = row;
            }
    }
    factor_first_.assign(n + 1, 0);
    for (std::size_t k = 0; k < n; ++k)
        factor_first_[k + 1] = factor_first_[k] + count[k];
    factor_row_.resize(at(factor_first_[n]));
    factor_.resize(at(factor_first_[n]));
    inverse_.resize(n);
}

BlockCholesky::Slot BlockCholesky::slot(int row, int column) const {
    const int i = place_[at(row)], j = place_[at(column)];
    const auto from = column_.begin() + first_[at(std::max(i, j))];
    const auto to = column_.begin() + first_[at(std::max(i, j)) + 1];
    return {static_cast<int>(std::lower_bound(from, to, std::min(i, j)) - column_.begin()), i < j};
}

void BlockCholesky::set_zero() { std::fill(values_.begin(), values_.end(), Eigen::Matrix2d::Zero()); }

double BlockCholesky::trace() const {
    double sum = 0;
    for (std::size_t k = 0; k < place_.size(); ++k)
        sum += values_[at(first_[k + 1] - 1)].trace();
    return sum;
}

bool BlockCholesky::factor(double shift) {
    const std::size_t n = place_.size();
    std::vector<Eigen::Matrix2d> row(n, Eigen::Matrix2d::Zero()); // of L D
    std::vector<int> end(factor_first_.begin(), factor_first_.end() - 1), pattern(n), reached(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        Stop::point();
        // The columns of row k, each after those that it depends on.
        std::size_t top = n;
        reached[k] = static_cast<int>(k);
        for (int p = first_[k]; p < first_[k + 1]; ++p) {
            row[at(column_[at(p)])] = values_[at(p)];
            std::size_t length = 0;
            for (int i = column_[at(p)]; reached[at(i)] != static_cast<int>(k); i = parent_[at(i)]) {
                pattern[length++] = i;
                reached[at(i)] = static_cast<int>(k);
            }
            while (length > 0)
                pattern[--top] = pattern[--length];
        }
        Eigen::Matrix2d diagonal = row[k] + shift * Eigen::Matrix2d::Identity();
        for (; top < n; ++top) {
            const std::size_t i = at(pattern[top]);
            const Eigen::Matrix2d scaled = row[i];
            row[i].setZero();
            for (int p = factor_first_[i]; p < end[i]; ++p)
                row[at(factor_row_[at(p)])].noalias() -= scaled * factor_[at(p)];
            const Eigen::Matrix2d transposed = inverse_[i] * scaled.transpose();
            diagonal.noalias() -= scaled * transposed;
            factor_row_[at(end[i])] = static_cast<int>(k);
            factor_[at(end[i]++)] = transposed;
        }
        row[k].setZero();
        if (!(diagonal(0, 0) > 0 && diagonal.determinant() > 0))
            return false;
        inverse_[k] = diagonal.inverse();
    }
    return true;
}

Eigen::VectorXd BlockCholesky::solve(const Eigen::VectorXd &right) const {
    const std::size_t n = place_.size();
    std::vector<Eigen::Vector2d> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[at(place_[i])] = right.segment<2>(2 * static_cast<Eigen::Index>(i));
    for (std::size_t k = 0; k < n; ++k)
        for (int p = factor_first_[k]; p < factor_first_[k + 1]; ++p)
            x[at(factor_row_[at(p)])].noalias() -= factor_[at(p)].transpose() * x[k];
    for (std::size_t k = 0; k < n; ++k)
        x[k] = inverse_[k] * x[k];
    for (std::size_t k = n; k-- > 0;)
        for (int p = factor_first_[k]; p < factor_first_[k + 1]; ++p)
            x[k].noalias() -= factor_[at(p)] * x[at(factor_row_[at(p)])];
    Eigen::VectorXd solution(2 * static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i)
        solution.segment<2>(2 * static_cast<Eigen::Index>(i)) = x[at(place_[i])];
    return solution;
}

} // namespace alphamst::geometry
