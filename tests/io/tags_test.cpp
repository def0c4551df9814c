#include "io/tags.h"

#include <gtest/gtest.h>

namespace alphamst::io {
namespace {

TEST(Tags, TagsAreFoundInAnyOrder) {
    Tags nodes;
    for (const std::int64_t tag : std::initializer_list<std::int64_t>{7, 3, 1000000000000})
        nodes.add(tag);
    EXPECT_TRUE(nodes.close());
    EXPECT_EQ(nodes.find(7), 0);
    EXPECT_EQ(nodes.find(3), 1);
    EXPECT_EQ(nodes.find(1000000000000), 2);
    EXPECT_EQ(nodes.find(1), -1);
    EXPECT_EQ(nodes.find(-1), -1);
    EXPECT_EQ(nodes.tag_of(1), 3);
    ASSERT_EQ(nodes.between(4, 7).size(), 1u);
    EXPECT_EQ(nodes.between(4, 7)[0].second, 0);
    EXPECT_EQ(nodes.between(-9, 2000000000000).size(), 3u);
    EXPECT_TRUE(nodes.between(8, 2).empty());
}

TEST(Tags, ATagThatComesTwiceIsSeen) {
    Tags nodes;
    for (const std::int64_t tag : std::initializer_list<std::int64_t>{1, 2, 1})
        nodes.add(tag);
    EXPECT_FALSE(nodes.close());
}

} // namespace
} // namespace alphamst::io
