#include "fill/branch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

std::vector<Branch> branches(const Word &front, Budget budget) {
    std::vector<Branch> all;
    visit_branches(front, budget, [&](Branch &branch) { all.push_back(branch); });
    return all;
}

TEST(Branch, TheOnlyQuadBesideTwoCornersIsForced) {
    // Two squares side by side: one goes, the other remains.
    const std::vector<Branch> all = branches({1, 1, 2, 1, 1, 2}, {2, 2});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].quad, (std::array{5, 0, 1, 2}));
    EXPECT_EQ(all[0].used.total(), 0);
    ASSERT_EQ(all[0].parts.size(), 1U);
    EXPECT_EQ(all[0].parts[0].word, (Word{1, 1, 1, 1}));
    EXPECT_EQ(all[0].parts[0].vertices, (std::vector{2, 3, 4, 5}));
}

TEST(Branch, ThreeCornersInARowAllowNothingButASquare) {
    EXPECT_TRUE(branches({1, 1, 1, 2, 2, 2}, {3, 3}).empty());
}

// The fourth vertex at a corner alone is new, with each valence that the budget has, or one of the front.
TEST(Branch, AtACornerTheFourthVertexIsNewOrOfTheFront) {
    const Word word = oracle::polygon({3, 3, 3, 3});
    const auto of_new = [&](Budget budget) {
        std::vector<std::size_t> lengths;
        for (const Branch &branch : branches(word, budget))
            if (branch.quad[3] == -1)
                lengths.push_back(branch.parts[0].word.size());
        return lengths;
    };
    EXPECT_EQ(of_new({0, 0}), (std::vector<std::size_t>{12}));
    EXPECT_EQ(of_new({1, 0}).size(), 2U);
    EXPECT_EQ(of_new({1, 1}).size(), 3U);
    for (const Branch &branch : branches(word, {1, 1})) {
        EXPECT_EQ(branch.quad[0], 11);
        EXPECT_EQ(branch.quad[1], 0);
        EXPECT_EQ(branch.quad[2], 1);
        if (branch.quad[3] != -1) { // cuts the front in two, at a vertex with faces to share
            EXPECT_EQ(branch.parts.size(), 2U);
            EXPECT_GE(word[static_cast<std::size_t>(branch.quad[3])], 3);
        }
    }
}

// What holds whatever the quad: lengths are even, letters are left, and the singular vertices that the
// front needs are those of the quad and of the parts.
TEST(Branch, PartsAreFrontsThatTogetherNeedWhatTheWholeNeeds) {
    std::mt19937 random(31);
    std::size_t seen = 0, without_corner = 0;
    for (int round = 0; round < 300; ++round) {
        Word word(4 + 2 * (random() % 6));
        const int least = round % 3 == 0 ? 2 : 1;
        without_corner += least == 2;
        for (int &letter : word)
            letter = least + static_cast<int>(random() % static_cast<unsigned>(5 - least));
        const Budget budget{static_cast<int>(random() % 3), static_cast<int>(random() % 3)};
        for (const Branch &branch : branches(word, budget)) {
            ++seen;
            EXPECT_LE(branch.used.v3, budget.v3);
            EXPECT_LE(branch.used.v5, budget.v5);
            int sum = branch.used.v3 - branch.used.v5;
            for (const Part &part : branch.parts) {
                EXPECT_EQ(part.word.size() % 2, 0U);
                EXPECT_GE(part.word.size(), 4U);
                EXPECT_GE(*std::min_element(part.word.begin(), part.word.end()), 1);
                EXPECT_EQ(part.word.size(), part.vertices.size());
                sum += alphamst::fill::index(part.word);
            }
            EXPECT_EQ(sum, alphamst::fill::index(word)) << testing::PrintToString(word);
        }
    }
    EXPECT_GT(seen, 1000U);
    EXPECT_GT(without_corner, 50U);
}

TEST(Branch, ComeInTheSameOrder) {
    const Word word{2, 3, 2, 2, 3, 4, 2, 2};
    const auto a = branches(word, {1, 1}), b = branches(word, {1, 1});
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].quad, b[i].quad);
}

} // namespace
