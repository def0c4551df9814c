#include "smooth/roll_back.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "index.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/reference.h"

namespace alphamst::smooth {
namespace {

constexpr int n = 20, row = n + 1;

struct Sheet {
    mesh::QuadMesh mesh =
        mesh::grid(n, n, [](double s, double t) { return Eigen::Vector3d(n * s, n * t, s * t); });
    geometry::SurfacePositions start, moved;

    Sheet() {
        const reference::Reference reference = reference::reference_of(mesh);
        start = moved = reference.on_surface(mesh);
        for (int v = 0; v < mesh.n_vertices(); ++v)
            moved.put(v, {-1, start.points[at(v)] + Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d::UnitX(), 0});
    }

    bool is_back(int v) const {
        const bool back = moved.points[at(v)] == start.points[at(v)];
        EXPECT_EQ(back, moved.normals[at(v)] == start.normals[at(v)]);
        EXPECT_EQ(back, moved.surface_triangles[at(v)] == start.surface_triangles[at(v)]);
        return back;
    }
    int count_back() const {
        int count = 0;
        for (int v = 0; v < mesh.n_vertices(); ++v)
            count += is_back(v);
        return count;
    }
};

TEST(RollBack, WhereNothingIsSpoiledAllStays) {
    Sheet sheet;
    EXPECT_TRUE(
        roll_back(sheet.mesh.faces(), sheet.start, sheet.moved, {}, [] { return std::vector<int>(); }));
    EXPECT_EQ(sheet.count_back(), 0);
}

// One layer around the quad, then one more, then two more, until it is content.
TEST(RollBack, GoesFartherAroundWhatIsStillSpoiled) {
    const int quad = 10 * n + 10;
    int last = 0;
    for (const int times : {1, 2, 3}) {
        Sheet sheet;
        int asked = 0;
        EXPECT_TRUE(roll_back(sheet.mesh.faces(), sheet.start, sheet.moved, {}, [&] {
            return asked++ < times ? std::vector<int>{quad, quad} : std::vector<int>{};
        }));
        EXPECT_EQ(asked, times + 1);
        const int width = 2 + 2 * (1 + times * (times - 1) / 2);
        EXPECT_EQ(sheet.count_back(), width * width);
        EXPECT_GT(sheet.count_back(), last);
        for (const int v : sheet.mesh.corners(quad))
            EXPECT_TRUE(sheet.is_back(v));
        last = sheet.count_back();
    }
}

TEST(RollBack, SaysSoWhereNothingHelps) {
    Sheet sheet;
    EXPECT_FALSE(
        roll_back(sheet.mesh.faces(), sheet.start, sheet.moved, {}, [] { return std::vector<int>{0}; }));
}

// What was taken back would lie beyond its neighbour on the line, which moved: that one comes back, too.
TEST(RollBack, VerticesThatWerePassedComeBack) {
    Sheet sheet;
    sheet.moved = sheet.start;
    const int one = 5 * row + 5;
    std::vector<geometry::FeatureLine> lines(sheet.start.points.size());
    lines[at(one)].lines = {{sheet.start.points[at(one - 1)], sheet.start.points[at(one + 1)]}};
    lines[at(one)].between = {one - 1, one + 1};
    sheet.moved.points[at(one)] += Eigen::Vector3d(0.5, 0, 0);
    geometry::SurfacePositions good = sheet.moved;
    const auto none = [] { return std::vector<int>(); };
    EXPECT_TRUE(roll_back(sheet.mesh.faces(), sheet.start, good, lines, none));
    EXPECT_EQ(good.points[at(one)], sheet.moved.points[at(one)]);
    sheet.moved.points[at(one)] += Eigen::Vector3d(1, 0, 0);
    EXPECT_TRUE(roll_back(sheet.mesh.faces(), sheet.start, sheet.moved, lines, none));
    EXPECT_EQ(sheet.moved.points[at(one)], sheet.start.points[at(one)]);
}

} // namespace
} // namespace alphamst::smooth
