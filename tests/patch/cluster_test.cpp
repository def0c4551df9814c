#include "patch/decompose.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::grid;
using testing::none;

std::vector<std::vector<int>> members(const std::vector<std::size_t> &group, std::size_t n) {
    std::vector<std::vector<int>> groups(n);
    for (std::size_t i = 0; i < group.size(); ++i)
        groups.at(group[i]).push_back(static_cast<int>(i));
    return groups;
}

// Where the mesh is a strip, the means of two groups accept_or_roll_back where the groups are equal.
TEST(Cluster, LloydHalvesAStrip) {
    const FaceDual dual = duals(grid(40, 1), none).front();
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto groups = members(lloyd(dual, 2, seed), 2);
        EXPECT_NEAR(static_cast<double>(groups[0].size()), 20, 1) << seed;
        for (const auto &group : groups) // in one piece
            EXPECT_EQ(group.back() - group.front() + 1, static_cast<int>(group.size()));
    }
}

TEST(Cluster, EveryGroupIsConnectedAndNoneIsEmpty) {
    const mesh::QuadMesh mesh = testing::islands();
    for (const FaceDual &dual : duals(mesh, none))
        for (const std::size_t n : {1U, 5U, 40U}) {
            const auto group = lloyd(dual, n, 3);
            for (const auto &nodes : members(group, n)) {
                ASSERT_FALSE(nodes.empty());
                std::set<int> left(nodes.begin() + 1, nodes.end());
                std::vector<int> stack{nodes.front()};
                while (!stack.empty()) {
                    const int node = stack.back();
                    stack.pop_back();
                    for (const int next : dual.neighbours(static_cast<std::size_t>(node)))
                        if (left.erase(next) > 0)
                            stack.push_back(next);
                }
                EXPECT_TRUE(left.empty());
            }
        }
}

TEST(Cluster, TheSeedDecides) {
    const FaceDual dual = duals(grid(20, 20), none).front();
    EXPECT_EQ(lloyd(dual, 7, 1), lloyd(dual, 7, 1));
    EXPECT_NE(lloyd(dual, 7, 1), lloyd(dual, 7, 2));
}

} // namespace
} // namespace alphamst::patch
