#include "adapt/pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/curved.h"
#include "reference/statistics.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

using samples::silent;

// A square of regular faces, whose border stays: few singular vertices give it other sizes inside.
TEST(Pieces, GiveARegularSquareOtherSizes) {
    for (const std::int64_t wanted : {50, 150, 200, 400}) {
        mesh::QuadMesh mesh = samples::grid(10, 10);
        const double before = reference::time_step(mesh);
        EXPECT_EQ(refill_pieces(mesh, wanted, {}, silent), 1u);
        ASSERT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.n_faces(), wanted);
        EXPECT_LE(mesh.singularities().size(), 6u) << wanted;
        EXPECT_GE(reference::least_quality(mesh), 0.5) << wanted;
        const double ideal = std::min(1.0, std::sqrt(100.0 / static_cast<double>(wanted)));
        EXPECT_GE(reference::time_step_ratio(before, reference::time_step(mesh)), ideal / 2) << wanted;
    }
}

// A sheet folded along its middle is one piece, or two where that is a feature.
TEST(Pieces, EndAtFeatures) {
    for (const bool feature : {false, true}) {
        mesh::QuadMesh mesh = mesh::grid(10, 20, [](double s, double t) {
            return t < 0.5 ? Eigen::Vector3d(s, 1 - 2 * t, 0) : Eigen::Vector3d(s, 0, 2 * t - 1);
        });
        for (int e = 0; feature && e < mesh.n_edges(); ++e) {
            const auto [v, w] = mesh.edge_vertices(e);
            const auto &p = mesh.point(v), &q = mesh.point(w);
            if (p[1] == 0 && p[2] == 0 && q[1] == 0 && q[2] == 0)
                mesh.edge_flags[static_cast<std::size_t>(e)] |= mesh::feature;
        }
        EXPECT_EQ(refill_pieces(mesh, 400, {}, silent), feature ? 2u : 1u);
        EXPECT_EQ(mesh.n_faces(), 400);
        EXPECT_LE(mesh.singularities().size(), feature ? 8u : 4u);
    }
}

// What is closed or large is left to windows.
TEST(Pieces, AreNotMadeOfClosedOrLargeMeshes) {
    for (mesh::QuadMesh mesh : {mesh::sphere(6), samples::grid(32, 32)}) {
        const std::uint64_t before = mesh.checksum();
        EXPECT_FALSE(refill_pieces(mesh, 2 * mesh.n_faces(), {}, silent));
        EXPECT_EQ(mesh.checksum(), before);
    }
}

// Held or fixed faces are none of a piece, and count.
TEST(Pieces, LeaveFixedFaces) {
    mesh::QuadMesh mesh = samples::grid(10, 10);
    for (int f = 0; f < 20; ++f)
        mesh.face_flags[static_cast<std::size_t>(f)] |= mesh::fixed;
    EXPECT_EQ(refill_pieces(mesh, 180, {}, silent), 1u);
    EXPECT_EQ(mesh.n_faces(), 180);
    int fixed = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (mesh.face_flags[static_cast<std::size_t>(f)] & mesh::fixed) {
            ++fixed;
            EXPECT_GE(mesh.face_origin[static_cast<std::size_t>(f)], 0);
        }
    EXPECT_EQ(fixed, 20);
}

} // namespace
} // namespace alphamst::adapt
