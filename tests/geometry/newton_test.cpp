#include "geometry/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "square.h"

namespace alphamst::geometry {
namespace {

using samples::noisy;
using samples::Square;

// A square with what its problem refers to.
struct Setting {
    explicit Setting(Square square)
        : s(std::move(square)), stars(s.quads, static_cast<int>(s.points.size())), area(s.quads.size(), 1) {}
    Setting(const Setting &) = delete;

    Problem problem() const { return {s.quads, stars, s.fixed, area}; }
    std::vector<int> all() const {
        std::vector<int> quads(s.quads.size());
        std::iota(quads.begin(), quads.end(), 0);
        return quads;
    }

    Square s;
    Stars stars;
    std::vector<double> area;
};

constexpr double margin = 1e-9;

TEST(Newton, ARegionIsWhatIsFreeAroundItsSeeds) {
    const Setting setting(noisy(8, 0, 1));
    const std::vector<int> seed{8 * 4 + 4}; // its corners are (4, 4) to (5, 5)
    FreeRegion region(setting.problem(), seed, 0);
    const auto expect_block = [&](int low, int high) { // of vertices
        std::vector<int> vertices = region.vertices, wanted, quads;
        std::sort(vertices.begin(), vertices.end());
        for (int j = low; j <= high; ++j)
            for (int i = low; i <= high; ++i)
                wanted.push_back(9 * j + i);
        for (int j = low - 1; j <= high; ++j)
            for (int i = low - 1; i <= high; ++i)
                quads.push_back(8 * j + i);
        EXPECT_EQ(vertices, wanted);
        EXPECT_EQ(region.quads, quads);
        for (int v = 0; v < 81; ++v)
            EXPECT_EQ(region.member[static_cast<std::size_t>(v)] != 0,
                      std::binary_search(wanted.begin(), wanted.end(), v));
    };
    expect_block(4, 5);
    region.extend(setting.problem(), 2);
    expect_block(2, 7); // 8 is fixed
}

TEST(Newton, WorstDeterminantIsOverTheWantedArea) {
    Setting setting(noisy(6, 0.4, 3));
    for (std::size_t q = 0; q < setting.area.size(); ++q)
        setting.area[q] = 1 + static_cast<double>(q % 3);
    double worst = 1e9;
    for (std::size_t q = 0; q < setting.area.size(); ++q)
        worst = std::min(worst, judge(Quads(&setting.s.quads[q], 1), setting.s.points).min_determinant /
                                    setting.area[q]);
    EXPECT_NEAR(worst_determinant(setting.problem(), setting.all(), setting.s.points), worst, 1e-14);
}

TEST(Newton, TurnsEveryCornerOfItsRegionPositive) {
    for (const unsigned seed : {2U, 5U, 8U}) {
        const Setting setting(noisy(8, 1.5, seed));
        Points points = setting.s.points;
        ASSERT_FALSE(judge(setting.s.quads, points).valid);
        const FreeRegion region(setting.problem(), setting.all(), 0);
        int iterations = 100;
        EXPECT_TRUE(Newton(setting.problem(), region).untangle(points, iterations, margin));
        EXPECT_LT(iterations, 100);
        EXPECT_GT(iterations, 0);
        EXPECT_GT(worst_determinant(setting.problem(), region.quads, points), margin);
        for (std::size_t v = 0; v < points.size(); ++v)
            if (setting.s.fixed[v]) {
                EXPECT_EQ(points[v], setting.s.points[v]);
            }
    }
}

TEST(Newton, LeavesWhatIsOutsideItsRegion) {
    Square s = noisy(8, 0, 1);
    s.points[4 * 9 + 4] = {6.3, 4.2}; // right across two columns
    const Setting setting(std::move(s));
    Points points = setting.s.points;
    const std::vector<int> seed{8 * 4 + 4};
    const FreeRegion region(setting.problem(), seed, 1);
    int iterations = 60;
    EXPECT_TRUE(Newton(setting.problem(), region).untangle(points, iterations, margin));
    for (std::size_t v = 0; v < points.size(); ++v)
        if (!region.member[v]) {
            EXPECT_EQ(points[v], setting.s.points[v]);
        }
    EXPECT_TRUE(judge(setting.s.quads, points).valid);
}

TEST(Newton, WithoutIterationsOrVerticesItOnlyLooks) {
    const Setting folded(noisy(8, 1.5, 2)), even(noisy(8, 0, 2));
    for (const Setting *setting : {&folded, &even}) {
        Points points = setting->s.points;
        const FreeRegion region(setting->problem(), setting->all(), 0);
        int none = 0;
        EXPECT_EQ(Newton(setting->problem(), region).untangle(points, none, margin), setting == &even);
        EXPECT_EQ(points, setting->s.points);
        EXPECT_EQ(none, 0);
    }
}

} // namespace
} // namespace alphamst::geometry
