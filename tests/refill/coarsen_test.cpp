#include "refill/coarsen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "adapt/meshes.h"
#include "index.h"

namespace alphamst::refill {
namespace {

// A mesh in the plane as a filling of its boundary, and what is wanted there.
struct Start {
    PlacedFilling old;
    fill::Request request;

    explicit Start(const mesh::QuadMesh &mesh) {
        const patch::Window window = patch::make_window(mesh, adapt::samples::all_faces(mesh));
        std::map<int, int> local;
        for (const auto *list : {&window.loop, &window.interior})
            for (const int v : *list) {
                local.emplace(v, static_cast<int>(local.size()));
                old.positions.emplace_back(mesh.point(v)[0], mesh.point(v)[1]);
            }
        old.filling = {static_cast<int>(window.loop.size()), static_cast<int>(local.size()), {}};
        for (std::array<int, 4> quad : mesh.faces()) {
            for (int &v : quad)
                v = local.at(v);
            old.filling.quads.push_back(quad);
        }
        request.word = request.regular = window.wanted;
        request.angles = window.angles;
    }
    std::optional<Coarse> to(std::int64_t faces, std::uint64_t seed = 0) {
        request.faces = faces;
        return coarsen(request, old, seed);
    }
};

int irregular(const fill::Filling &filling, const fill::Word &regular) {
    std::vector<int> faces(at(filling.vertices), 0);
    for (const auto &quad : filling.quads)
        for (const int v : quad)
            ++faces[at(v)];
    int sum = 0;
    for (std::size_t v = 0; v < faces.size(); ++v)
        sum += faces[v] != (v < regular.size() ? regular[v] : 4);
    return sum;
}

void expect_disk_of(const Coarse &coarse, const Start &start) {
    const fill::Filling &filling = coarse.shape.filling;
    EXPECT_EQ(std::ssize(filling.quads), start.request.faces);
    EXPECT_EQ(filling.boundary, start.old.filling.boundary);
    EXPECT_EQ(filling.vertices, std::ssize(filling.quads) + filling.boundary / 2 + 1); // Euler
    ASSERT_EQ(coarse.shape.positions.size(), at(filling.vertices));
    for (std::size_t v = 0; v < at(filling.boundary); ++v)
        EXPECT_EQ(coarse.shape.positions[v], start.old.positions[v]);
    EXPECT_GT(geometry::shapes_of(filling.quads, coarse.shape.positions).min_scaled_jacobian, 0.01);
    EXPECT_EQ(coarse.singularities, irregular(filling, start.request.regular));
}

TEST(Coarsen, GivesTheWantedFacesAndNoInvertedCorner) {
    Start start(adapt::samples::grid(8, 8));
    for (const std::int64_t faces : {63, 60, 55, 50}) {
        const auto coarse = start.to(faces);
        ASSERT_TRUE(coarse) << faces;
        expect_disk_of(*coarse, start);
    }
}

TEST(Coarsen, DoesSoWhereTheMeshIsIrregular) {
    Start start(adapt::samples::unstructured(12, 5));
    for (const std::int64_t faces : {140, 120, 100}) {
        const auto coarse = start.to(faces);
        ASSERT_TRUE(coarse) << faces;
        expect_disk_of(*coarse, start);
    }
}

// The two that one collapse makes regular are the first to go.
TEST(Coarsen, TakesWhatIsBestForTheValencesFirst) {
    const mesh::QuadMesh regular = adapt::samples::grid(6, 6);
    mesh::QuadMesh mesh = regular;
    const patch::Window window = patch::make_window(mesh, std::vector{14, 15});
    ASSERT_EQ(window.loop.size(), 6u);
    // The vertex in the middle of one side of the two faces becomes two, with a face between them.
    const int v = 2 * 7 + 3; // of face 14, 15 and the two below
    const patch::Window around = patch::make_window(mesh, mesh.faces_around(v));
    ASSERT_EQ(around.loop.size(), 8u);
    const std::size_t k = static_cast<std::size_t>(
        std::find(around.loop.begin(), around.loop.end(), 1 * 7 + 2) - around.loop.begin());
    const auto name = [&](std::size_t i) { return static_cast<int>((k + i) % 8); };
    // From the lower left corner: 0 to 7 around, 8 to the left and 9 to the right of where v was.
    mesh.replace_disk(around.faces, around.loop,
                      std::vector<std::array<int, 4>>{{name(0), name(1), 8, name(7)},
                                                      {name(1), name(2), name(3), 9},
                                                      {9, name(3), name(4), name(5)},
                                                      {8, name(5), name(6), name(7)},
                                                      {name(1), 9, name(5), 8}},
                      std::vector{OpenMesh::Vec3d(2.8, 2, 0), OpenMesh::Vec3d(3.2, 2, 0)});
    Start start(mesh);
    ASSERT_EQ(irregular(start.old.filling, start.request.regular), 4);
    for (const std::uint64_t seed : {0, 1, 2}) {
        const auto coarse = start.to(36, seed);
        ASSERT_TRUE(coarse);
        EXPECT_EQ(coarse->singularities, 0);
        expect_disk_of(*coarse, start);
    }
}

TEST(Coarsen, ComesAsNearAsTheBoundaryAllows) {
    Start start(adapt::samples::grid(6, 6));
    start.request.faces = 1; // 24 edges around need 11 faces at least
    const std::optional<Coarse> nearest = coarsen_towards(start.request, start.old, 0);
    ASSERT_TRUE(nearest);
    const auto faces = std::ssize(nearest->shape.filling.quads);
    EXPECT_GE(faces, 11);
    EXPECT_LT(faces, 30);
    EXPECT_FALSE(start.to(1));
    EXPECT_TRUE(start.to(faces));
    start.request.faces = 36;
    EXPECT_FALSE(coarsen_towards(start.request, start.old, 0));
}

TEST(Coarsen, GivesNothingThatCannotBe) {
    Start start(adapt::samples::grid(6, 6));
    EXPECT_FALSE(start.to(36)); // no fewer
    EXPECT_FALSE(start.to(40));
    EXPECT_FALSE(start.to(11)); // no more than a boundary of 24 edges without a vertex inside
    EXPECT_FALSE(start.to(0));
}

TEST(Coarsen, DependsOnTheSeedAlone) {
    Start start(adapt::samples::grid(8, 8));
    const auto quads = [&](std::uint64_t seed) { return start.to(55, seed).value().shape.filling.quads; };
    EXPECT_EQ(quads(1), quads(1));
    EXPECT_FALSE(quads(1) == quads(2) && quads(2) == quads(3));
}

} // namespace
} // namespace alphamst::refill
