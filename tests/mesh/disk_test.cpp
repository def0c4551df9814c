// Disks at the boundary of a mesh, where vertices come and go; replace_disk_test has those that keep their
// loop.
#include "mesh/disk.h"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Quads = std::vector<std::array<int, 4>>;
using Points = std::vector<OpenMesh::Vec3d>;

// Around a loop a ring of quads, inside it quads from its first vertex: no edge but the loop's can be there
// already.
void fill_loop(int n, Quads &quads) {
    for (int i = 0; i < n; ++i)
        quads.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    for (int i = 1; i + 2 < n; i += 2)
        quads.push_back({n, n + i, n + i + 1, n + i + 2});
}

// [side] counter-clockwise around faces that are a disk; empty if they are none.
std::vector<std::array<int, 2>> sides_around(const QuadMesh &mesh, const std::set<int> &faces) {
    std::map<int, int> next;
    std::size_t edges = 0;
    std::set<int> vertices;
    for (const int f : faces) {
        const auto corners = mesh.corners(f), neighbours = mesh.neighbours(f);
        for (std::size_t i = 0; i < 4; ++i) {
            vertices.insert(corners[i]);
            if (faces.contains(neighbours[i]))
                continue;
            ++edges;
            next[corners[i]] = corners[(i + 1) % 4];
        }
    }
    const std::size_t all = (4 * faces.size() + edges) / 2;
    std::vector<std::array<int, 2>> sides;
    for (int v = next.begin()->first; sides.size() <= edges;) {
        sides.push_back({v, next[v]});
        v = next[v];
        if (v == sides.front()[0])
            break;
    }
    return sides.size() == edges && next.size() == edges && vertices.size() + faces.size() == all + 1
               ? sides
               : std::vector<std::array<int, 2>>();
}

std::set<int> some_faces(const QuadMesh &mesh, std::mt19937 &random) {
    std::set<int> faces{static_cast<int>(random() % unsigned(mesh.n_faces()))};
    const std::size_t most = 1 + random() % 12;
    for (int k = 0; k < 40 && faces.size() < most; ++k) {
        auto some = faces.begin();
        std::advance(some, random() % faces.size());
        if (const int f = mesh.neighbours(*some)[random() % 4]; f >= 0)
            faces.insert(f);
    }
    return faces;
}

// A loop that keeps some vertices of the boundary, each with its parent.
struct NewLoop {
    std::vector<int> vertices, parents;
    std::map<int, int> markers; // of new edges, by how many have them
};

NewLoop respaced(const QuadMesh &mesh, const std::vector<std::array<int, 2>> &sides, std::mt19937 &random) {
    NewLoop loop;
    const auto free = [&](int v) { return mesh.on_boundary(v) && mesh.valence(v) > 0; };
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto [v, w] = sides[i];
        const int edge = mesh.find_edge(v, w);
        const auto faces = mesh.edge_faces(edge);
        const std::array<int, 2> before = sides[(i + sides.size() - 1) % sides.size()];
        const auto faces_before = mesh.edge_faces(mesh.find_edge(before[0], before[1]));
        const bool rim = faces[0] < 0 || faces[1] < 0,
                   rim_before = faces_before[0] < 0 || faces_before[1] < 0;
        const bool goes = rim && rim_before && free(v) && random() % 2 == 0;
        if (!goes) {
            loop.vertices.push_back(v);
            loop.parents.push_back(rim ? v : -1);
        }
        for (int k = rim ? int(random() % 3) : 0; k > 0; --k) {
            loop.vertices.push_back(-1);
            loop.parents.push_back(v);
        }
    }
    for (const int parent : loop.parents)
        for (const auto &[v, w] : sides)
            if (v == parent)
                ++loop.markers[mesh.edge_marker[std::size_t(mesh.find_edge(v, w))]];
    return loop;
}

std::map<int, int> boundary_markers(const QuadMesh &mesh) {
    std::map<int, int> count;
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (const auto faces = mesh.edge_faces(e); faces[0] < 0 || faces[1] < 0)
            ++count[mesh.edge_marker[std::size_t(e)]];
    return count;
}

std::map<int, int> plus(std::map<int, int> a, const std::map<int, int> &b, int sign) {
    for (const auto &[marker, count] : b)
        a[marker] += sign * count;
    std::erase_if(a, [](const auto &entry) { return entry.second == 0; });
    return a;
}

// One disk of the mesh with another number of vertices on the boundary.
void respace_once(QuadMesh &mesh, std::mt19937 &random, int &replaced_disks) {
    const std::set<int> faces = some_faces(mesh, random);
    const auto sides = sides_around(mesh, faces);
    if (sides.empty())
        return;
    const NewLoop loop = respaced(mesh, sides, random);
    const int n = static_cast<int>(loop.vertices.size());
    if (n % 2 != 0 || n < 4)
        return;
    std::map<int, int> gone;
    for (const auto &[v, w] : sides) {
        const int edge = mesh.find_edge(v, w);
        const auto beside = mesh.edge_faces(edge);
        if (beside[0] < 0 || beside[1] < 0)
            ++gone[mesh.edge_marker[std::size_t(edge)]];
    }
    Quads quads;
    fill_loop(n, quads);
    const auto rim = std::count(loop.vertices.begin(), loop.vertices.end(), -1);
    const Points points(std::size_t(rim + n), OpenMesh::Vec3d(1, 2, 3));
    const int euler = mesh.n_vertices() - mesh.n_edges() + mesh.n_faces();
    const auto wanted = plus(plus(boundary_markers(mesh), gone, -1), loop.markers, 1);
    const std::vector<int> list(faces.begin(), faces.end());
    const auto replaced = mesh.replace_disk(list, loop.vertices, quads, points, loop.parents);
    ASSERT_EQ(replaced.vertices.size(), points.size());
    ++replaced_disks;
    ASSERT_NO_THROW(mesh.check());
    ASSERT_EQ(mesh.n_vertices() - mesh.n_edges() + mesh.n_faces(), euler);
    ASSERT_EQ(boundary_markers(mesh), wanted);
}

TEST(Disk, ThousandOnTheBoundaryAtRandom) {
    std::mt19937 random(3);
    int replaced = 0;
    for (int run = 0; run < 250; ++run) {
        QuadMesh mesh = plane(5, 4).build(3);
        mesh.edge_marker.resize(std::size_t(mesh.n_edges()));
        for (auto &marker : mesh.edge_marker)
            marker = int(random() % 4);
        for (int k = 0; k < 8 && !testing::Test::HasFatalFailure(); ++k)
            respace_once(mesh, random, replaced);
    }
    EXPECT_GT(replaced, 500);
}

// The lower edge of one square gets two vertices; its two corners there stay.
class AtTheRim : public testing::Test {
protected:
    std::vector<int> faces{1}, loop{1, -1, -2, 2, 6, 5}, parents;
    Quads quads{{0, 1, 2, 5}, {2, 3, 4, 5}};
    Points points{{1.3, 0, 0}, {1.6, 0, 0}};
    QuadMesh mesh = plane(3, 3).build(3);

    void SetUp() override {
        parents.assign(loop.size(), 1);
        mesh.edge_flags[std::size_t(mesh.find_edge(1, 2))] = feature;
    }
    void expect_refused() {
        const auto checksum = mesh.checksum();
        const Failure failure = failure_of([&] { mesh.replace_disk(faces, loop, quads, points, parents); });
        EXPECT_EQ(failure.fault, Fault::internal) << failure.text;
        EXPECT_EQ(mesh.checksum(), checksum);
    }
};

TEST_F(AtTheRim, GetsTwoVertices) {
    const std::int32_t origin = mesh.edge_origin[std::size_t(mesh.find_edge(1, 2))];
    const auto replaced = mesh.replace_disk(faces, loop, quads, points, parents);
    mesh.check();
    EXPECT_EQ(mesh.point(replaced.vertices[0]), points[0]);
    EXPECT_EQ(mesh.point(replaced.vertices[1]), points[1]);
    for (const int v : replaced.vertices)
        EXPECT_TRUE(mesh.on_boundary(v));
    const int edge = mesh.find_edge(replaced.vertices[0], replaced.vertices[1]);
    ASSERT_GE(edge, 0);
    EXPECT_EQ(mesh.edge_flags[std::size_t(edge)], feature);
    EXPECT_EQ(mesh.edge_origin[std::size_t(edge)], origin);
}
TEST_F(AtTheRim, WithoutParents) { parents.clear(), expect_refused(); }
TEST_F(AtTheRim, TooFewParents) { parents.pop_back(), expect_refused(); }
TEST_F(AtTheRim, ParentElsewhere) { parents[1] = 0, expect_refused(); }
TEST_F(AtTheRim, PointMissing) { points.pop_back(), expect_refused(); }
TEST_F(AtTheRim, NewVertexInside) { loop = {1, 2, 6, -1, -2, 5}, expect_refused(); }
TEST_F(AtTheRim, VertexThatOtherFacesNeed) {
    loop = {1, -1, -2, -3, 6, 5}, points.push_back({2, 0, 0}), expect_refused();
}

} // namespace
} // namespace alphamst::mesh
