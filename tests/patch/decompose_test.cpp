#include "patch/patches.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::covered;
using testing::ell;
using testing::expect_disks;
using testing::graded;
using testing::grid;
using testing::Groups;
using testing::islands;
using testing::mark;
using testing::none;
using testing::set_feature;

using Decompose = Groups (*)(const mesh::QuadMesh &, double, std::uint64_t, Taken, const Pace &);
struct Method {
    std::string name;
    Decompose decompose;
};
const Method methods[] = {{"clusters", &clusters},
                          {"partition", &partition},
                          {"voronoi", &voronoi_cells},
                          {"medial", &medial_discs},
                          {"singularities", &singularity_clusters}};
std::string name_of(const ::testing::TestParamInfo<Method> &info) { return info.param.name; }

class Decomposition : public ::testing::TestWithParam<Method> {
protected:
    Groups run(const mesh::QuadMesh &mesh, double size, std::uint64_t seed = 1, Taken taken = none) const {
        return GetParam().decompose(mesh, size, seed, taken, {});
    }
};
class Cover : public Decomposition {};

TEST_P(Decomposition, DisjointDisksOnEveryMesh) {
    for (const mesh::QuadMesh &mesh : {grid(30, 30), ell(), islands(), graded(), testing::cube(12)})
        for (const double size : {1.0, 7.0, 60.0, 5000.0}) {
            const Groups patches = run(mesh, size);
            expect_disks(mesh, patches);
            EXPECT_EQ(patches, run(mesh, size));
        }
}

TEST_P(Decomposition, RespectsTakenAndFeatures) {
    mesh::QuadMesh mesh = testing::triangles(4, 5);
    // The middle line x = 2, but for the last edges: the feature ends inside.
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const int w : mesh.vertices_around(v))
            if (std::abs(mesh.point(v)[0] - 2) < 1e-9 && std::abs(mesh.point(w)[0] - 2) < 1e-9 &&
                mesh.point(v)[1] < mesh.point(w)[1] && mesh.point(w)[1] < 3.7)
                set_feature(mesh, v, w);
    mesh.face_marker.assign(at(mesh.n_faces()), 1);
    for (int face = 0; face < 300; ++face)
        mesh.face_marker[at(face)] = 2;
    std::vector<int> corner(150);
    std::iota(corner.begin(), corner.end(), 900);
    const std::vector<char> taken = mark(mesh, corner);
    for (const double size : {1.0, 2.5, 12.0, 50.0, 1000.0}) {
        const Groups patches = run(mesh, size, 1, taken);
        EXPECT_FALSE(patches.empty());
        expect_disks(mesh, patches);
        for (const auto &patch : patches)
            for (const int face : patch)
                EXPECT_FALSE(taken[at(face)]);
    }
}

TEST_P(Decomposition, SilentOnSmallParts) {
    ::testing::internal::CaptureStdout();
    const mesh::QuadMesh mesh = testing::triangles(3, 4);
    for (const double size : {0.0, 1.0, 3.0, 8.0, 9.0})
        EXPECT_FALSE(run(mesh, size).empty());
    EXPECT_TRUE(run(mesh, 10, 1, std::vector<char>(at(mesh.n_faces()), 1)).empty());
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST_P(Cover, DisksOfAboutTheSize) {
    const mesh::QuadMesh mesh = grid(40, 40);
    const Groups patches = run(mesh, 64, 3);
    EXPECT_GE(patches.size(), 20U);
    EXPECT_LE(patches.size(), 30U);
    for (const auto &patch : patches) {
        EXPECT_GE(patch.size(), 16U);
        EXPECT_LE(patch.size(), 192U);
        EXPECT_GT(convexity(mesh, make_window(mesh, patch)), 0.6);
    }
    EXPECT_GE(covered(patches), 1500U);
}

TEST_P(Cover, LeavesLittle) {
    for (const mesh::QuadMesh &mesh : {ell(), islands(), graded(), testing::cube(12)})
        EXPECT_GE(covered(run(mesh, 60)), at(mesh.n_faces() * 97 / 100));
}

INSTANTIATE_TEST_SUITE_P(All, Decomposition, ::testing::ValuesIn(methods), name_of);
INSTANTIATE_TEST_SUITE_P(All, Cover, ::testing::ValuesIn(methods, methods + 3), name_of);

} // namespace
} // namespace alphamst::patch
