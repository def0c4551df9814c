#include "fill/layout.h"

#include <gtest/gtest.h>

#include <random>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

std::vector<int> corners_of(const std::vector<int> &sides) {
    std::vector<int> corners{0};
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
        corners.push_back(corners.back() + sides[i]);
    return corners;
}

Filling example(const std::vector<int> &sides, int v3, int v5, std::uint64_t seed) {
    ExactFiller filler(1000000);
    const Word word = oracle::polygon(sides);
    const FaceSet faces = filler.faces(word, v3, v5, 60);
    for (int f = 1; f <= 60; ++f)
        if (faces[static_cast<std::size_t>(f)])
            return *filler.fill(word, v3, v5, f, seed);
    return {};
}

struct Case {
    std::vector<int> sides;
    int v3, v5;
};
const std::vector<Case> cases{{{3, 4, 5}, 1, 0},       {{3, 3, 8}, 2, 1},          {{4, 6, 5, 3}, 1, 1},
                              {{4, 7, 3, 4}, 1, 1},    {{3, 3, 3, 7}, 2, 2},       {{4, 4, 4, 4, 4}, 0, 1},
                              {{3, 6, 4, 4, 3}, 1, 2}, {{3, 4, 4, 3, 4, 4}, 0, 2}, {{5, 7}, 2, 0},
                              {{4, 5, 4, 5}, 0, 0}};

TEST(Layout, ExtractKeepsSingularitiesAndDropsCopies) {
    for (const Case &c : cases)
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            const Filling filling = example(c.sides, c.v3, c.v5, seed);
            ASSERT_FALSE(filling.quads.empty()) << testing::PrintToString(c.sides);
            const Layout layout = extract(filling, corners_of(c.sides));
            EXPECT_EQ(layout.sides, static_cast<int>(c.sides.size()));
            EXPECT_EQ(layout.v3, c.v3);
            EXPECT_EQ(layout.v5, c.v5);
            EXPECT_LE(layout.blocks.quads.size(), filling.quads.size());
            // All multiplicities one: the blocks themselves.
            const Multiplicities ones(static_cast<std::size_t>(layout.chords), 1);
            EXPECT_EQ(face_count(layout, ones), static_cast<std::int64_t>(layout.blocks.quads.size()));
        }
}

TEST(Layout, SomeExpansionIsTheFillingAgain) {
    for (const Case &c : cases) {
        const Filling filling = example(c.sides, c.v3, c.v5, 0);
        const Layout layout = extract(filling, corners_of(c.sides));
        bool found = false;
        Multiplicities x(static_cast<std::size_t>(layout.chords), 1);
        auto visit = [&](auto &self, std::size_t j) -> void {
            const auto lengths = side_lengths(layout, x);
            for (std::size_t i = 0; i < lengths.size(); ++i)
                if (lengths[i] > c.sides[i])
                    return;
            if (j == x.size()) {
                found = found || (lengths == c.sides &&
                                  face_count(layout, x) == static_cast<std::int64_t>(filling.quads.size()));
                return;
            }
            for (; x[j] <= 8 && !found; ++x[j])
                self(self, j + 1);
            x[j] = 1;
        };
        visit(visit, 0);
        EXPECT_TRUE(found) << testing::PrintToString(c.sides);
    }
}

TEST(Layout, ExpansionsHaveTheirLayout) {
    std::mt19937 random(12);
    for (const Case &c : cases) {
        const Layout layout = extract(example(c.sides, c.v3, c.v5, 1), corners_of(c.sides));
        for (int round = 0; round < 6; ++round) {
            Multiplicities x;
            for (int j = 0; j < layout.chords; ++j)
                x.push_back(1 + static_cast<int>(random() % 4));
            const Filling filling = expand(layout, x);
            const oracle::Disk disk = oracle::inspect(filling);
            ASSERT_EQ(disk.fault, "");
            const auto lengths = side_lengths(layout, x);
            EXPECT_EQ(disk.word, oracle::polygon(lengths));
            EXPECT_EQ(disk.faces, face_count(layout, x));
            EXPECT_EQ(signature(extract(filling, corners_of(lengths))), signature(layout))
                << testing::PrintToString(c.sides);
        }
    }
}

TEST(Layout, SignatureKnowsNoTurnAndNoMirror) {
    std::set<std::vector<int>> different;
    for (const Case &c : cases) {
        const Layout layout = extract(example(c.sides, c.v3, c.v5, 0), corners_of(c.sides));
        different.insert(signature(layout));
        for (const bool mirror : {false, true})
            for (const int first : layout.corners) {
                Layout other = layout;
                other.blocks = rotated(layout.blocks, first);
                other.corners.clear();
                for (const int corner : layout.corners)
                    other.corners.push_back((corner - first + layout.blocks.boundary) %
                                            layout.blocks.boundary);
                if (mirror) {
                    other.blocks = mirrored(other.blocks);
                    for (int &corner : other.corners)
                        corner = (layout.blocks.boundary - corner) % layout.blocks.boundary;
                }
                std::sort(other.corners.begin(), other.corners.end());
                std::reverse(other.blocks.quads.begin(), other.blocks.quads.end()); // nor an order of quads
                complete(other);
                EXPECT_EQ(signature(other), signature(layout)) << testing::PrintToString(c.sides);
                EXPECT_EQ(other.chords, layout.chords);
            }
    }
    EXPECT_GE(different.size(), cases.size() - 1);
}

TEST(Layout, MirroredAndRotatedMoveTheBoundaryWord) {
    const Filling filling = example({3, 6, 4, 4, 3}, 1, 2, 0);
    const oracle::Disk disk = oracle::inspect(filling);
    for (int first = 0; first < filling.boundary; ++first) {
        const oracle::Disk turned = oracle::inspect(rotated(filling, first));
        Word word = disk.word;
        std::rotate(word.begin(), word.begin() + first, word.end());
        EXPECT_EQ(turned.fault, "");
        EXPECT_EQ(turned.word, word);
    }
    const oracle::Disk back = oracle::inspect(mirrored(filling));
    Word word = disk.word;
    std::reverse(word.begin() + 1, word.end());
    EXPECT_EQ(back.fault, "");
    EXPECT_EQ(back.word, word);
    EXPECT_EQ(mirrored(mirrored(filling)).quads.size(), filling.quads.size());
}

} // namespace
