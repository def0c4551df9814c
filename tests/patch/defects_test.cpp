#include "patch/window.h"

#include <gtest/gtest.h>

#include "grid.h"

namespace alphamst::patch {
namespace {

using testing::block;
using testing::cube;
using testing::grid;
using testing::without;

std::int32_t defects_of(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    return defects(mesh, faces);
}

TEST(Defects, OfEachKind) {
    const mesh::QuadMesh mesh = grid(5, 5);
    EXPECT_EQ(defects_of(mesh, {}), empty);
    EXPECT_EQ(defects_of(mesh, {0, 24}), not_connected);
    EXPECT_EQ(defects_of(mesh, {0, 6}), not_connected | pinched);
    EXPECT_EQ(defects_of(mesh, without(block(5, 1, 1, 4, 4), {12})), not_disk);
    // Around a hole, closed by a corner only: a disk that meets itself.
    EXPECT_EQ(defects_of(mesh, without(block(5, 1, 1, 4, 4), {12, 18})), pinched);
    EXPECT_EQ(defects_of(mesh, without(block(5, 1, 1, 4, 4), {12, 13, 17, 18})), 0);
    EXPECT_EQ(defects_of(mesh, {0, 1, 5, 6, 23}), not_connected);
}

TEST(Defects, Features) {
    const std::vector<int> faces = block(4, 1, 1, 3, 3);
    mesh::QuadMesh mesh = grid(4, 4);
    const int inside = mesh.find_edge(12, 13), rim = mesh.find_edge(6, 7);
    for (const std::uint8_t flag : {mesh::fixed, mesh::feature, mesh::corner}) {
        mesh.edge_flags[static_cast<std::size_t>(rim)] = flag;
        mesh.vertex_flags[7] = flag;
        EXPECT_EQ(defects(mesh, faces), 0);
        mesh.edge_flags[static_cast<std::size_t>(inside)] = flag;
        EXPECT_EQ(defects(mesh, faces), crosses_feature);
        mesh.edge_flags[static_cast<std::size_t>(inside)] = 0;
        mesh.vertex_flags[12] = flag;
        EXPECT_EQ(defects(mesh, faces), crosses_feature);
        mesh.vertex_flags[12] = 0;
    }
    mesh.edge_marker.assign(static_cast<std::size_t>(mesh.n_edges()), 0);
    mesh.edge_marker[static_cast<std::size_t>(inside)] = 7;
    EXPECT_EQ(defects(mesh, faces), crosses_feature);
    mesh.edge_marker.clear();
    mesh.face_marker.assign(16, 1);
    EXPECT_EQ(defects(mesh, faces), 0);
    mesh.face_marker[5] = 2;
    EXPECT_EQ(defects(mesh, faces), crosses_feature);
}

TEST(Defects, ClosedSurface) {
    const mesh::QuadMesh cube = testing::cube();
    EXPECT_EQ(defects_of(cube, {0, 1, 2, 3, 4, 5}), not_disk);
    EXPECT_EQ(defects_of(cube, {0, 1, 2, 3, 4}), 0);
    EXPECT_THROW(make_window(cube, {std::vector<int>{0, 1, 2, 3, 4, 5}}), Failure);
}

} // namespace
} // namespace alphamst::patch
