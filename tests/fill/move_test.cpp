#include "fill/move.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace alphamst::fill;
using Matrix = std::vector<std::vector<int>>;

std::int64_t form(const std::vector<int> &x, const Matrix &product, const std::vector<int> &y) {
    std::int64_t sum = 0;
    for (std::size_t a = 0; a < x.size(); ++a)
        for (std::size_t b = 0; b < y.size(); ++b)
            sum += x[a] * product[a][b] * y[b];
    return sum;
}

TEST(Move, LanesHoldEveryChord) {
    Lanes lanes;
    for (std::size_t j = 0; j < most_chords; ++j)
        lanes.set(j, 100 * static_cast<int>(j) - 500);
    for (std::size_t j = 0; j < most_chords; ++j)
        EXPECT_EQ(lanes[j], 100 * static_cast<int>(j) - 500);
    EXPECT_EQ(lanes.low[7], 200);
    EXPECT_EQ(lanes.high[0], 300);
}

// faces(x) = x' product x / 2 along x + t z.
TEST(Move, SlopeAndCurvatureAreThoseOfTheFaceCount) {
    std::mt19937 random(41);
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 1 + random() % most_chords;
        Matrix product(n, std::vector<int>(n, 0));
        std::vector<int> x(n), z(n);
        for (std::size_t a = 0; a < n; ++a) {
            x[a] = 1 + static_cast<int>(random() % 50);
            z[a] = static_cast<int>(random() % 5) - 2;
            product[a][a] = 2 * static_cast<int>(random() % 2); // a block that a chord crosses itself in
            for (std::size_t b = 0; b < a; ++b)
                product[a][b] = product[b][a] = static_cast<int>(random() % 3);
        }
        const Move move(z, product);
        std::int64_t slope = 0;
        for (std::size_t a = 0; a < n; ++a)
            slope += move.slope[a] * x[a];
        for (const int t : {-7, -1, 0, 1, 5}) {
            std::vector<int> moved = x;
            for (std::size_t a = 0; a < n; ++a)
                moved[a] += t * z[a];
            EXPECT_EQ(form(moved, product, moved) / 2,
                      form(x, product, x) / 2 + t * slope + t * t * move.curvature);
        }
    }
}

TEST(Move, MasksAreOpenWhereAChordGainsOrLosesSoMany) {
    const std::vector<int> z{1, 2, -1, -2, 0};
    const Move move(z, Matrix(5, std::vector<int>(5, 0)));
    for (std::size_t j = 0; j < most_chords; ++j) {
        const int change = j < z.size() ? z[j] : 0;
        EXPECT_EQ(move.z[j], change);
        EXPECT_EQ(move.adds_one[j], change == 1 ? 0 : 0x7fff);
        EXPECT_EQ(move.adds_two[j], change == 2 ? 0 : 0x7fff);
        EXPECT_EQ(move.takes_one[j], change == -1 ? 0 : 0x7fff);
        EXPECT_EQ(move.takes_two[j], change == -2 ? 0 : 0x7fff);
    }
}

} // namespace
