#include "patch/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::block;
using testing::cube;
using testing::grid;
using testing::mark;
using testing::none;
using testing::set_feature;
using testing::without;

TEST(Repair, KeepsADisk) {
    const mesh::QuadMesh mesh = grid(5, 5);
    EXPECT_EQ(repair(mesh, block(5, 1, 1, 3, 4), none), block(5, 1, 1, 3, 4));
    EXPECT_EQ(repair(mesh, {7}, none), (std::vector<int>{7}));
    EXPECT_TRUE(repair(mesh, {}, none).empty());
    EXPECT_TRUE(repair(mesh, {7}, mark(mesh, {7})).empty());
}

TEST(Repair, KeepsTheLargestPartTheFirstOfEquals) {
    const mesh::QuadMesh mesh = grid(5, 5);
    EXPECT_EQ(repair(mesh, {0, 12, 13, 24}, none), (std::vector<int>{12, 13}));
    EXPECT_EQ(repair(mesh, {23, 24, 0, 1}, none), (std::vector<int>{0, 1}));
    EXPECT_EQ(repair(mesh, {6, 12}, none), (std::vector<int>{6}));
}

TEST(Repair, FillsHolesThatAreFree) {
    const mesh::QuadMesh mesh = grid(7, 7);
    const std::vector<int> hole = {24}, ring = without(block(7, 2, 2, 5, 5), hole);
    EXPECT_EQ(repair(mesh, ring, none), block(7, 2, 2, 5, 5));
    const std::vector<int> cut = repair(mesh, ring, mark(mesh, hole));
    EXPECT_EQ(defects(mesh, cut), 0);
    EXPECT_EQ(cut.size(), 7U);
    // Two holes, of which one is taken.
    const std::vector<int> two = without(block(7, 1, 1, 6, 4), {16, 18});
    const std::vector<int> repaired = repair(mesh, two, mark(mesh, {16}));
    EXPECT_EQ(defects(mesh, repaired), 0);
    EXPECT_NE(std::find(repaired.begin(), repaired.end(), 18), repaired.end());
}

// A ring that touches itself at a corner holds a free hole; with the hole taken, one of
// the two faces at the corner must go.
TEST(Repair, LeavesRings) {
    const mesh::QuadMesh mesh = grid(9, 9);
    const std::vector<int> hole = block(9, 3, 3, 6, 6), ring = without(block(9, 1, 1, 8, 8), hole);
    EXPECT_EQ(repair_but_rings(mesh, ring, none), ring);
    EXPECT_EQ(repair(mesh, ring, none), block(9, 1, 1, 8, 8));
    // A face left out is an oversight.
    const std::vector<int> dotted = without(block(9, 1, 1, 8, 8), {40});
    EXPECT_EQ(repair_but_rings(mesh, dotted, none), block(9, 1, 1, 8, 8));
    EXPECT_EQ(defects(mesh, repair_but_rings(mesh, {0, 1, 11, 20}, none)), 0); // pinched
}

TEST(Repair, OpensPinches) {
    const mesh::QuadMesh mesh = grid(5, 5);
    const std::vector<int> pinched_set = without(block(5, 1, 1, 4, 4), {12, 18});
    ASSERT_EQ(defects(mesh, pinched_set), static_cast<std::int32_t>(pinched));
    EXPECT_EQ(repair(mesh, pinched_set, none), without(block(5, 1, 1, 4, 4), {18}));
    const std::vector<int> open = repair(mesh, pinched_set, mark(mesh, {12}));
    EXPECT_EQ(defects(mesh, open), 0);
    EXPECT_EQ(open.size(), 6U);
}

// The hole of a domain cannot be filled.
TEST(Repair, CutsAnAnnulusOpen) {
    const mesh::QuadMesh whole = grid(6, 6);
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int v = 0; v < whole.n_vertices(); ++v)
        points.insert(points.end(), {whole.point(v)[0], whole.point(v)[1], 0.0});
    for (const int face : without(block(6, 0, 0, 6, 6), block(6, 2, 2, 4, 4)))
        for (const int v : whole.corners(face))
            faces.push_back(v);
    const mesh::QuadMesh mesh = mesh::QuadMesh::build(2, points, faces);
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    ASSERT_EQ(defects(mesh, all), static_cast<std::int32_t>(not_disk));
    const std::vector<int> disk = repair(mesh, all, none);
    EXPECT_EQ(defects(mesh, disk), 0);
    EXPECT_EQ(disk.size(), 30U); // 32 less one row across
}

TEST(Repair, ClosedSurfaceKeepsItsOutside) {
    const mesh::QuadMesh cube = testing::cube();
    EXPECT_EQ(defects(cube, repair(cube, {0, 1, 2, 3, 4, 5}, none)), 0);
    EXPECT_EQ(repair(cube, {0, 1, 2, 3, 4, 5}, none).size(), 5U);
    EXPECT_EQ(repair(cube, {0, 2, 4}, none), (std::vector<int>{0, 2, 4}));
    EXPECT_EQ(defects(cube, repair(cube, {2, 3, 4, 5}, none)), 0); // a belt
}

TEST(Repair, FeaturesSeparate) {
    mesh::QuadMesh mesh = grid(4, 4);
    for (int j = 0; j < 4; ++j)
        set_feature(mesh, 5 * j + 1, 5 * (j + 1) + 1);
    EXPECT_EQ(repair(mesh, block(4, 0, 0, 4, 4), none), block(4, 1, 0, 4, 4));

    mesh::QuadMesh regions = grid(4, 4);
    regions.face_marker.assign(16, 1);
    for (const int face : block(4, 0, 0, 1, 4))
        regions.face_marker[static_cast<std::size_t>(face)] = 2;
    EXPECT_EQ(repair(regions, block(4, 0, 0, 4, 4), none), block(4, 1, 0, 4, 4));
}

TEST(Repair, CutsAlongAFeatureThatEndsInside) {
    mesh::QuadMesh mesh = grid(6, 6);
    set_feature(mesh, 16, 17);
    set_feature(mesh, 17, 18);
    const std::vector<int> all = block(6, 0, 0, 6, 6), disk = repair(mesh, all, none);
    EXPECT_EQ(defects(mesh, disk), 0);
    EXPECT_GE(disk.size(), 28U);

    mesh::QuadMesh held = grid(6, 6);
    held.vertex_flags[24] = mesh::corner;
    EXPECT_EQ(defects(held, repair(held, all, none)), 0);
    EXPECT_GE(repair(held, all, none).size(), 32U);
}

TEST(Repair, RandomSetsBecomeDisks) {
    std::mt19937 random(5);
    mesh::QuadMesh mesh = grid(12, 12);
    const auto chance = [&](auto percent) { return random() % 100 < percent; };
    for (int n = 0; n < 600; ++n) {
        const auto density = 20 + random() % 80, occupied = n % 3 ? random() % 30 : 0U;
        const auto features = n % 2 ? random() % 6 : 0U;
        std::vector<int> faces;
        std::vector<char> taken(144, 0);
        for (int f = 0; f < 144; ++f) {
            if (chance(density))
                faces.push_back(f);
            taken[static_cast<std::size_t>(f)] = chance(occupied);
        }
        for (auto &flags : mesh.edge_flags)
            flags = chance(features) ? mesh::feature : 0;
        for (auto &flags : mesh.vertex_flags)
            flags = chance(features / 2) ? mesh::fixed : 0;
        const std::vector<int> disk = repair(mesh, faces, taken);
        if (disk.empty()) {
            for (const int f : faces)
                EXPECT_TRUE(taken[static_cast<std::size_t>(f)]);
            continue;
        }
        ASSERT_EQ(defects(mesh, disk), 0) << "set " << n;
        EXPECT_TRUE(std::is_sorted(disk.begin(), disk.end()));
        for (const int f : disk)
            EXPECT_FALSE(taken[static_cast<std::size_t>(f)]);
        EXPECT_EQ(make_window(mesh, disk).loop.size() % 2, 0U);
        EXPECT_EQ(repair(mesh, disk, taken), disk);
    }
}

} // namespace
} // namespace alphamst::patch
