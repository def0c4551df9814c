#include "fill/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "oracle.h"

namespace {

using namespace alphamst::fill;

Word random_word(std::mt19937 &random, int most_length, int most_letter) {
    Word word(4 + 2 * (random() % static_cast<unsigned>(most_length / 2 - 1)));
    for (int &letter : word)
        letter = 1 + static_cast<int>(random() % static_cast<unsigned>(most_letter));
    return word;
}

constexpr int most_v3 = 8; // the filler refuses more

// What the brute force finds, less what the filler refuses.
std::set<oracle::Count> provable(std::set<oracle::Count> counts) {
    std::erase_if(counts, [](const oracle::Count &count) { return count.v3 > most_v3; });
    return counts;
}

std::set<oracle::Count> found(ExactFiller &filler, const Word &word, int most_singularities, int most) {
    std::set<oracle::Count> counts;
    for (int v3 = 0; v3 <= most_singularities; ++v3)
        for (int v5 = 0; v3 + v5 <= most_singularities; ++v5) {
            if (v3 > most_v3)
                continue; // refused, see RefusesWordsThatCouldJoinTwoVerticesTwice
            const FaceSet faces = filler.faces(word, v3, v5, most);
            for (int f = 0; f <= most; ++f)
                if (faces[static_cast<std::size_t>(f)])
                    counts.insert({v3, v5, f});
        }
    return counts;
}

void expect_fills(ExactFiller &filler, const Word &word, const oracle::Count &count, std::uint64_t seed) {
    const auto filling = filler.fill(word, count.v3, count.v5, count.faces, seed);
    ASSERT_TRUE(filling) << testing::PrintToString(word);
    const oracle::Disk disk = oracle::inspect(*filling);
    EXPECT_EQ(disk.fault, "") << testing::PrintToString(word);
    EXPECT_EQ(disk.word, word);
    EXPECT_EQ(disk.v3, count.v3);
    EXPECT_EQ(disk.v5, count.v5);
    EXPECT_EQ(disk.other, 0);
    EXPECT_EQ(disk.faces, count.faces);
}

TEST(Exact, EqualsTheBruteForceOnRandomWords) {
    std::mt19937 random(1);
    constexpr int most = 10;
    std::size_t counts = 0;
    for (int round = 0; round < 600; ++round) {
        const Word word = random_word(random, 12, 3);
        // A disk with f faces has f + 1 - boundary / 2 inner vertices.
        const int inner = most + 1 - static_cast<int>(word.size()) / 2;
        const auto expected = provable(oracle::BruteForce(word, inner, inner, most).all());
        ExactFiller filler(1000000);
        ASSERT_EQ(found(filler, word, inner, most), expected) << testing::PrintToString(word);
        counts += expected.size();
        if (round % 5 == 0)
            for (const oracle::Count &count : expected)
                for (std::uint64_t seed = 0; seed < 3; ++seed)
                    expect_fills(filler, word, count, seed);
    }
    EXPECT_GT(counts, 300u); // words that can be filled are among them
}

TEST(Exact, EqualsTheBruteForceOnGridRegions) {
    std::mt19937 random(2);
    for (int round = 0; round < 120; ++round) {
        const int cells = 3 + static_cast<int>(random() % 9);
        Word word = oracle::region(cells, random);
        if (round % 2 == 1) { // no longer a region of the grid
            int &letter = word[random() % word.size()];
            letter = letter == 1 ? 2 : letter - 1;
        }
        ExactFiller filler(1000000);
        const auto expected = oracle::BruteForce(word, 3, 3, 20).all();
        const auto all = found(filler, word, 6, 20);
        std::set<oracle::Count> few;
        for (const oracle::Count &count : all)
            if (count.v3 <= 3 && count.v5 <= 3)
                few.insert(count);
        ASSERT_EQ(few, expected) << testing::PrintToString(word);
        if (round % 2 == 0) {
            EXPECT_TRUE(few.count({0, 0, cells})) << testing::PrintToString(word);
        }
    }
}

TEST(Exact, EqualsTheBruteForceWithLettersUpToFour) {
    std::mt19937 random(3);
    std::size_t counts = 0;
    for (int round = 0; round < 300; ++round) {
        const Word word = random_word(random, 14, 4);
        ExactFiller filler(1000000);
        const auto expected = provable(oracle::BruteForce(word, 9, 9, 11).all());
        ASSERT_EQ(found(filler, word, 10, 11), expected) << testing::PrintToString(word);
        counts += expected.size();
    }
    EXPECT_GT(counts, 50u);
}

// With the fewest singularities and with two more.
std::size_t expect_equal(const Word &word, int most) {
    const int excess = oracle::excess(word);
    std::size_t counts = 0;
    for (int k = std::abs(excess); k <= std::abs(excess) + 2; k += 2) {
        const int v3 = (k + excess) / 2, v5 = (k - excess) / 2;
        if (v3 > most_v3)
            continue;
        std::set<oracle::Count> expected, got;
        for (const oracle::Count &count : oracle::BruteForce(word, v3, v5, most).all())
            if (count.v3 == v3)
                expected.insert(count);
        ExactFiller filler(2000000);
        const FaceSet faces = filler.faces(word, v3, v5, most);
        for (int f = 0; f <= most; ++f)
            if (faces[static_cast<std::size_t>(f)])
                got.insert({v3, v5, f});
        EXPECT_EQ(got, expected) << testing::PrintToString(word);
        counts += expected.size();
    }
    return counts;
}

// Words whose fillings pass between two front vertices, some right beside the corner.
TEST(Exact, EqualsTheBruteForceOnPinchedWords) {
    for (const Word &word :
         {Word{3, 1, 2, 4, 3, 2, 2, 3, 2, 2, 2, 1}, Word{1, 2, 1, 2, 2, 1, 2, 2, 2, 3, 3, 4},
          Word{2, 1, 2, 2, 2, 1, 2, 3, 2, 2, 3, 4}, Word{3, 1, 2, 4, 1, 2, 2, 2, 1, 2, 2, 4, 2, 2},
          Word{2, 2, 2, 2, 2, 1, 3, 2, 2, 4, 3, 2}, Word{4, 2, 2, 2, 2, 3, 1, 3, 2, 2},
          Word{2, 2, 1, 3, 2, 2, 4, 2, 2, 3}, Word{2, 2, 4, 2, 2, 2, 3, 1, 2, 3}})
        EXPECT_GT(expect_equal(word, 14), 0u) << testing::PrintToString(word);
}

// With nine valence-3 vertices a front could join two vertices twice and count such a filling.
TEST(Exact, RefusesWordsThatCouldJoinTwoVerticesTwice) {
    for (const Word &word : {Word{2, 2, 2, 2, 2, 3, 4, 4}, Word{2, 3, 2, 4, 4, 4}}) {
        ExactFiller filler(1000000);
        ASSERT_GE(oracle::excess(word), 9);
        EXPECT_THROW(filler.faces(word, oracle::excess(word), 0, 13), TooHard);
        EXPECT_THROW(filler.fill(word, oracle::excess(word), 0, 13, 0), TooHard);
    }
}

TEST(Exact, EqualsTheBruteForceWithoutCorners) {
    std::mt19937 random(25);
    std::size_t counts = 0;
    for (int round = 0; round < 60; ++round) {
        Word word(4 + 2 * (random() % 4));
        for (int &letter : word)
            letter = random() % 3 == 0 ? 3 + static_cast<int>(random() % 2) : 2;
        if (oracle::excess(word) <= 8)
            counts += expect_equal(word, 14);
    }
    for (const std::size_t length : {4u, 6u, 8u})
        counts += expect_equal(Word(length, 2), 18);
    EXPECT_GT(counts, 60u);
}

TEST(Exact, TurnsAndMirrorsKeepTheFaceSet) {
    std::mt19937 random(4);
    for (int round = 0; round < 30; ++round) {
        Word word = oracle::region(6 + static_cast<int>(random() % 10), random);
        ExactFiller first(1000000);
        const FaceSet faces = first.faces(word, 1, 1, 30);
        std::rotate(word.begin(), word.begin() + 3, word.end());
        if (round % 2 == 0)
            std::reverse(word.begin(), word.end());
        ExactFiller second(1000000);
        EXPECT_EQ(second.faces(word, 1, 1, 30), faces);
    }
}

TEST(Exact, ListsNoCountAboveTheLimit) {
    std::mt19937 random(5);
    for (int round = 0; round < 60; ++round) {
        const Word word = oracle::region(4 + static_cast<int>(random() % 14), random);
        ExactFiller filler(1000000), fresh(1000000);
        const FaceSet large = filler.faces(word, 2, 2, 40);
        for (const ExactFiller *which : {&filler, &fresh}) { // with and without remembered fronts
            const FaceSet small = const_cast<ExactFiller *>(which)->faces(word, 2, 2, 20);
            for (std::size_t f = 0; f <= most_faces; ++f)
                EXPECT_EQ(small[f], f <= 20 && large[f]) << f << testing::PrintToString(word);
        }
    }
}

TEST(Exact, GivesUpAtTheNodeLimit) {
    const Word word = oracle::polygon({5, 6, 7, 8});
    ExactFiller tiny(3);
    EXPECT_THROW(tiny.faces(word, 2, 2, 60), TooHard);
    ExactFiller other(3);
    EXPECT_THROW(other.fill(word, 2, 2, 40, 0), TooHard);
    ExactFiller large(1000000);
    EXPECT_NO_THROW(large.faces(word, 1, 1, 60));
    EXPECT_GT(large.nodes(), 3);
}

TEST(Exact, RefusesWhatItDoesNotKnow) {
    ExactFiller filler(1000);
    EXPECT_THROW(filler.faces({1, 1, 1, 5}, 0, 1, 10), TooHard);
    EXPECT_THROW(filler.faces({1, 1, 1, 1}, 0, 0, most_faces + 1), TooHard);
    EXPECT_THROW(filler.faces(Word(longest_word + 2, 2), 4, 0, 200), TooHard);
    EXPECT_TRUE(filler.faces({1, 1, 2, 1, 1}, 0, 0, 10).none());
    EXPECT_TRUE(filler.faces({1, 1, 1, 1}, -1, 0, 10).none());
    EXPECT_FALSE(filler.fill({1, 1, 1, 1}, 0, 0, 2, 0));
    EXPECT_TRUE(filler.fill({1, 1, 1, 1}, 0, 0, 1, 0));
}

TEST(Exact, IndexIsWhatFillingsHave) {
    EXPECT_EQ(alphamst::fill::index({1, 1, 1, 1}), 0);
    EXPECT_EQ(alphamst::fill::index(Word(10, 2)), 4);
    EXPECT_EQ(alphamst::fill::index({1, 2, 1, 2, 3, 2}), 3);
}

TEST(Exact, IsDeterministic) {
    const Word word = oracle::polygon({4, 5, 6, 7, 6});
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        ExactFiller a(1000000), b(1000000);
        b.faces(word, 1, 2, 60); // knows more
        const FaceSet faces = a.faces(word, 1, 2, 50);
        std::size_t f = 1;
        while (f < 50 && !faces[f])
            ++f;
        ASSERT_LT(f, 50u);
        const auto x = a.fill(word, 1, 2, static_cast<int>(f), seed),
                   y = b.fill(word, 1, 2, static_cast<int>(f), seed);
        ASSERT_TRUE(x && y);
        EXPECT_EQ(x->quads, y->quads);
        EXPECT_EQ(x->vertices, y->vertices);
    }
}

} // namespace
