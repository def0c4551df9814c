#include "adapt/layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "index.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

// Twenty columns; rows of heights that grow by 1.6 from the wall at y = 0, the first one a thousandth.
mesh::QuadMesh wall() {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    constexpr int columns = 20, rows = 18;
    double y = 0, height = 1e-3;
    for (int j = 0; j <= rows; ++j, y += height, height *= 1.6)
        for (int i = 0; i <= columns; ++i)
            points.insert(points.end(), {double(i), y, 0});
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int v = j * (columns + 1) + i;
            faces.insert(faces.end(), {v, v + 1, v + columns + 2, v + columns + 1});
        }
    return mesh::QuadMesh::build(2, points, faces);
}

std::int64_t fixed_in(const mesh::QuadMesh &mesh) {
    return std::ranges::count_if(mesh.face_flags, [](auto flags) { return (flags & mesh::fixed) != 0; });
}

TEST(Layers, AreHeldAndReleased) {
    mesh::QuadMesh mesh = wall();
    mesh.face_flags[3] = mesh::fixed; // by the caller
    const std::uint64_t before = mesh.checksum();
    const std::int64_t held = hold_layers(mesh, 720);
    EXPECT_GT(held, 100);
    EXPECT_LE(held, mesh.n_faces() / 2);
    EXPECT_EQ(fixed_in(mesh), held + 1);
    EXPECT_NE(mesh.face_flags[0] & mesh::fixed, 0);
    EXPECT_EQ(mesh.face_flags[at(mesh.n_faces() - 1)], 0);
    release_layers(mesh);
    EXPECT_EQ(mesh.checksum(), before);
}

TEST(Layers, AreNeitherSquaresNorLonelySliversNorHeldWhereTheMeshBecomesCoarse) {
    mesh::QuadMesh squares = samples::grid(10, 10);
    EXPECT_EQ(hold_layers(squares, 200), 0);
    mesh::QuadMesh mesh = samples::grid(3, 1);
    for (const int v : {1, 5}) // the first face becomes a tenth as wide
        mesh.set_point(v, mesh.point(v) - OpenMesh::Vec3d(0.9, 0, 0));
    EXPECT_EQ(hold_layers(mesh, 6), 0);
    mesh = wall();
    EXPECT_EQ(hold_layers(mesh, 180), 0);
}

TEST(Layers, StayWhereAWholeMeshIsRefined) {
    mesh::QuadMesh mesh = wall();
    const Outcome outcome = adapt_whole(mesh, 2, {}, samples::silent);
    EXPECT_EQ(outcome.faces_after, 720);
    EXPECT_EQ(fixed_in(mesh), 0);
    double lowest = 1;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && mesh.point(v)[1] > 0)
            lowest = std::min(lowest, mesh.point(v)[1]);
    EXPECT_EQ(lowest, 1e-3);
    std::int64_t first_row = 0;
    for (int f = 0; f < mesh.n_faces(); ++f)
        first_row += samples::centre(mesh, f)[1] < 1e-3;
    EXPECT_EQ(first_row, 20);
}

} // namespace
} // namespace alphamst::adapt
