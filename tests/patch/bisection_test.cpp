#include "patch/bisection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "index.h"

namespace alphamst::patch {
namespace {

const Pace unwatched;

// Faces of a grid, without those of a block in its middle.
Graph grid_graph(int nx, int ny, int hole = 0) {
    const auto inside = [&](int i, int j) {
        const bool in_hole =
            2 * std::abs(2 * i + 1 - nx) < 2 * hole && 2 * std::abs(2 * j + 1 - ny) < 2 * hole;
        return i >= 0 && i < nx && j >= 0 && j < ny && !in_hole;
    };
    std::vector<std::int32_t> number(at(nx * ny), -1);
    std::int32_t count = 0;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            if (inside(i, j))
                number[at(j * nx + i)] = count++;
    Graph graph;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            if (!inside(i, j))
                continue;
            for (const auto &[a, b] : {std::pair(i - 1, j), {i + 1, j}, {i, j - 1}, {i, j + 1}})
                if (inside(a, b))
                    graph.links.push_back(number[at(b * nx + a)]);
            graph.start.push_back(static_cast<std::int32_t>(graph.links.size()));
            graph.places.emplace_back(i, j, 0);
        }
    return graph;
}

std::size_t cut(const Graph &graph, const std::vector<char> &side) {
    std::size_t twice = 0;
    for (std::size_t i = 0; i < graph.size(); ++i)
        for (const std::int32_t next : graph.neighbours(i))
            twice += side[i] != side[at(next)];
    return twice / 2;
}

bool connected(const Graph &graph, const std::vector<char> &side, char which) {
    std::vector<char> seen(graph.size(), 0);
    std::vector<std::size_t> queue;
    const auto first = std::find(side.begin(), side.end(), which) - side.begin();
    queue.push_back(at(first));
    seen[at(first)] = 1;
    for (std::size_t q = 0; q < queue.size(); ++q)
        for (const std::int32_t next : graph.neighbours(queue[q]))
            if (side[at(next)] == which && !seen[at(next)]) {
                seen[at(next)] = 1;
                queue.push_back(at(next));
            }
    return std::ssize(queue) == std::count(side.begin(), side.end(), which);
}

TEST(Bisection, AGridIsCutStraight) {
    const Graph graph = grid_graph(20, 10);
    Random random(1);
    const std::vector<char> side = bisect(graph, 100, 0, random, unwatched);
    EXPECT_EQ(std::count(side.begin(), side.end(), 0), 100);
    EXPECT_EQ(cut(graph, side), 10U);
}

TEST(Bisection, SidesHaveTheWantedNodesAndAreConnected) {
    const Graph graph = grid_graph(30, 24, 8);
    for (const std::size_t wanted : {10U, 100U, 300U, 600U})
        for (const std::size_t slack : {0U, 5U})
            for (const std::uint64_t seed : {1U, 2U, 3U}) {
                Random random(seed);
                const std::vector<char> side = bisect(graph, wanted, slack, random, unwatched);
                EXPECT_NEAR(static_cast<double>(std::count(side.begin(), side.end(), 0)),
                            static_cast<double>(wanted), static_cast<double>(slack));
                EXPECT_TRUE(connected(graph, side, 0));
                EXPECT_TRUE(connected(graph, side, 1));
            }
}

TEST(Bisection, EqualSeedsGiveEqualSides) {
    const Graph graph = grid_graph(31, 17, 4);
    Random first(5), again(5);
    EXPECT_EQ(bisect(graph, 200, 2, first, unwatched), bisect(graph, 200, 2, again, unwatched));
}

TEST(Bisection, CanBeStoppedSoon) {
    struct Stop {};
    const Graph graph = grid_graph(60, 60);
    int pauses = 0;
    Random random(1);
    const Progress stop = [&](double, const char *) {
        if (++pauses == 3)
            throw Stop();
    };
    EXPECT_THROW(bisect(graph, 1800, 0, random, Pace(stop, "bisect")), Stop);
    Random other(1);
    const Progress count = [&](double, const char *) { ++pauses; };
    bisect(graph, 1800, 0, other, Pace(count, "bisect"));
    EXPECT_GT(pauses, 6);
}

} // namespace
} // namespace alphamst::patch
