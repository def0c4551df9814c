#include "chords/edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "chord/table.h"

namespace alphamst::chords {
namespace {

using namespace adapt::samples;

const Settings settings;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::int64_t singular(const mesh::QuadMesh &mesh) {
    return static_cast<std::int64_t>(mesh.singularities().size());
}
// Lays one mesh on the other from a pair of sides; true if that reaches every face, one to one.
bool matches(const mesh::QuadMesh &a, const mesh::QuadMesh &b, int face, std::size_t turn) {
    std::vector<int> vertex(at(a.n_vertices()), -1), image(at(a.n_faces()), -1), turned(at(a.n_faces()), 0);
    std::vector<char> used(at(b.n_faces()), 0);
    std::queue<int> queue;
    const auto put = [&](int f, int g, std::size_t by) {
        image[at(f)] = g;
        turned[at(f)] = static_cast<int>(by);
        if (used[at(g)])
            return false;
        used[at(g)] = 1;
        queue.push(f);
        for (std::size_t k = 0; k < 4; ++k) {
            int &v = vertex[at(a.corners(f)[k])];
            const int w = b.corners(g)[(k + by) % 4];
            if (v >= 0 && v != w)
                return false;
            v = w;
        }
        return true;
    };
    if (!put(0, face, turn))
        return false;
    while (!queue.empty()) {
        const int f = queue.front(), g = image[at(f)];
        queue.pop();
        for (std::size_t k = 0; k < 4; ++k) {
            const int next = a.neighbours(f)[k], other = b.neighbours(g)[(k + at(turned[at(f)])) % 4];
            if ((next < 0) != (other < 0))
                return false;
            if (next < 0 || image[at(next)] >= 0) {
                if (next >= 0 && image[at(next)] != other)
                    return false;
                continue;
            }
            std::size_t i = 0, j = 0; // where the neighbours have the common edge
            while (a.corners(next)[i] != a.corners(f)[(k + 1) % 4])
                ++i;
            while (b.corners(other)[j] != vertex[at(a.corners(f)[(k + 1) % 4])])
                ++j;
            if (!put(next, other, (j + 4 - i) % 4))
                return false;
        }
    }
    return std::count(used.begin(), used.end(), 1) == b.n_faces();
}

bool isomorphic(const mesh::QuadMesh &a, const mesh::QuadMesh &b) {
    if (a.n_faces() != b.n_faces() || a.n_vertices() != b.n_vertices() || a.n_edges() != b.n_edges())
        return false;
    for (int face = 0; face < b.n_faces(); ++face)
        for (std::size_t turn = 0; turn < 4; ++turn)
            if (matches(a, b, face, turn))
                return true;
    return false;
}
struct Case {
    const char *name;
    mesh::QuadMesh mesh;
    std::vector<int> patch;
    int added; // singular vertices: at the corners of the core, and where corners of the patch are inside
};

std::vector<Case> cases() {
    std::vector<Case> result;
    result.push_back({"4 sides inside", grid(10, 10), block(10, 3, 3, 7, 8), 8});
    result.push_back({"4 sides, all", grid(5, 4), all_faces(grid(5, 4)), 4});
    for (const int n : {3, 5, 6}) {
        const mesh::QuadMesh mesh = star(n, 4);
        result.push_back({"all of a star", mesh, all_faces(mesh), n});
        std::vector<int> inner; // the blocks next to the middle
        for (int k = 0; k < n; ++k)
            for (int a = 0; a < 2; ++a)
                for (int b = 0; b < 2; ++b)
                    inner.push_back(k * 16 + a * 4 + b);
        std::sort(inner.begin(), inner.end());
        result.push_back({"the middle of a star", mesh, inner, 2 * n});
    }
    return result;
}

TEST(InsertChords, LaysRingsWithTheSingularVerticesOfTheTemplateWhateverTheirNumber) {
    for (const Case &c : cases())
        for (const int n : {1, 2, 5}) {
            mesh::QuadMesh mesh = c.mesh;
            std::vector<Patch> patches{{c.patch, {}, 0}};
            const auto loop = patch::make_window(mesh, c.patch).loop;
            const Outcome outcome = insert_chords(mesh, patches, n, settings, silent).front();
            ASSERT_FALSE(outcome.fault.has_value()) << c.name << ": " << outcome.text;
            mesh.check();
            EXPECT_EQ(mesh.n_faces(), c.mesh.n_faces() + n * static_cast<int>(loop.size())) << c.name;
            EXPECT_EQ(singular(mesh), singular(c.mesh) + c.added) << c.name;
            EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
            EXPECT_GT(outcome.quality_after, 0);
            EXPECT_EQ(patch::make_window(mesh, patches[0].faces).loop.size(), loop.size());
            for (const int v : loop)
                EXPECT_EQ(mesh.point(v), c.mesh.point(v));
        }
}

TEST(InsertChords, CollapsingTheRingsGivesTheOldConnectivity) {
    for (const Case &c : cases()) {
        constexpr int n = 3;
        mesh::QuadMesh mesh = c.mesh;
        std::vector<Patch> patches{{c.patch, {}, 0}};
        insert_chords(mesh, patches, n, settings, silent);
        EXPECT_FALSE(isomorphic(mesh, c.mesh));
        for (int left = n; left > 0; --left) {
            EXPECT_EQ(singular(mesh), singular(c.mesh) + c.added) << c.name;
            const auto rows = chord::table(mesh, {});
            const auto ring = std::find_if(rows.begin(), rows.end(), [](const chord::Row &row) {
                return row.closed && row.reasons == 0;
            });
            ASSERT_NE(ring, rows.end()) << c.name;
            EXPECT_EQ(ring->singular_after, singular(c.mesh) + (left > 1 ? c.added : 0)) << c.name;
            ASSERT_NO_THROW(collapse_chord(mesh, ring->edge, {}, settings, silent)) << c.name;
            mesh.check();
        }
        EXPECT_TRUE(isomorphic(mesh, c.mesh)) << c.name;
    }
}

TEST(InsertChords, RingsInAPatchWithoutCornersAddNoSingularVertex) {
    mesh::QuadMesh mesh = grid(10, 10);
    std::vector<Patch> patches{{block(10, 3, 3, 7, 7), {}, 0}};
    insert_chords(mesh, patches, 1, settings, silent);
    const std::int64_t before = singular(mesh);
    const Outcome outcome = insert_chords(mesh, patches, 2, settings, silent).front();
    EXPECT_FALSE(outcome.fault.has_value()) << outcome.text;
    EXPECT_EQ(singular(mesh), before);
}

TEST(InsertChords, LeavesPatchesWithOtherSides) {
    mesh::QuadMesh mesh = grid(10, 10);
    std::vector<int> angle = block(10, 2, 2, 7, 4);
    const std::vector<int> arm = block(10, 2, 4, 4, 7);
    angle.insert(angle.end(), arm.begin(), arm.end());
    std::sort(angle.begin(), angle.end());
    std::vector<Patch> patches{{angle, {}, 0}, {block(10, 6, 6, 9, 9), {0, 1, 2}, 0}};
    const auto digest = mesh.checksum();
    for (const Outcome &outcome : insert_chords(mesh, patches, 1, settings, silent))
        EXPECT_EQ(outcome.fault, Fault::patch);
    EXPECT_EQ(mesh.checksum(), digest);
}
} // namespace
} // namespace alphamst::chords
