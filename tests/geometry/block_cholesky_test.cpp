#include "geometry/block_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace alphamst::geometry {
namespace {

// The sparse matrix and the same one in full.
struct Both {
    Both(int n, std::vector<std::array<int, 2>> given, unsigned seed)
        : pairs(std::move(given)), sparse(n, pairs), full(Eigen::MatrixXd::Zero(2 * n, 2 * n)), random(seed) {
    }

    Eigen::Matrix2d any() {
        std::uniform_real_distribution<double> number(-1, 1);
        Eigen::Matrix2d block;
        block << number(random), number(random), number(random), number(random);
        return block;
    }
    void add(int row, int column, const Eigen::Matrix2d &block) {
        sparse.add(sparse.slot(row, column), block);
        full.block<2, 2>(2 * row, 2 * column) += block;
        if (row != column)
            full.block<2, 2>(2 * column, 2 * row) += block.transpose();
    }
    // Off the diagonal what it may, on it so much that the matrix is positive definite.
    void fill(int n) {
        for (const auto &[i, j] : pairs)
            add(i, j, any());
        for (int i = 0; i < n; ++i) {
            const Eigen::Matrix2d block = any();
            add(i, i, block * block.transpose() + 12 * Eigen::Matrix2d::Identity());
        }
    }

    std::vector<std::array<int, 2>> pairs;
    BlockCholesky sparse;
    Eigen::MatrixXd full;
    std::mt19937 random;
};

// Vertices of a square grid, each coupled with its neighbours, some pairs the other way round.
std::vector<std::array<int, 2>> grid(int n) {
    std::vector<std::array<int, 2>> pairs;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int v = n * j + i;
            if (i + 1 < n)
                pairs.push_back({v, v + 1});
            if (j + 1 < n)
                pairs.push_back({v + n, v});
        }
    return pairs;
}

TEST(BlockCholesky, SolvesAsTheFullMatrixDoes) {
    for (const int n : {1, 2, 5, 9}) {
        Both both(n * n, grid(n), static_cast<unsigned>(n));
        both.fill(n * n);
        ASSERT_TRUE(both.sparse.factor(0.5));
        const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(2 * n * n, -1, 2);
        const Eigen::MatrixXd shifted = both.full + 0.5 * Eigen::MatrixXd::Identity(2 * n * n, 2 * n * n);
        const Eigen::VectorXd expected = shifted.llt().solve(right);
        EXPECT_LT((both.sparse.solve(right) - expected).norm(), 1e-10 * expected.norm()) << n;
        EXPECT_NEAR(both.sparse.trace(), both.full.trace(), 1e-10);
    }
}

TEST(BlockCholesky, CanBeFilledAndFactoredAgain) {
    Both both(9, grid(3), 7);
    both.fill(9);
    ASSERT_TRUE(both.sparse.factor(0));
    both.sparse.set_zero();
    both.full.setZero();
    both.fill(9);
    ASSERT_TRUE(both.sparse.factor(0));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(18), expected = both.full.llt().solve(right);
    EXPECT_LT((both.sparse.solve(right) - expected).norm(), 1e-10 * expected.norm());
}

TEST(BlockCholesky, RefusesWhatIsNotPositiveDefinite) {
    Both both(4, {{0, 1}, {1, 2}, {2, 3}}, 3);
    both.fill(4);
    both.add(2, 2, -100 * Eigen::Matrix2d::Identity());
    EXPECT_FALSE(both.sparse.factor(0));
    EXPECT_TRUE(both.sparse.factor(200));
}

TEST(BlockCholesky, OfNothingSolvesNothing) {
    BlockCholesky none(0, {});
    EXPECT_TRUE(none.factor(1));
    EXPECT_EQ(none.solve(Eigen::VectorXd()).size(), 0);
}

} // namespace
} // namespace alphamst::geometry
