#include "patch/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::covered;
using testing::cube;
using testing::expect_disks;
using testing::grid;
using testing::Groups;
using testing::islands;
using testing::mark;
using testing::none;
using testing::set_feature;

bool in_some(const mesh::QuadMesh &mesh, const Groups &patches, int vertex) {
    const std::vector<int> faces = mesh.faces_around(vertex);
    return std::any_of(patches.begin(), patches.end(), [&](const auto &patch) {
        return std::any_of(faces.begin(), faces.end(),
                           [&](int face) { return std::binary_search(patch.begin(), patch.end(), face); });
    });
}

TEST(Singularity, EachIsInAPatch) {
    for (const mesh::QuadMesh &mesh :
         {islands(), testing::triangles(8, 1), testing::triangles(6, 3), testing::cube(12)}) {
        ASSERT_FALSE(mesh.singularities().empty());
        for (const double size : {4.0, 20.0, 100.0, 700.0}) {
            const Groups patches = singularity_clusters(mesh, size, 1, none);
            for (const int v : mesh.singularities())
                EXPECT_TRUE(in_some(mesh, patches, v)) << "vertex " << v << ", size " << size;
        }
    }
}

// Features that end inside cut clusters open; what falls off has singular vertices, too.
TEST(Singularity, EachIsInAPatchAmongFeatures) {
    for (const int percent : {4, 15})
        for (const double size : {40.0, 60.0, 200.0}) {
            mesh::QuadMesh mesh = testing::triangles(3, 3);
            std::mt19937 random(7);
            for (auto &flags : mesh.edge_flags)
                flags = static_cast<int>(random() % 100) < percent ? mesh::feature : 0;
            const Groups patches = singularity_clusters(mesh, size, 1, none);
            expect_disks(mesh, patches);
            for (const int v : mesh.singularities()) {
                const std::vector<int> around = mesh.vertices_around(v);
                const bool on_feature = std::any_of(around.begin(), around.end(), [&](int w) {
                    return mesh.edge_flags[at(mesh.find_edge(v, w))] != 0;
                });
                EXPECT_TRUE(on_feature || in_some(mesh, patches, v)) << "vertex " << v << ", size " << size;
            }
        }
}

TEST(Singularity, ARegularMeshHasNone) {
    EXPECT_TRUE(singularity_clusters(grid(20, 20), 50, 1, none).empty());
    EXPECT_TRUE(singularity_clusters(testing::star(4, 6), 50, 1, none).empty());
}

TEST(Singularity, TheFacesAroundOneInWholeLayers) {
    const mesh::QuadMesh mesh = testing::star(5, 8);
    for (const auto &[size, layers] : {std::pair(5.0, 1), {20.0, 2}, {50.0, 3}, {80.0, 4}})
        EXPECT_EQ(singularity_clusters(mesh, size, 1, none), Groups{rings(mesh, 0, layers, none)});
}

// The corners of a cube: alone, or with others if there is room.
TEST(Singularity, NearOnesShareAPatch) {
    const mesh::QuadMesh mesh = testing::cube(4);
    EXPECT_EQ(singularity_clusters(mesh, 12, 1, none).size(), 8U);
    const Groups shared = singularity_clusters(mesh, 24, 1, none);
    EXPECT_LE(shared.size(), 4U);
    EXPECT_EQ(singularity_clusters(testing::cube(12), 24, 1, none).size(), 8U);
}

TEST(Singularity, RoughlyTheSize) {
    const mesh::QuadMesh mesh = islands();
    for (const double size : {20.0, 60.0}) {
        const Groups patches = singularity_clusters(mesh, size, 1, none);
        for (const auto &patch : patches)
            EXPECT_LE(static_cast<double>(patch.size()), 2 * size);
        EXPECT_GE(static_cast<double>(covered(patches)) / static_cast<double>(patches.size()), size / 2);
    }
}

TEST(Singularity, NoFreeFaceHasTwoSidesOnAPatch) {
    const mesh::QuadMesh mesh = testing::triangles(4, 3);
    const Groups patches = singularity_clusters(mesh, 60, 1, none);
    std::vector<int> patch_of(at(mesh.n_faces()), -1);
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (const int face : patches[p])
            patch_of[at(face)] = static_cast<int>(p);
    ASSERT_LT(covered(patches), at(mesh.n_faces()));
    for (int face = 0; face < mesh.n_faces(); ++face) {
        std::multiset<int> across;
        for (const int next : mesh.neighbours(face))
            if (patch_of[at(face)] < 0 && next >= 0 && patch_of[at(next)] >= 0)
                across.insert(patch_of[at(next)]);
        for (const int patch : across)
            EXPECT_EQ(across.count(patch), 1U) << "face " << face;
    }
}

TEST(Singularity, NoPatchForOneThatCannotBeInside) {
    mesh::QuadMesh mesh = testing::star(5, 8);
    mesh.vertex_flags[0] = mesh::fixed;
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, none).empty());
    mesh.vertex_flags[0] = 0;
    EXPECT_FALSE(singularity_clusters(mesh, 50, 1, none).empty());
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, mark(mesh, {0})).empty());
    set_feature(mesh, 0, 1);
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, none).empty());
}

} // namespace
} // namespace alphamst::patch
