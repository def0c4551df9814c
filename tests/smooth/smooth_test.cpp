#include "adapt/run.h"
#include "index.h"
#include "mesh/curved.h"
#include "mesh/feature.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/statistics.h"

namespace alphamst::smooth {
namespace {

using namespace adapt::samples;

// Vertices inside are moved as far as every corner stays positive.
void shake(mesh::QuadMesh &mesh, double far, unsigned seed) {
    std::mt19937 random(seed);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        if (mesh.on_boundary(v))
            continue;
        const OpenMesh::Vec3d here = mesh.point(v);
        const double dx = far * (chance(random) - 0.5), dy = far * (chance(random) - 0.5);
        mesh.set_point(v, here + OpenMesh::Vec3d(dx, dy, 0));
        if (!(least_scaled_jacobian(mesh, mesh.faces_around(v)) > 0.02))
            mesh.set_point(v, here);
    }
}

std::vector<int> moved(const mesh::QuadMesh &before, const mesh::QuadMesh &after) {
    std::vector<int> vertices;
    for (int v = 0; v < before.n_vertices(); ++v)
        if (std::memcmp(&before.point(v), &after.point(v), sizeof(OpenMesh::Vec3d)) != 0)
            vertices.push_back(v);
    return vertices;
}

bool same_connectivity(const mesh::QuadMesh &a, const mesh::QuadMesh &b) {
    return std::equal(a.faces().begin(), a.faces().end(), b.faces().begin(), b.faces().end());
}

TEST(Smooth, NeverLowersTheWorstCorner) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        mesh::QuadMesh mesh = unstructured(16, 30 + seed);
        shake(mesh, 1.2, seed);
        const mesh::QuadMesh before = mesh;
        const std::vector<Outcome> outcomes = smooth::smooth(mesh, nullptr, {}, silent);
        ASSERT_EQ(outcomes.size(), 1u);
        const std::vector<int> faces = all_faces(mesh);
        EXPECT_FALSE(outcomes[0].fault) << outcomes[0].text;
        EXPECT_TRUE(same_connectivity(before, mesh));
        EXPECT_NO_THROW(mesh.check());
        EXPECT_NEAR(outcomes[0].quality_before, least_scaled_jacobian(before, faces), 1e-12);
        EXPECT_NEAR(outcomes[0].quality_after, least_scaled_jacobian(mesh, faces), 1e-12);
        EXPECT_GT(least_scaled_jacobian(mesh, faces), least_scaled_jacobian(before, faces))
            << "seed " << seed;
        EXPECT_EQ(outcomes[0].singular_after, singular_in(mesh, faces));
        for (const int v : moved(before, mesh))
            EXPECT_FALSE(mesh.on_boundary(v));
        // Again and again it never gets worse.
        for (int i = 0; i < 3; ++i) {
            const double last = least_scaled_jacobian(mesh, faces);
            smooth::smooth(mesh, nullptr, {}, silent);
            EXPECT_GE(least_scaled_jacobian(mesh, faces), last);
        }
    }
}

TEST(Smooth, MovesTheInsideOfPatchesOnly) {
    mesh::QuadMesh mesh = unstructured(20, 40);
    shake(mesh, 1.2, 1);
    const mesh::QuadMesh before = mesh;
    std::mt19937 random(41);
    std::vector<Patch> regions(1);
    regions[0].faces = random_patch(mesh, 60, 61, random);
    const std::vector<Outcome> outcomes = smooth::smooth(mesh, &regions, {}, silent);
    ASSERT_EQ(outcomes.size(), 1u);
    EXPECT_GE(least_scaled_jacobian(mesh, regions[0].faces), least_scaled_jacobian(before, regions[0].faces));
    const patch::Window window = patch::make_window(mesh, regions[0].faces);
    const std::vector<int> changed = moved(before, mesh);
    EXPECT_FALSE(changed.empty());
    EXPECT_TRUE(
        std::includes(window.interior.begin(), window.interior.end(), changed.begin(), changed.end()));
    EXPECT_TRUE(same_connectivity(before, mesh));
}

TEST(Smooth, LeavesWhatIsHeld) {
    constexpr int n = 10, row = n + 1;
    mesh::QuadMesh mesh = grid(n, n);
    shake(mesh, 1.2, 2);
    const int v = 3 * row + 3, e = 5 * row + 5, m = 7 * row + 3;
    const std::size_t border = 2 * n + 7; // its four vertices lie on the border of a region
    mesh.vertex_flags[static_cast<std::size_t>(v)] = mesh::fixed;
    mesh.edge_flags[static_cast<std::size_t>(mesh.find_edge(e, e + 1))] = mesh::feature;
    mesh.edge_marker.assign(static_cast<std::size_t>(mesh.n_edges()), 0);
    mesh.edge_marker[static_cast<std::size_t>(mesh.find_edge(m, m + row))] = 4;
    mesh.face_marker.assign(n * n, 1);
    mesh.face_marker[border] = 2;
    const mesh::QuadMesh before = mesh;
    smooth::smooth(mesh, nullptr, {}, silent);
    const std::vector<int> changed = moved(before, mesh);
    std::vector<int> held{v, e, e + 1, m, m + row};
    for (const int corner : mesh.corners(static_cast<int>(border)))
        held.push_back(corner);
    for (const int w : held)
        EXPECT_FALSE(std::binary_search(changed.begin(), changed.end(), w)) << w;
    EXPECT_GT(changed.size(), 40u);
}

TEST(Smooth, RegularGridStays) {
    mesh::QuadMesh mesh = grid(6, 6);
    const mesh::QuadMesh before = mesh;
    smooth::smooth(mesh, nullptr, {}, silent);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_LT((mesh.point(v) - before.point(v)).norm(), 1e-9);
}

// A disk slit along a radius whose innermost faces have an edge of length 0, at the pole: nothing of that can
// be mended, and the other faces are no worse for it.
TEST(Smooth, LeavesSoundFacesAloneBesideBrokenOnes) {
    constexpr int around = 12, rings = 5;
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= around; ++i) {
            const double angle = 6 * i / double(around);
            points.insert(points.end(), {j * std::cos(angle), j * std::sin(angle), 0.0});
        }
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            const int v = j * (around + 1) + i;
            faces.insert(faces.end(), {v, v + around + 1, v + around + 2, v + 1});
        }
    mesh::QuadMesh mesh = mesh::QuadMesh::build(2, points, faces);
    const double before = reference::least_quality(mesh);
    const Outcome outcome = smooth(mesh, nullptr, {}, silent).at(0);
    EXPECT_GE(reference::least_quality(mesh), before);
    EXPECT_GE(outcome.quality_after, outcome.quality_before);
}

// A plane mesh that is graded stays so, also after several times.
TEST(Smooth, KeepsTheSizesOfAGradedMesh) {
    constexpr int n = 16;
    mesh::QuadMesh mesh = grid(n, n);
    std::mt19937 random(4);
    const auto graded = [](double x) { return std::pow(1.25, x); };
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        OpenMesh::Vec3d p = mesh.point(v);
        if (!mesh.on_boundary(v))
            p += OpenMesh::Vec3d(0.4 * adapt::samples::chance(random) - 0.2,
                                 0.4 * adapt::samples::chance(random) - 0.2, 0);
        mesh.set_point(v, {graded(p[0]), graded(p[1]), 0});
    }
    const auto ratio = [&] {
        double least = 1e300, most = 0;
        for (int f = 0; f < mesh.n_faces(); ++f) {
            const double area = geometry::area_vector(reference::quad_of(mesh, f)).norm();
            least = std::min(least, area);
            most = std::max(most, area);
        }
        return most / least;
    };
    const double before = ratio();
    for (int k = 0; k < 5; ++k)
        smooth(mesh, nullptr, {}, silent);
    EXPECT_LT(ratio(), 1.5 * before);
    EXPECT_GT(ratio(), before / 3);
}

// With a field "size" they become what is wished.
TEST(Smooth, GivesTheSizesThatAreWished) {
    constexpr int n = 16;
    mesh::QuadMesh mesh = grid(n, n), plain = mesh;
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        field.values.push_back(1 + mesh.point(v)[0] / n);
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
    smooth(mesh, nullptr, {}, silent);
    const int middle = (n + 1) * (n / 2) + n / 2;
    EXPECT_LT(mesh.point(middle)[0], plain.point(middle)[0] - 0.3);
}

TEST(Smooth, UntanglesOrLeaves) { // one inverted corner: never more of them
    mesh::QuadMesh mesh = grid(6, 6);
    mesh.set_point(3 * 7 + 3, {4.6, 3, 0});
    const double before = least_scaled_jacobian(mesh, all_faces(mesh));
    ASSERT_LE(before, 0);
    smooth::smooth(mesh, nullptr, {}, silent);
    EXPECT_GE(least_scaled_jacobian(mesh, all_faces(mesh)), before);
}

// A box of edges 1, 2 and 3 whose features are flagged. Only vertices two or more edges away from those are
// pushed about: next to its corners, where quads that bend around one look worst, all is as good as it can
// be.
mesh::QuadMesh box(unsigned seed) {
    constexpr int n = 8;
    std::mt19937 random(seed);
    mesh::QuadMesh mesh = mesh::cube(n, [&](Eigen::Vector3d p) {
        const auto inside = [](double x) { return x > 1 && x < n - 1; };
        if (std::count_if(p.begin(), p.end(), inside) == 2)
            for (double &x : p)
                if (inside(x))
                    x += 0.3 * (chance(random) - 0.5);
        return Eigen::Vector3d(p.x() / n, 2 * p.y() / n, 3 * p.z() / n);
    });
    const mesh::Features features = mesh::find_features(mesh, 40);
    for (const int e : features.edges)
        mesh.edge_flags[static_cast<std::size_t>(e)] |= mesh::feature;
    for (const int v : features.corners)
        mesh.vertex_flags[static_cast<std::size_t>(v)] |= mesh::corner;
    return mesh;
}

double least_on_surface(mesh::QuadMesh mesh) {
    const std::vector<double> all = reference::reference_of(mesh).scaled_jacobians(mesh);
    return *std::min_element(all.begin(), all.end());
}

// The quads at the corners of the box would become slightly worse: that costs no more than what is near them.
TEST(Smooth, FewQuadsThatBecomeWorseDoNotCostTheRest) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        const mesh::QuadMesh before = box(seed);
        std::vector<std::uint64_t> digests;
        for (const int threads : {1, 4}) {
            mesh::QuadMesh mesh = before;
            Settings settings;
            settings.threads = threads;
            const Outcome outcome = smooth::smooth(mesh, nullptr, settings, silent).at(0);
            EXPECT_LT(outcome.quality_before, 0.85) << seed;
            EXPECT_GT(outcome.quality_after, 0.92) << seed;
            EXPECT_GE(least_on_surface(mesh), least_on_surface(before)) << seed;
            EXPECT_GT(moved(before, mesh).size(), at(before.n_vertices()) * 3 / 4) << seed;
            EXPECT_NO_THROW(mesh.check());
            digests.push_back(mesh.checksum());
        }
        EXPECT_EQ(digests[0], digests[1]);
    }
}

TEST(Smooth, CancelComesThrough) {
    mesh::QuadMesh mesh = grid(6, 6);
    shake(mesh, 1.2, 3);
    const auto before = mesh.checksum();
    EXPECT_THROW(smooth::smooth(mesh, nullptr, {},
                                [](double, const char *) { throw Failure(Fault::cancelled, "stop"); }),
                 Failure);
    EXPECT_EQ(mesh.checksum(), before);
}

} // namespace
} // namespace alphamst::smooth
