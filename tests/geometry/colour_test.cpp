#include "geometry/colour.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace alphamst::geometry {
namespace {

TEST(Colour, GivesEveryFreeVertexOneClassAndNoQuadTwoOfAClass) {
    constexpr int n = 9;
    std::vector<std::array<int, 4>> quads;
    for (int y = 0; y + 1 < n; ++y)
        for (int x = 0; x + 1 < n; ++x)
            quads.push_back({y * n + x, y * n + x + 1, (y + 1) * n + x + 1, (y + 1) * n + x});
    const Stars stars(quads, n * n);
    std::vector<char> fixed(n * n, 0);
    fixed[4] = fixed[40] = 1;
    const std::vector<double> area(quads.size(), 1.0);
    const Problem problem{quads, stars, fixed, area};
    const auto classes = colour(problem);
    EXPECT_EQ(classes.size(), 4u);
    std::multiset<int> all;
    for (const auto &vertices : classes) {
        all.insert(vertices.begin(), vertices.end());
        for (const auto &quad : quads)
            EXPECT_LE(std::count_if(quad.begin(), quad.end(),
                                    [&](int v) {
                                        return std::find(vertices.begin(), vertices.end(), v) !=
                                               vertices.end();
                                    }),
                      1);
    }
    EXPECT_EQ(all.size(), n * n - 2u);
    EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), all.size());
    EXPECT_EQ(all.count(4) + all.count(40), 0u);
}

} // namespace
} // namespace alphamst::geometry
