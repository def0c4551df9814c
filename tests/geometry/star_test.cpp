#include "geometry/star.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "square.h"

namespace alphamst::geometry {
namespace {

using samples::noisy;
using samples::Square;

TEST(Star, HasEveryQuadAroundAVertexAsSeenFromIt) {
    const Square s = noisy(5, 0, 1);
    const int n = static_cast<int>(s.points.size());
    const Stars stars(s.quads, n + 1); // the last vertex has no quad
    EXPECT_EQ(stars.vertices(), n + 1);
    EXPECT_TRUE(stars.at(n).empty());
    std::size_t sectors = 0;
    for (int v = 0; v < n; ++v) {
        int before = -1;
        for (const Sector &sector : stars.at(v)) {
            EXPECT_LT(before, sector.quad);
            before = sector.quad;
            std::array<int, 4> quad{v, sector.next, sector.opposite, sector.previous};
            const auto &wanted = s.quads[static_cast<std::size_t>(sector.quad)];
            std::rotate(quad.begin(), std::find(quad.begin(), quad.end(), wanted[0]), quad.end());
            EXPECT_EQ(quad, wanted);
            ++sectors;
        }
    }
    EXPECT_EQ(sectors, 4 * s.quads.size());
}

// Layers of free vertices around the middle of a grid; none beyond a row that is fixed.
TEST(Star, SetsGrowByLayersOfFreeVertices) {
    Square s = noisy(8, 0, 1);
    const auto id = [](int i, int j) { return j * 9 + i; };
    for (int i = 0; i <= 8; ++i)
        s.fixed[static_cast<std::size_t>(id(i, 5))] = 1;
    const Stars stars(s.quads, 81);
    for (const int layers : {0, 1, 2, 9}) {
        std::vector<int> set{id(4, 4)}, wanted;
        std::vector<char> member(81, 0);
        member[static_cast<std::size_t>(set[0])] = 1;
        grow(stars, s.fixed, layers, set, member);
        for (int j = 0; j <= 8; ++j)
            for (int i = 0; i <= 8; ++i)
                if (!s.fixed[static_cast<std::size_t>(id(i, j))] && std::abs(i - 4) <= layers &&
                    std::abs(j - 4) <= layers && j < 5)
                    wanted.push_back(id(i, j));
        for (int v = 0; v < 81; ++v)
            EXPECT_EQ(member[static_cast<std::size_t>(v)],
                      std::count(wanted.begin(), wanted.end(), v)); // each once
        std::sort(set.begin(), set.end());
        EXPECT_EQ(set, wanted) << layers;
    }
}

} // namespace
} // namespace alphamst::geometry
