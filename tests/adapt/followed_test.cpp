#include "adapt/followed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "meshes.h"
#include "refill/patch.h"

namespace alphamst::adapt {
namespace {

using samples::block;

Patch patch_of(std::vector<int> faces, std::vector<int> corners = {}) {
    Patch patch;
    patch.faces = std::move(faces);
    patch.corners = std::move(corners);
    return patch;
}

// A block of 2 by 2 faces becomes one of 12: a ring around the same in small.
refill::Replacement ring_in(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    refill::Replacement replacement;
    replacement.window = patch::make_window(mesh, faces);
    const auto &loop = replacement.window.loop;
    const OpenMesh::Vec3d middle = mesh.point(replacement.window.interior.at(0));
    replacement.filling = {8, 17, {}};
    for (int i = 0; i < 8; ++i)
        replacement.filling.quads.push_back({i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i});
    for (int i = 0; i < 8; ++i)
        replacement.points.push_back((mesh.point(loop[static_cast<std::size_t>(i)]) + middle) / 2.0);
    replacement.points.push_back(middle);
    const int first = replacement.window.wanted[0] == 1 ? 0 : 1; // a corner
    for (int k = 0; k < 4; ++k) {
        const int corner = (first + 2 * k) % 8;
        replacement.filling.quads.push_back({8 + (corner + 7) % 8, 8 + corner, 8 + (corner + 1) % 8, 16});
    }
    return replacement;
}

TEST(Followed, PatchesHaveTheirNewFacesAndOthersKeepTheirs) {
    mesh::QuadMesh mesh = samples::grid(6, 6);
    const std::vector<Patch> patches{patch_of(block(6, 0, 0, 2, 2)),
                                     patch_of(block(6, 4, 4, 6, 6), {48, 46})};
    const OpenMesh::Vec3d centre = samples::centre(mesh, patches[1].faces[0]), corner = mesh.point(48);
    Followed followed(mesh, patches, {});
    const refill::Replacement ring = ring_in(mesh, followed.now(0).faces);
    followed.follow(0, ring, refill::commit(mesh, ring));
    ASSERT_NO_THROW(mesh.check());
    ASSERT_EQ(followed.now(0).faces.size(), 12u);
    for (const int f : followed.now(0).faces) {
        EXPECT_LT(samples::centre(mesh, f)[0], 2);
        EXPECT_LT(samples::centre(mesh, f)[1], 2);
    }
    EXPECT_EQ(samples::centre(mesh, followed.now(1).faces[0]), centre);
    EXPECT_EQ(mesh.point(followed.now(1).corners[0]), corner);
    EXPECT_TRUE(followed.around().empty());
}

TEST(Followed, WhatAPatchLiesInGetsItsNewFaces) {
    mesh::QuadMesh mesh = samples::grid(6, 6);
    const std::vector<Patch> parts{patch_of(block(6, 0, 0, 2, 2)), patch_of(block(6, 4, 4, 6, 6))};
    const std::vector<Patch> around{patch_of(block(6, 0, 0, 3, 3)), patch_of(block(6, 3, 3, 5, 4))};
    Followed followed(mesh, parts, around);
    for (std::size_t p : {0u, 1u}) { // the second lies in none of them
        const refill::Replacement ring = ring_in(mesh, followed.now(p).faces);
        followed.follow(p, ring, refill::commit(mesh, ring));
    }
    ASSERT_NO_THROW(mesh.check());
    const std::vector<Patch> now = followed.around();
    ASSERT_EQ(now.size(), 2u);
    EXPECT_EQ(now[0].faces.size(), 9u - 4 + 12);
    EXPECT_EQ(now[1].faces.size(), 2u);
    for (const int f : now[0].faces) {
        EXPECT_LT(samples::centre(mesh, f)[0], 3);
        EXPECT_LT(samples::centre(mesh, f)[1], 3);
    }
    for (const int f : now[1].faces)
        EXPECT_NEAR(samples::centre(mesh, f)[1], 3.5, 1e-12);
}

} // namespace
} // namespace alphamst::adapt
