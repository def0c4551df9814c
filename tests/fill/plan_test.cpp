#include "fill/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "oracle.h"

namespace {

using namespace alphamst::fill;

constexpr double straight = 175; // widest angle that one face may span

// Builds every candidate and compares it with its promises and with the request.
int expect_keeps(const Request &request) {
    const auto candidates = plan(request);
    EXPECT_LE(static_cast<int>(candidates.size()), request.most);
    std::int64_t last_miss = 0;
    int last_singularities = 0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Candidate &candidate = candidates[i];
        const std::string where = testing::PrintToString(request.word) + " " + std::to_string(request.faces);
        const std::int64_t miss = std::abs(candidate.faces - request.faces);
        if (!request.any_count) {
            EXPECT_LE(miss, request.tolerance) << where;
        }
        if (i > 0 && request.any_count) {
            EXPECT_LE(last_singularities, candidate.singularities) << where;
        } else if (i > 0) { // exact ones first
            EXPECT_TRUE(last_miss == 0 || miss != 0) << where;
            if (last_miss == 0 && miss == 0) {
                EXPECT_LE(last_singularities, candidate.singularities) << where;
            }
        }
        last_miss = miss, last_singularities = candidate.singularities;
        const oracle::Disk disk = oracle::inspect(candidate.build());
        EXPECT_EQ(disk.fault, "") << where;
        if (!disk.fault.empty())
            continue;
        EXPECT_EQ(disk.faces, candidate.faces) << where;
        EXPECT_EQ(disk.other, 0) << where;
        EXPECT_EQ(disk.word.size(), request.word.size()) << where;
        int singular = disk.v3 + disk.v5 + disk.other;
        for (std::size_t v = 0; v < disk.word.size(); ++v) {
            singular += request.regular[v] != 0 && disk.word[v] != request.regular[v];
            if (!request.angles.empty() && disk.word[v] != request.word[v]) {
                const double each = request.angles[v] / disk.word[v];
                EXPECT_LT(each, straight) << where;
                EXPECT_GE(std::sin(each * std::numbers::pi / 180), request.least_sine - 1e-9) << where;
            }
        }
        EXPECT_EQ(singular, candidate.singularities) << where;
    }
    return static_cast<int>(candidates.size());
}

Request region(std::mt19937 &random, int cells) {
    Request request;
    request.word = oracle::region(cells, random);
    request.regular = request.word;
    request.faces = cells;
    request.seed = random();
    return request;
}

TEST(Plan, GridRegionsKeepTheirGrid) {
    std::mt19937 random(18);
    for (int round = 0; round < 40; ++round) {
        Request request = region(random, 4 + static_cast<int>(random() % 22));
        const auto candidates = plan(request);
        ASSERT_FALSE(candidates.empty()) << testing::PrintToString(request.word);
        EXPECT_EQ(candidates.front().faces, request.faces);
        EXPECT_EQ(candidates.front().singularities, 0) << testing::PrintToString(request.word);
        expect_keeps(request);
    }
}

TEST(Plan, GridRegionsWithOtherCounts) {
    std::mt19937 random(19);
    int built = 0;
    for (int round = 0; round < 60; ++round) {
        Request request = region(random, 6 + static_cast<int>(random() % 30));
        request.faces += static_cast<int>(random() % 9) - 4;
        request.any_count = round % 3 == 0;
        request.tolerance = round % 4;
        built += expect_keeps(request);
    }
    EXPECT_GT(built, 100);
}

TEST(Plan, LargeGridRegions) {
    std::mt19937 random(20);
    int built = 0;
    for (int round = 0; round < 25; ++round) {
        Request request = region(random, 60 + static_cast<int>(random() % 100));
        request.faces += static_cast<int>(random() % 31) - 15;
        request.any_count = round % 2 == 0;
        built += expect_keeps(request);
    }
    EXPECT_GT(built, 50);
}

TEST(Plan, RandomWordsWithAngles) {
    std::mt19937 random(21);
    int built = 0;
    for (int round = 0; round < 80; ++round) {
        Request request;
        const std::size_t length = 8 + 2 * (random() % 14);
        for (std::size_t v = 0; v < length; ++v) {
            const auto dice = random() % 8;
            request.word.push_back(dice == 0 ? 1 : dice == 1 ? 3 : 2);
            request.regular.push_back(random() % 4 == 0 ? 0 : 1 + static_cast<int>(random() % 3));
            request.angles.push_back(90.0 * request.word.back() + static_cast<double>(random() % 81) - 40);
        }
        request.faces = static_cast<std::int64_t>(length * length / 14 + random() % 12);
        request.any_count = round % 3 == 1;
        request.least_sine = round % 2 == 0 ? 0 : 0.3;
        request.seed = random();
        built += expect_keeps(request);
    }
    EXPECT_GT(built, 200);
}

TEST(Plan, FlatWordsAndPolygons) {
    std::mt19937 random(22);
    int built = 0;
    for (int round = 0; round < 40; ++round) {
        Request request;
        if (round % 2 == 0)
            request.word.assign(12 + 2 * (random() % 20), 2);
        else
            for (int corner = 0; corner < 3 + round % 5; ++corner) {
                request.word.push_back(1);
                request.word.insert(request.word.end(), 3 + 2 * (random() % 4), 2);
            }
        const std::size_t length = request.word.size();
        request.regular = request.word;
        request.faces = static_cast<std::int64_t>(length * length / (8 + random() % 10));
        request.any_count = round % 5 == 0;
        request.seed = random();
        const int here = expect_keeps(request);
        EXPECT_GT(here, 0) << testing::PrintToString(request.word) << request.faces;
        built += here;
    }
    EXPECT_GT(built, 150);
}

TEST(Plan, GroupsAreThePlan) {
    std::mt19937 random(23);
    for (int round = 0; round < 12; ++round) {
        Request request = region(random, 10 + 3 * round);
        request.faces += round % 3;
        request.any_count = round % 4 == 0;
        request.most = 1000;
        Plan groups(request);
        const auto all = plan(request);
        std::size_t i = 0;
        for (auto group = groups.next(); !group.empty() && i < all.size(); group = groups.next())
            for (const Candidate &candidate : group) {
                ASSERT_LT(i, all.size());
                EXPECT_EQ(candidate.faces, all[i].faces);
                EXPECT_EQ(candidate.build().quads, all[i].build().quads);
                ++i;
            }
        EXPECT_EQ(i, all.size());
        EXPECT_TRUE(groups.next().empty()); // and stays so
    }
}

TEST(Plan, OddAndShortWordsHaveNone) {
    Request request;
    request.word = request.regular = {1, 2, 1, 1, 1};
    request.faces = 2;
    EXPECT_TRUE(plan(request).empty());
    request.word = request.regular = {1, 1};
    EXPECT_TRUE(plan(request).empty());
}

TEST(Plan, IsDeterministic) {
    std::mt19937 random(24);
    for (int round = 0; round < 8; ++round) {
        Request request = region(random, 20 + 10 * round);
        request.faces += 3;
        const auto a = plan(request), b = plan(request);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(a[i].faces, b[i].faces);
            EXPECT_EQ(a[i].singularities, b[i].singularities);
            EXPECT_EQ(a[i].build().quads, b[i].build().quads);
        }
    }
}

} // namespace
