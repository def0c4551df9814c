#include "mesh/submesh.h"

#include <gtest/gtest.h>

#include "adapt/adapt.h"
#include "adapt/run.h"
#include "index.h"

namespace alphamst::mesh {
namespace {

using adapt::samples::block;
using adapt::samples::chance;
using adapt::samples::grid;
using adapt::samples::silent;

constexpr int n = 16;

QuadMesh disturbed(unsigned seed) {
    std::mt19937 random(seed);
    QuadMesh mesh = grid(n, n);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.on_boundary(v))
            mesh.set_point(v, mesh.point(v) + OpenMesh::Vec3d(0.4 * (chance(random) - 0.5),
                                                              0.4 * (chance(random) - 0.5), 0));
    mesh.reset_origins();
    return mesh;
}

TEST(Submesh, HasWhatTheWholeHas) {
    QuadMesh whole = disturbed(1);
    const std::vector<int> faces = block(n, 3, 3, 8, 9);
    whole.vertex_flags[at(4 * (n + 1) + 4)] = corner;
    whole.edge_flags[at(whole.find_edge(4 * (n + 1) + 5, 4 * (n + 1) + 6))] = feature;
    whole.face_marker.assign(at(whole.n_faces()), 7);
    const Submesh part = submesh_of(whole, faces);
    ASSERT_EQ(part.faces, faces);
    ASSERT_EQ(part.mesh.n_faces(), 30);
    ASSERT_EQ(part.mesh.n_vertices(), 42);
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 4; ++k) {
            const int v = part.mesh.corners(static_cast<int>(f))[k];
            EXPECT_EQ(part.vertices[at(v)], whole.corners(faces[f])[k]);
            EXPECT_EQ(part.mesh.point(v), whole.point(part.vertices[at(v)]));
        }
    EXPECT_EQ(std::ranges::count(part.mesh.vertex_flags, corner), 1);
    EXPECT_EQ(std::ranges::count(part.mesh.edge_flags, feature), 1);
    EXPECT_EQ(part.mesh.face_marker, std::vector<std::int32_t>(30, 7));
    part.mesh.check();
}

// What a search did to the part is in the whole, and nothing else has changed there: neither when faces come
// nor when they go and others move into the gaps.
TEST(Submesh, IsPutBack) {
    for (const double alpha : {0.4, 0.7, 1.0, 1.6, 3.0})
        for (const unsigned seed : {alpha < 1 ? 1u : 2u}) {
            QuadMesh whole = disturbed(seed);
            const QuadMesh before = whole;
            std::vector<int> faces = block(n, 2, 3, 12, 13);
            std::erase_if(faces, [](int f) { return f == 6 * n + 6 || f == 6 * n + 7; }); // with a hole
            Submesh part = submesh_of(whole, faces);
            const QuadMesh at_first = part.mesh;
            QuadMesh &changed = part.mesh;
            Settings settings;
            settings.seed = seed;
            adapt::adapt_whole(changed, alpha, settings, silent);
            ASSERT_TRUE(alpha == 1 || !changed.journal->empty());
            put_back(whole, part);
            whole.check();
            EXPECT_EQ(whole.n_faces() - before.n_faces(), changed.n_faces() - at_first.n_faces());
            EXPECT_EQ(whole.n_vertices() - before.n_vertices(), changed.n_vertices() - at_first.n_vertices());
            for (int f = 0; f < whole.n_faces(); ++f)
                if (const int old = whole.face_origin[at(f)]; old >= 0)
                    for (std::size_t k = 0; k < 4; ++k) {
                        const int v = whole.corners(f)[k], was = before.corners(old)[k];
                        EXPECT_EQ(whole.vertex_origin[at(v)], was);
                        if (!std::ranges::binary_search(part.vertices, was)) {
                            EXPECT_EQ(whole.point(v), before.point(was));
                        }
                    }
            std::multiset<std::array<double, 3>> there, here;
            for (int v = 0; v < whole.n_vertices(); ++v)
                there.insert({whole.point(v)[0], whole.point(v)[1], double(whole.valence(v))});
            for (int v = 0; v < changed.n_vertices(); ++v)
                if (!changed.on_boundary(v))
                    here.insert({changed.point(v)[0], changed.point(v)[1], double(changed.valence(v))});
            EXPECT_TRUE(std::ranges::includes(there, here));
        }
}

TEST(Submesh, KeepsItsChords) {
    const QuadMesh whole = disturbed(1);
    Submesh part = submesh_of(whole, block(n, 3, 3, 8, 9));
    const std::vector<int> sides{0};
    EXPECT_THROW(part.mesh.split_chord(sides, 1), Failure);
}

} // namespace
} // namespace alphamst::mesh
