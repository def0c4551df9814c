#include "patch/grow.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid.h"
#include "patch/window.h"

namespace alphamst::patch {
namespace {

TEST(Growth, EveryNearnessGivesADiskOfTheSize) {
    const mesh::QuadMesh mesh = testing::grid(20, 20);
    Growth growth(mesh);
    for (const Nearness nearness : {Nearness::ball, Nearness::rings, Nearness::path, Nearness::ellipse})
        for (const int most : {1, 4, 9, 30, 100}) {
            GrowthPlan plan;
            plan.start = 10 * 21 + 10;
            plan.other = 14 * 21 + 12;
            plan.most = most;
            plan.nearness = nearness;
            plan.direction = 0.7;
            const std::vector<int> faces = growth.disk(plan);
            EXPECT_GE(static_cast<int>(faces.size()), most);
            EXPECT_LE(static_cast<int>(faces.size()), most + most / 2);
            EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
            EXPECT_EQ(defects(mesh, faces), 0);
        }
}

TEST(Growth, APathReachesItsEnd) {
    const mesh::QuadMesh mesh = testing::grid(20, 20);
    Growth growth(mesh);
    GrowthPlan plan;
    plan.start = 10 * 21 + 3;
    plan.other = 10 * 21 + 16;
    plan.most = 40;
    plan.nearness = Nearness::path;
    const std::vector<int> faces = growth.disk(plan);
    for (const int v : {plan.start, plan.other})
        for (const int f : mesh.faces_around(v))
            EXPECT_TRUE(std::binary_search(faces.begin(), faces.end(), f));
}

TEST(Growth, SurroundsADiskLayerByLayer) {
    const mesh::QuadMesh mesh = testing::grid(30, 30);
    Growth growth(mesh);
    GrowthPlan plan;
    plan.start = 10 * 31 + 10;
    plan.most = 4;
    const std::vector<int> disk = growth.disk(plan);
    ASSERT_EQ(disk.size(), 4u);
    EXPECT_EQ(growth.surround(disk, 1).size(), 16u);
    const std::vector<int> around = growth.surround(disk, 2);
    EXPECT_EQ(around.size(), 36u);
    EXPECT_TRUE(std::equal(disk.begin(), disk.end(), around.begin()));
}

TEST(Growth, StopsAtFlags) {
    mesh::QuadMesh mesh = testing::grid(10, 10);
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (f % 10 == 6)
            mesh.face_flags[static_cast<std::size_t>(f)] = mesh::fixed;
    Growth growth(mesh);
    GrowthPlan plan;
    plan.start = 5 * 11 + 4;
    plan.most = 80;
    const std::vector<int> faces = growth.disk(plan);
    EXPECT_EQ(faces.size(), 60u);
    EXPECT_EQ(defects(mesh, faces), 0);
}

} // namespace
} // namespace alphamst::patch
