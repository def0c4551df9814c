#include "mesh/hanging.h"

#include <gtest/gtest.h>

namespace alphamst::mesh {
namespace {

using Edges = std::vector<std::array<std::int32_t, 2>>;

std::vector<std::int32_t> vertices(const std::vector<double> &points, const Edges &edges) {
    std::vector<std::int32_t> found;
    for (const Hanging &hanging : find_hanging(points, edges)) {
        EXPECT_EQ(hanging.edge, 0u);
        found.push_back(hanging.vertex);
    }
    return found;
}

// From (0, 0) to (4, 0), and vertices on the way and beside it.
const std::vector<double> points{0, 0, 0, 4, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 2, 1, 0};

TEST(Hanging, AllAlongAnEdge) {
    EXPECT_EQ(vertices(points, {{0, 1}, {0, 3}, {1, 3}}), (std::vector<std::int32_t>{3}));
    EXPECT_EQ(vertices(points, {{0, 1}, {2, 0}, {3, 2}, {3, 4}, {1, 4}}),
              (std::vector<std::int32_t>{2, 3, 4}));
}

TEST(Hanging, NotBesideItNorHalfTheWay) {
    EXPECT_TRUE(vertices(points, {{0, 1}, {0, 5}, {5, 1}}).empty());
    EXPECT_TRUE(vertices(points, {{0, 1}, {0, 3}, {3, 4}}).empty());
    EXPECT_TRUE(vertices(points, {{0, 1}}).empty());
    EXPECT_TRUE(vertices({0, 0, 0, 0, 0, 0, 1, 0, 0}, {{0, 1}, {1, 2}, {2, 0}}).empty());
}

// A vertex of very many edges must not cost the square of their number.
TEST(Hanging, NotAtAHub) {
    Edges edges;
    std::vector<double> hub{0, 0, 0};
    for (int i = 1; i <= 100000; ++i) {
        hub.insert(hub.end(), {1.0 * i, 0, 0});
        edges.push_back({0, i});
    }
    EXPECT_TRUE(find_hanging(hub, edges).empty());
}

} // namespace
} // namespace alphamst::mesh
