#include "mesh/renumbered.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace alphamst::mesh {
namespace {

TEST(Renumbered, NumbersAreNamesAtTheStart) {
    const Renumbered numbers(5);
    for (int name = 0; name < 5; ++name)
        EXPECT_EQ(numbers.now(name), name);
}

TEST(Renumbered, WhatIsGoneHasNoNumber) {
    Renumbered numbers(5);
    numbers.remove(3);
    EXPECT_EQ(numbers.now(3), -1);
    EXPECT_EQ(numbers.now(2), 2);
    EXPECT_EQ(numbers.now(4), 4);
}

TEST(Renumbered, ANewOneTakesAFreeNumberAndAnotherName) {
    Renumbered numbers(5);
    numbers.remove(3);
    const int name = numbers.add(3);
    EXPECT_EQ(name, 5);
    EXPECT_EQ(numbers.now(name), 3);
    EXPECT_EQ(numbers.now(3), -1);
    EXPECT_EQ(numbers.add(5), 6);
    EXPECT_EQ(numbers.now(6), 5);
    numbers.remove(3); // the new one, not the old one again
    EXPECT_EQ(numbers.now(name), -1);
    EXPECT_EQ(numbers.now(6), 5);
}

TEST(Renumbered, TheLastMovesIntoAGapAndGoesOnMoving) {
    Renumbered numbers(5);
    numbers.remove(1);
    numbers.move(4, 1);
    EXPECT_EQ(numbers.now(4), 1);
    numbers.remove(0);
    numbers.move(1, 0);
    EXPECT_EQ(numbers.now(4), 0);
    EXPECT_EQ(numbers.now(1), -1);
    const int name = numbers.add(1);
    EXPECT_EQ(numbers.now(name), 1);
    EXPECT_EQ(numbers.now(4), 0);
}

// Beside a plain list of the names by number.
TEST(Renumbered, FollowsManyChanges) {
    std::mt19937 random(7);
    std::vector<int> names;
    for (int i = 0; i < 20; ++i)
        names.push_back(i);
    Renumbered numbers(20);
    int known = 20;
    for (int step = 0; step < 500; ++step) {
        const int last = static_cast<int>(names.size()) - 1;
        if (random() % 2 == 0 || last < 3) {
            names.push_back(numbers.add(last + 1));
            EXPECT_EQ(names.back(), known++);
        } else {
            const int gone = static_cast<int>(random() % names.size());
            numbers.remove(gone);
            if (gone != last)
                numbers.move(last, gone);
            names[static_cast<std::size_t>(gone)] = names.back();
            names.pop_back();
        }
    }
    std::vector<int> now(static_cast<std::size_t>(known), -1);
    for (std::size_t i = 0; i < names.size(); ++i)
        now[static_cast<std::size_t>(names[i])] = static_cast<int>(i);
    for (int name = 0; name < known; ++name)
        EXPECT_EQ(numbers.now(name), now[static_cast<std::size_t>(name)]) << name;
}

} // namespace
} // namespace alphamst::mesh
