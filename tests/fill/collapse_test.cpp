#include "fill/collapse.h"

#include <gtest/gtest.h>

#include <random>

#include "fill/exact.h"
#include "oracle.h"

namespace {

using namespace alphamst::fill;

// A filled region of the grid, or a polygon with singularities.
Filling old_filling(std::mt19937 &random, int round, Word &word) {
    if (round % 2 == 0) {
        const int cells = 6 + static_cast<int>(random() % 40);
        word = oracle::region(cells, random);
        return *ExactFiller(1000000).fill(word, 0, 0, cells, 0);
    }
    word = oracle::polygon({4, 5, 4 + static_cast<int>(random() % 2) * 2, 5});
    ExactFiller filler(3000000);
    const FaceSet faces = filler.faces(word, 2, 2, 40);
    int most = 40;
    while (!faces[static_cast<std::size_t>(most)])
        --most;
    return *filler.fill(word, 2, 2, most, random());
}

TEST(Collapse, BuildsWhatItPromises) {
    std::mt19937 random(26);
    int built = 0;
    for (int round = 0; round < 120; ++round) {
        Request request;
        const Filling old = old_filling(random, round, request.word);
        for (const int letter : request.word) {
            request.regular.push_back(random() % 4 == 0 ? 0 : letter);
            request.angles.push_back(round % 3 == 0 ? 90.0 * letter : 30.0 + 60.0 * letter);
        }
        const auto faces = static_cast<std::int64_t>(old.quads.size());
        request.faces = faces - 1 - static_cast<std::int64_t>(random() % static_cast<unsigned>(faces / 2));
        request.most = 4;
        request.seed = random();
        int last = 0;
        for (const Candidate &candidate : plan_by_collapse(request, old)) {
            ++built;
            EXPECT_EQ(candidate.faces, request.faces);
            EXPECT_LE(last, candidate.singularities);
            last = candidate.singularities;
            const oracle::Disk disk = oracle::inspect(candidate.build());
            ASSERT_EQ(disk.fault, "") << testing::PrintToString(request.word) << request.faces;
            EXPECT_EQ(disk.faces, request.faces);
            int singular = disk.v3 + disk.v5 + disk.other;
            ASSERT_EQ(disk.word.size(), request.word.size());
            for (std::size_t v = 0; v < disk.word.size(); ++v) {
                singular += request.regular[v] != 0 && disk.word[v] != request.regular[v];
                if (disk.word[v] != request.word[v]) {
                    EXPECT_LT(request.angles[v] / disk.word[v], 175);
                }
            }
            EXPECT_EQ(singular, candidate.singularities);
        }
    }
    EXPECT_GT(built, 100);
}

TEST(Collapse, NeedsMoreFacesThanWanted) {
    Request request;
    request.word = request.regular = oracle::polygon({3, 3, 3, 3});
    request.faces = 9;
    const Filling old = *ExactFiller(1000).fill(request.word, 0, 0, 9, 0);
    EXPECT_TRUE(plan_by_collapse(request, old).empty());
    request.faces = 1; // the boundary alone needs more
    EXPECT_TRUE(plan_by_collapse(request, old).empty());
}

TEST(Collapse, IsDeterministic) {
    std::mt19937 random(27);
    Request request;
    const Filling old = old_filling(random, 0, request.word);
    request.regular = request.word;
    request.faces = static_cast<std::int64_t>(old.quads.size()) - 2;
    request.seed = 3;
    const auto a = plan_by_collapse(request, old), b = plan_by_collapse(request, old);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_EQ(a[i].build().quads, b[i].build().quads);
}

} // namespace
