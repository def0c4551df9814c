#include "fill/front.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <random>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

struct Closed {
    Filling filling;
    oracle::Count rest;
};

// Closes the front with the exact filler, with as few singularities as it takes.
std::optional<Closed> close(const Front &front, int boundary) {
    const int excess = alphamst::fill::index(front.word);
    for (int k = std::abs(excess); k <= std::abs(excess) + 4; k += 2)
        try {
            ExactFiller filler(200000);
            const int v3 = (k + excess) / 2, v5 = (k - excess) / 2;
            const FaceSet faces = filler.faces(front.word, v3, v5, 50);
            for (int f = 1; f <= 50; ++f)
                if (faces[static_cast<std::size_t>(f)])
                    return Closed{front.close(*filler.fill(front.word, v3, v5, f, 1), boundary), {v3, v5, f}};
        } catch (const TooHard &) {
        }
    return std::nullopt;
}

void expect_valid(const Front &front, const Word &word, int &closed) {
    EXPECT_EQ(front.word.size(), front.ids.size());
    EXPECT_EQ(alphamst::fill::index(front.word), alphamst::fill::index(word)) << testing::PrintToString(word);
    ASSERT_GE(*std::min_element(front.word.begin(), front.word.end()), 1) << testing::PrintToString(word);
    const auto whole = close(front, static_cast<int>(word.size()));
    if (!whole)
        return;
    ++closed;
    const oracle::Disk disk = oracle::inspect(whole->filling);
    ASSERT_EQ(disk.fault, "") << testing::PrintToString(word);
    EXPECT_EQ(disk.word, word);
    EXPECT_EQ(disk.v3, whole->rest.v3); // nothing singular was laid
    EXPECT_EQ(disk.v5, whole->rest.v5);
    EXPECT_EQ(disk.other, 0);
    EXPECT_EQ(disk.faces, static_cast<int>(front.quads.size()) + whole->rest.faces);
}

Word some_word(std::mt19937 &random, int round) {
    Word word = oracle::region(6 + static_cast<int>(random() % 20), random);
    if (round % 3 == 0) // polygons and flat rounds as well
        word = oracle::polygon(
            {3 + static_cast<int>(random() % 4), 4, 3 + static_cast<int>(random() % 4), 4, 4});
    if (round % 3 == 1)
        word[random() % word.size()] = 2;
    if (word.size() % 2 != 0)
        word.push_back(2);
    return word;
}

TEST(Front, StartsAsTheWord) {
    const Word word{1, 2, 1, 2, 3, 2, 1, 2, 1, 2, 4, 2};
    const Front front(word);
    EXPECT_EQ(front.word, word);
    EXPECT_EQ(front.vertices, 12);
    EXPECT_EQ(front.corners(), 4);
    EXPECT_EQ(front.concaves(), 3);
    EXPECT_TRUE(front.quads.empty());
}

TEST(Front, PeelsSides) {
    std::mt19937 random(14);
    int closed = 0, peeled = 0;
    for (int round = 0; round < 150; ++round) {
        const Word word = some_word(random, round);
        const std::size_t n = word.size();
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t row = 1;
            while (row < n && word[(i + row) % n] == 2)
                ++row;
            if (word[i] != 1 || word[(i + row) % n] != 1 || row == n)
                continue;
            Front front(word);
            const bool done = front.peel(i, (i + row) % n);
            const bool free = word[(i + n - 1) % n] >= 2 && word[(i + row + 1) % n] >= 2 && row + 4 <= n;
            EXPECT_EQ(done, free) << testing::PrintToString(word);
            if (!done) {
                EXPECT_EQ(front.word, word);
                EXPECT_TRUE(front.quads.empty());
                continue;
            }
            ++peeled;
            EXPECT_EQ(front.quads.size(), row);
            EXPECT_EQ(front.word.size(), n - 2);
            expect_valid(front, word, closed);
        }
    }
    EXPECT_GT(peeled, 100);
    EXPECT_GT(closed, 50);
}

TEST(Front, Offsets) {
    std::mt19937 random(15);
    int closed = 0, offsets = 0;
    for (int round = 0; round < 200; ++round) {
        const Word word = round % 4 == 3 ? Word(8 + 2 * (random() % 5), 2) : some_word(random, round);
        Front front(word);
        const int corners = front.corners(), concaves = front.concaves();
        if (!front.offset()) {
            EXPECT_EQ(front.word, word);
            EXPECT_TRUE(front.quads.empty());
            continue;
        }
        ++offsets;
        EXPECT_EQ(front.corners(), corners);
        EXPECT_EQ(front.concaves(), concaves);
        expect_valid(front, word, closed);
    }
    EXPECT_GT(offsets, 60);
    EXPECT_GT(closed, 40);
}

TEST(Front, OffsetsConcaveLetters) {
    int closed = 0;
    for (const Word &word : {Word{1, 2, 2, 2, 1, 2, 2, 3, 2, 2, 1, 2, 2, 2, 1, 2, 2, 2, 1, 2, 2, 2},
                             Word{1, 2, 2, 2, 2, 1, 2, 2, 2, 4, 2, 2, 2, 1, 2, 2, 2, 2, 1, 2, 2, 2, 2, 2}}) {
        Front front(word);
        ASSERT_TRUE(front.offset());
        expect_valid(front, word, closed);
    }
    EXPECT_GT(closed, 0);
}

TEST(Front, CancelsConcaveVertices) {
    std::mt19937 random(16);
    int closed = 0, cancelled = 0;
    for (int round = 0; round < 200; ++round) {
        const Word word = oracle::region(8 + static_cast<int>(random() % 20), random);
        Front front(word);
        for (int step = 0; step < 8; ++step) {
            const int corners = front.corners(), concaves = front.concaves();
            const std::size_t laid = front.quads.size();
            if (!front.cancel_concave()) {
                EXPECT_EQ(front.quads.size(), laid);
                break;
            }
            EXPECT_LT(front.concaves(), concaves) << testing::PrintToString(word);
            EXPECT_LT(front.corners(), corners) << testing::PrintToString(word);
            EXPECT_GT(front.quads.size(), laid);
            ++cancelled;
            expect_valid(front, word, closed);
            if (testing::Test::HasFatalFailure())
                return;
        }
    }
    EXPECT_GT(cancelled, 60);
    EXPECT_GT(closed, 60);
}

TEST(Front, IsDeterministic) {
    std::mt19937 random(17);
    const Word word = oracle::region(25, random);
    Front a(word), b(word);
    EXPECT_EQ(a.cancel_concave(), b.cancel_concave());
    EXPECT_EQ(a.offset(), b.offset());
    EXPECT_EQ(a.quads, b.quads);
    EXPECT_EQ(a.word, b.word);
}

} // namespace
