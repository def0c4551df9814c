#include "chords/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "adapt/meshes.h"
#include "chord/trace.h"
#include "mesh/curved.h"

namespace alphamst::chords {
namespace {

using adapt::samples::all_faces;
using adapt::samples::block;
using adapt::samples::grid;

TEST(ChordFaces, AroundVerticesComeInLayers) {
    const mesh::QuadMesh mesh = grid(7, 7);
    const int middle = 3 * 8 + 3; // between the faces of columns and rows 2 and 3
    EXPECT_EQ(faces_around(mesh, {middle}, 0), block(7, 2, 2, 4, 4));
    EXPECT_EQ(faces_around(mesh, {middle}, 1), block(7, 1, 1, 5, 5));
    EXPECT_EQ(faces_around(mesh, {0, 1}, 0), (std::vector{0, 1}));
}

TEST(ChordFaces, UprightGoesByThePlaneIfThereIsOne) {
    const geometry::Quad square{Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const geometry::Quad below{square[3], square[2], square[1], square[0]};
    geometry::Quad dart = square;
    dart[2] = {0.4, 0.4, 0}; // a concave corner
    const auto plane = geometry::Plane::of_coordinates(false),
               from_below = geometry::Plane::of_coordinates(true);
    EXPECT_TRUE(upright(square, plane));
    EXPECT_FALSE(upright(below, plane));
    EXPECT_FALSE(upright(square, from_below));
    EXPECT_TRUE(upright(below, std::nullopt)); // against its own normal
    EXPECT_FALSE(upright(dart, plane));
    EXPECT_FALSE(upright(dart, std::nullopt));
}

TEST(ChordFaces, InvertedOnesAreCounted) {
    mesh::QuadMesh mesh = grid(4, 4);
    EXPECT_EQ(inverted(mesh, all_faces(mesh)), 0);
    mesh.set_point(12, {2.4, 2.4, 0}); // up to the diagonal of the face on the upper right
    EXPECT_EQ(inverted(mesh, all_faces(mesh)), 0);
    mesh.set_point(12, {2.6, 2.6, 0}); // and across it
    EXPECT_EQ(inverted(mesh, all_faces(mesh)), 1);
    EXPECT_EQ(inverted(mesh, {0, 1, 2, 3}), 0);
}

TEST(ChordFaces, AGroupMeetsAtItsMeanOrWhereItIsHeld) {
    const mesh::QuadMesh mesh = grid(3, 3);
    EXPECT_EQ(place_of(mesh, {5, false, {6, 9}}), OpenMesh::Vec3d(4.0 / 3, 4.0 / 3, 0));
    EXPECT_EQ(place_of(mesh, {5, true, {6, 9}}), mesh.point(5));
}

// The middle column of five: its faces go, its two sides meet halfway, and on the boundary at one of them.
TEST(ChordFaces, RemovingAChordNamesTheVerticesThatItLeaves) {
    mesh::QuadMesh mesh = grid(5, 3);
    const chord::Chord chord = chord::trace(mesh, mesh.find_edge(2, 3));
    chord::Judge judge(mesh, {true});
    const chord::Collapse verdict = judge(chord);
    ASSERT_EQ(verdict.reasons, 0);
    std::vector<int> survivors;
    remove(mesh, chord, verdict, survivors);
    mesh.check();
    EXPECT_EQ(mesh.n_faces(), 12);
    ASSERT_EQ(survivors.size(), 4u);
    std::vector<double> rows;
    for (const int v : survivors) {
        EXPECT_EQ(mesh.point(v)[0], mesh.on_boundary(v) ? 2 : 2.5);
        rows.push_back(mesh.point(v)[1]);
    }
    std::sort(rows.begin(), rows.end());
    EXPECT_EQ(rows, (std::vector<double>{0, 1, 2, 3}));
}

TEST(ChordFaces, ACurvedMeshKeepsItsSurface) {
    mesh::QuadMesh flat = grid(3, 3), ball = mesh::sphere(4);
    keep_surface(flat);
    EXPECT_EQ(flat.surface, nullptr);
    keep_surface(ball);
    ASSERT_NE(ball.surface, nullptr);
    const auto surface = ball.surface;
    ball.set_point(0, 2 * ball.point(0));
    keep_surface(ball); // the one it has
    EXPECT_EQ(ball.surface, surface);
}

TEST(ChordFaces, TheAccountTellsBeforeAndAfter) {
    mesh::QuadMesh mesh = grid(4, 4);
    Account account(mesh);
    mesh.set_point(12, {2.5, 2, 0});
    const Outcome outcome = account.close(mesh, 20);
    EXPECT_FALSE(outcome.fault);
    EXPECT_EQ(outcome.faces_before, 16);
    EXPECT_EQ(outcome.faces_after, 16);
    EXPECT_EQ(outcome.faces_wanted, 20);
    EXPECT_EQ(outcome.quality_before, 1);
    EXPECT_NEAR(outcome.quality_after, 2 / std::sqrt(5.0), 1e-12); // an edge goes half a step aside
    EXPECT_EQ(outcome.valences_before, (std::map<int, std::int64_t>{{4, 9}}));
    EXPECT_EQ(outcome.valences_after, outcome.valences_before);
}

} // namespace
} // namespace alphamst::chords
