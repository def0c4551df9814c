#include "patch/window.h"

#include "grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace alphamst::patch {
namespace {

using testing::block;
using testing::grid;
using testing::without;

TEST(Window, SingleFace) {
    const mesh::QuadMesh mesh = grid(3, 3);
    const std::vector<int> centre = {4}, first = {0};
    EXPECT_EQ(defects(mesh, centre), 0);
    const Window inner = make_window(mesh, centre);
    EXPECT_EQ(inner.loop, (std::vector<int>{5, 6, 10, 9}));
    EXPECT_EQ(inner.inside, (std::vector<int>{1, 1, 1, 1}));
    EXPECT_EQ(inner.outside, (std::vector<int>{3, 3, 3, 3}));
    EXPECT_EQ(inner.wanted, (std::vector<int>{1, 1, 1, 1}));
    EXPECT_TRUE(inner.interior.empty());

    const Window rim = make_window(mesh, first);
    EXPECT_EQ(rim.loop, (std::vector<int>{0, 1, 5, 4}));
    EXPECT_EQ(rim.outside, (std::vector<int>{0, 1, 3, 1}));
    EXPECT_EQ(rim.wanted, (std::vector<int>{1, 1, 1, 1}));
}

TEST(Window, WholeGrid) {
    const mesh::QuadMesh mesh = grid(3, 2);
    const Window window = make_window(mesh, block(3, 0, 0, 3, 2));
    EXPECT_EQ(window.loop, (std::vector<int>{0, 1, 2, 3, 7, 11, 10, 9, 8, 4}));
    EXPECT_EQ(window.interior, (std::vector<int>{5, 6}));
    EXPECT_EQ(window.wanted, (std::vector<int>{1, 2, 2, 1, 2, 1, 2, 2, 1, 2}));
    EXPECT_EQ(window.wanted, window.inside);
    EXPECT_EQ(singularities(mesh, window), 0);
    EXPECT_NEAR(convexity(mesh, window), 1, 1e-12);
}

// The order and the repetition of the given faces do not matter.
TEST(Window, IgnoresOrder) {
    const mesh::QuadMesh mesh = grid(4, 4);
    const std::vector<int> faces = {10, 5, 9, 6, 5};
    EXPECT_EQ(defects(mesh, faces), 0);
    const Window window = make_window(mesh, faces);
    EXPECT_EQ(window.faces, (std::vector<int>{5, 6, 9, 10}));
    EXPECT_EQ(window.loop.front(), *std::min_element(window.loop.begin(), window.loop.end()));
}

TEST(Window, LShape) {
    const mesh::QuadMesh mesh = grid(4, 4);
    const Window window = make_window(mesh, {std::vector<int>{5, 6, 9}});
    const std::size_t notch =
        static_cast<std::size_t>(std::find(window.loop.begin(), window.loop.end(), 12) - window.loop.begin());
    ASSERT_LT(notch, window.loop.size());
    EXPECT_EQ(window.inside[notch], 3);
    EXPECT_EQ(window.wanted[notch], 3);
    EXPECT_NEAR(window.angles[notch], 270, 1e-9);
    EXPECT_NEAR(convexity(mesh, window), 3 / 3.5, 1e-12);
}

// A patch around one vertex of valence 5, seen from its loop, and its neighbours.
TEST(Window, SingularVertex) {
    const mesh::QuadMesh mesh = testing::star(5);
    std::vector<int> all(5);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(defects(mesh, all), 0);
    const Window window = make_window(mesh, all);
    EXPECT_EQ(window.interior, (std::vector<int>{0}));
    EXPECT_EQ(singularities(mesh, window), 1);

    const Window half = make_window(mesh, {std::vector<int>{0, 1}});
    EXPECT_EQ(half.loop.front(), 0);
    EXPECT_EQ(half.outside.front(), 3);
    EXPECT_EQ(half.wanted.front(), 1); // two faces are there, one makes the vertex regular
    EXPECT_EQ(singularities(mesh, half), 1);
}

// A tip or a dent of the mesh boundary, where two faces meet.
TEST(Window, WantedFollowsTheAngleOfTheMeshBoundary) {
    mesh::QuadMesh mesh = grid(2, 1);
    mesh.set_point(1, {1, -1.5, 0});
    const Window tip = make_window(mesh, {std::vector<int>{0, 1}});
    EXPECT_LT(tip.angles[1], 135);
    EXPECT_EQ(tip.inside[1], 2);
    EXPECT_EQ(tip.wanted[1], 1);

    mesh.set_point(1, {1, 0.9, 0});
    const Window dent = make_window(mesh, {std::vector<int>{0, 1}});
    EXPECT_GT(dent.angles[1], 225);
    EXPECT_EQ(dent.wanted[1], 3);
}

// A straight angle cannot be one corner, whatever the valence asks for.
TEST(Window, StraightAngleWantsTwoFaces) {
    mesh::QuadMesh mesh = testing::star(5);
    const Window before = make_window(mesh, {std::vector<int>{0, 1}});
    ASSERT_EQ(before.wanted[0], 1);
    // Widen both faces: the spokes at their ends become opposite.
    mesh.set_point(1, {1, 0, 0});
    mesh.set_point(2, {0, 1, 0});
    mesh.set_point(3, {-1, 0, 0});
    const Window after = make_window(mesh, {std::vector<int>{0, 1}});
    EXPECT_NEAR(after.angles[0], 180, 1e-9);
    EXPECT_EQ(after.wanted[0], 2);
}

TEST(Window, RefusesWhatIsNoDisk) {
    const mesh::QuadMesh mesh = grid(5, 5);
    EXPECT_THROW(make_window(mesh, {}), Failure);
    EXPECT_THROW(make_window(mesh, {std::vector<int>{0, 6}}), Failure);
    EXPECT_THROW(make_window(mesh, without(block(5, 1, 1, 4, 4), {12})), Failure);
}

// Random disks of a mesh with singularities: the words obey what the topology says.
TEST(Window, Identities) {
    std::mt19937 random(4);
    const mesh::QuadMesh mesh = testing::star(5, 8);
    int checked = 0;
    for (int n = 0; n < 300; ++n) {
        const std::vector<int> faces =
            testing::random_disk(mesh, 2 + static_cast<int>(random() % 60), random);
        ASSERT_EQ(defects(mesh, faces), 0);
        const Window w = make_window(mesh, faces);
        EXPECT_EQ(w.loop.size() % 2, 0U);
        int curvature = 0, corners = 0, turning = 0;
        for (const int v : w.interior) {
            curvature += 4 - mesh.valence(v);
            corners += mesh.valence(v);
        }
        for (std::size_t i = 0; i < w.loop.size(); ++i) {
            turning += 2 - w.inside[i];
            corners += w.inside[i];
            EXPECT_EQ(w.inside[i] + w.outside[i], static_cast<int>(mesh.faces_around(w.loop[i]).size()));
            EXPECT_GE(w.wanted[i], 1);
            EXPECT_GE(mesh.find_edge(w.loop[i], w.loop[(i + 1) % w.loop.size()]), 0);
        }
        EXPECT_EQ(curvature, 4 - turning);
        EXPECT_EQ(corners, 4 * static_cast<int>(w.faces.size()));
        // Counter-clockwise: the face on the left of every step is inside.
        for (std::size_t i = 0; i < w.loop.size(); ++i) {
            const int v = w.loop[i], u = w.loop[(i + 1) % w.loop.size()];
            const auto sides = mesh.edge_faces(mesh.find_edge(v, u));
            const int left = v < u ? sides[0] : sides[1], right = v < u ? sides[1] : sides[0];
            EXPECT_TRUE(std::binary_search(w.faces.begin(), w.faces.end(), left));
            EXPECT_FALSE(std::binary_search(w.faces.begin(), w.faces.end(), right));
        }
        const double cover = convexity(mesh, w);
        EXPECT_GT(cover, 0);
        EXPECT_LE(cover, 1);
        ++checked;
    }
    EXPECT_EQ(checked, 300);
}

} // namespace
} // namespace alphamst::patch
