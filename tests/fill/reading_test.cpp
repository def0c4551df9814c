#include "fill/reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "oracle.h"

namespace {

using namespace alphamst::fill;

Request request_of(const Word &word, std::int64_t faces) {
    Request request;
    request.word = request.regular = word;
    request.faces = faces;
    return request;
}

TEST(Reading, ARectangleIsReadAsItself) {
    const Request request = request_of(oracle::polygon({5, 4, 5, 4}), 40);
    Readings readings(request);
    EXPECT_EQ(readings.least(), 0);
    const Reading first = readings.up_to(0).front();
    EXPECT_EQ(first.corners, (std::vector{0, 5, 9, 14}));
    EXPECT_EQ(first.sides, (Sides{5, 4, 5, 4}));
    EXPECT_EQ(first.changed, 0);
    EXPECT_EQ(first.least, 0);
    EXPECT_DOUBLE_EQ(first.natural, 20);
    EXPECT_DOUBLE_EQ(first.count_error, std::log(2.0));
}

TEST(Reading, AnLIsCutToARectangleFirst) {
    // The concave vertex and a corner cancel by one row of quads.
    const Request request = request_of({1, 2, 2, 2, 1, 2, 1, 2, 3, 2, 1, 2, 1, 2, 2, 2}, 12);
    Readings readings(request);
    EXPECT_EQ(readings.least(), 0);
    bool regular = false;
    for (const Reading &reading : readings.up_to(0))
        regular = regular || (reading.least == 0 && !reading.front->quads.empty() && reading.changed == 0);
    EXPECT_TRUE(regular);
}

TEST(Reading, ReadingsKeepTheirNumbersAndTheirOrder) {
    std::mt19937 random(61);
    std::size_t seen = 0;
    for (int round = 0; round < 40; ++round) {
        Request request = request_of(oracle::region(8 + static_cast<int>(random() % 40), random), 0);
        request.faces = 10 + static_cast<int>(random() % 40);
        request.seed = random();
        for (int &letter : request.regular)
            if (random() % 6 == 0)
                letter = static_cast<int>(random() % 4); // 0: none counts
        Readings readings(request);
        const int least = readings.least();
        const Reading *before = nullptr;
        for (const Reading &reading : readings.up_to(least + 6)) {
            ++seen;
            EXPECT_GE(reading.least, least);
            EXPECT_GE(reading.least, reading.changed);
            EXPECT_TRUE(std::is_sorted(reading.corners.begin(), reading.corners.end()));
            EXPECT_EQ(reading.sides.size(), reading.corners.size());
            if (!reading.corners.empty()) {
                EXPECT_EQ(std::accumulate(reading.sides.begin(), reading.sides.end(), 0),
                          static_cast<int>(reading.front->word.size()));
            }
            if (before != nullptr) {
                EXPECT_TRUE(before->least < reading.least ||
                            (before->least == reading.least && before->count_error <= reading.count_error));
            }
            before = &reading;
        }
    }
    EXPECT_GT(seen, 200U);
}

// A vertex that is read with another letter than the one that makes it regular counts.
TEST(Reading, ChangedCountsWhatBecomesSingular) {
    Request request = request_of(oracle::polygon({3, 3, 3, 3, 3, 3}), 12);
    Readings all(request);
    for (const Reading &reading : all.up_to(20))
        if (reading.front->quads.empty()) {
            int changed = 0;
            for (std::size_t i = 0; i < request.word.size(); ++i) {
                const bool corner =
                    std::count(reading.corners.begin(), reading.corners.end(), static_cast<int>(i)) > 0;
                changed += (corner ? 1 : 2) != request.regular[i];
            }
            EXPECT_EQ(reading.changed, changed);
        }
    std::fill(request.regular.begin(), request.regular.end(), 0);
    Readings free(request);
    for (const Reading &reading : free.up_to(20))
        if (reading.front->quads.empty()) {
            EXPECT_EQ(reading.changed, 0);
        }
}

// A straight angle is no corner of one face, and one that is too sharp for two stays a corner.
TEST(Reading, AnglesForbidReadings) {
    Request request = request_of(oracle::polygon({4, 4, 4, 4}), 16);
    request.angles.assign(16, 180);
    for (const std::size_t corner : {0U, 4U, 8U, 12U})
        request.angles[corner] = 90;
    request.angles[4] = 20; // two faces there would have 10 degrees
    for (const double least_sine : {0.0, 0.3}) {
        request.least_sine = least_sine;
        Readings readings(request);
        std::size_t with = 0, without = 0;
        for (const Reading &reading : readings.up_to(20))
            if (reading.front->quads.empty()) {
                for (const int corner : reading.corners)
                    EXPECT_EQ(corner % 4, 0);
                const bool there = std::count(reading.corners.begin(), reading.corners.end(), 4) > 0;
                ++(there ? with : without);
            }
        EXPECT_GT(with, 0U);
        EXPECT_EQ(without > 0, least_sine == 0);
    }
}

} // namespace
