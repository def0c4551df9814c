#include <cmath>

#include "eared.h"
#include "mesh/grids.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"
#include "reference/surface_of.h"
#include "run.h"

namespace alphamst::adapt::samples {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Farthest that a vertex of one is from the other.
double distance(const mesh::QuadMesh &of, const mesh::QuadMesh &to) {
    const auto surface = reference::surface_of(to);
    double most = 0;
    for (int v = 0; v < of.n_vertices(); ++v)
        most = std::max(most, surface->nearest(reference::point_of(of, v)).distance);
    return most;
}

double worst_corner(mesh::QuadMesh mesh) {
    const std::vector<double> each = reference::reference_of(mesh).scaled_jacobians(mesh);
    return *std::min_element(each.begin(), each.end());
}

TEST(Surface, WholeMeshesGetTheirFacesAndFewSingularities) {
    const mesh::QuadMesh before = eared(3);
    const auto singular = before.singularities().size();
    for (const double alpha : {0.5, 1.0, 2.0}) {
        mesh::QuadMesh mesh = before;
        const Outcome outcome = adapt_whole(mesh, alpha, {}, silent);
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.n_faces(), std::llround(alpha * before.n_faces())) << outcome.text;
        EXPECT_EQ(mesh.n_vertices() - mesh.n_faces(), 2); // still a sphere
        EXPECT_LT(2 * mesh.singularities().size(), singular) << alpha;
        EXPECT_GT(worst_corner(mesh), 0.1) << alpha;
        EXPECT_EQ(outcome.quality_after, reference::least_quality(mesh));
    }
}

TEST(Surface, VerticesKeepToItAndItStaysCovered) {
    const mesh::QuadMesh before = eared(3);
    mesh::QuadMesh mesh = before;
    adapt_whole(mesh, 0.5, {}, silent);
    EXPECT_LT(distance(mesh, before), 1e-12);
    const double edge = std::sqrt(reference::surface_of(before)->area() / mesh.n_faces());
    EXPECT_LT(distance(before, mesh), 0.75 * edge); // the ears are twice as long as an edge
    // Again and again, and it is still the surface of the beginning.
    adapt_whole(mesh, 1.5, {}, silent);
    reduce_whole(mesh, {}, silent);
    EXPECT_LT(distance(mesh, before), 1e-12);
}

TEST(Surface, ProgressNeverFalls) {
    mesh::QuadMesh mesh = eared(3);
    double told = 0;
    adapt_whole(mesh, 0.6, {}, [&](double fraction, const char *stage) {
        EXPECT_GE(fraction, told) << stage;
        EXPECT_LE(fraction, 1);
        told = fraction;
    });
    EXPECT_EQ(told, 1);
}

TEST(Surface, SameResultForAnyNumberOfThreads) {
    std::vector<std::uint64_t> digests;
    for (const int threads : {1, 2, 8}) {
        mesh::QuadMesh mesh = eared(3);
        Settings settings;
        settings.threads = threads;
        adapt_whole(mesh, 1.3, settings, silent);
        digests.push_back(mesh.checksum());
    }
    EXPECT_EQ(digests[0], digests[1]);
    EXPECT_EQ(digests[0], digests[2]);
}

TEST(Surface, PatchesKeepWhatIsOutside) {
    mesh::QuadMesh mesh = eared(3);
    const mesh::QuadMesh before = mesh;
    std::vector<char> taken(at(mesh.n_faces()), 0);
    std::vector<Patch> regions;
    for (std::vector<int> &faces : patch::clusters(mesh, 40, 1, taken)) {
        if (faces.size() < 20 || regions.size() == 4)
            continue;
        regions.emplace_back();
        regions.back().faces = std::move(faces);
    }
    const std::vector<Outcome> outcomes = adapt(mesh, regions, 2, {}, silent);
    std::int64_t faces = before.n_faces(), done = 0;
    for (const Outcome &outcome : outcomes) {
        faces += outcome.faces_after - outcome.faces_before;
        done += !outcome.fault;
        EXPECT_EQ(outcome.fault.value_or(Fault::geometry), Fault::geometry) << outcome.text;
        if (!outcome.fault) {
            EXPECT_EQ(outcome.faces_after, 2 * outcome.faces_before);
            EXPECT_GT(outcome.quality_after, 0);
        }
    }
    EXPECT_GE(done, 3);
    EXPECT_EQ(mesh.n_faces(), faces);
    EXPECT_NO_THROW(mesh.check());
    EXPECT_LT(distance(mesh, before), 1e-12);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (const int old = mesh.vertex_origin[at(v)]; old >= 0) {
            EXPECT_EQ(mesh.point(v), before.point(old));
        }
}

TEST(Surface, SmoothingSlidesAlongIt) {
    mesh::QuadMesh mesh = eared(3);
    const mesh::QuadMesh before = mesh;
    const Outcome outcome = smooth::smooth(mesh, nullptr, {}, silent).at(0);
    EXPECT_FALSE(outcome.fault);
    EXPECT_GE(outcome.quality_after, outcome.quality_before);
    EXPECT_NE(mesh.checksum(), before.checksum());
    EXPECT_LT(distance(mesh, before), 1e-12);
}

// Curved features keep all their vertices, and so few faces have no room for them. Singular vertices
// that do not help are not made: there were none.
TEST(Surface, SingularitiesDoNotRiseInVain) {
    mesh::QuadMesh torus = mesh::torus(16, 8).build(3);
    for (int e = 0; e < torus.n_edges(); ++e) { // squares of four by four faces
        const auto [v, w] = torus.edge_vertices(e);
        if ((v / 16 == w / 16 && v / 16 % 4 == 0) || (v % 16 == w % 16 && v % 4 == 0))
            torus.edge_flags[at(e)] |= mesh::feature;
    }
    const Outcome outcome = adapt_whole(torus, 0.1, {}, silent);
    EXPECT_EQ(outcome.singular_after, 0);
    EXPECT_TRUE(torus.singularities().empty());
    EXPECT_GT(outcome.faces_after, outcome.faces_wanted);
    EXPECT_NE(outcome.text.find("more singular vertices than there were"), std::string::npos) << outcome.text;
    EXPECT_GT(outcome.quality_after, 0);
}

TEST(Surface, FlaggedVerticesAndEdgesStay) {
    mesh::QuadMesh mesh = eared(3);
    // The equator, as far as edges of the octahedron's refinement are left by pairing.
    std::set<std::array<double, 3>> held;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (mesh.point(v)[2] != 0 || mesh.point(w)[2] != 0)
            continue;
        mesh.edge_flags[at(e)] |= mesh::feature;
        for (const int end : {v, w})
            held.insert({mesh.point(end)[0], mesh.point(end)[1], mesh.point(end)[2]});
    }
    ASSERT_GT(held.size(), 4u);
    adapt_whole(mesh, 1.5, {}, silent);
    std::size_t found = 0;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        found += held.count({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
    EXPECT_EQ(found, held.size());
}

} // namespace
} // namespace alphamst::adapt::samples
