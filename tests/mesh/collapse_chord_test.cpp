#include <gtest/gtest.h>

#include "chord/judge.h"
#include "chord/meshes.h"

namespace alphamst::mesh {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

const chord::Rules everything{true, 400};

std::vector<std::array<int, 2>> merged(const chord::Collapse &verdict) {
    std::vector<std::array<int, 2>> result;
    for (const chord::Group &group : verdict.groups)
        for (const int v : group.others)
            result.push_back({v, group.survivor});
    return result;
}

TEST(CollapseChord, LeavesTheMeshThatWasForeseen) {
    int done = 0;
    for (const auto &[name, mesh] : chord::samples::kinds())
        for (const int edge : chord::label(mesh).first) {
            const chord::Chord chord = chord::trace(mesh, edge);
            const chord::Collapse verdict = chord::Judge(mesh, everything)(chord);
            if (verdict.reasons != 0)
                continue;
            QuadMesh changed = mesh;
            changed.collapse_chord(chord.sides, merged(verdict));
            ASSERT_NO_THROW(changed.check()) << name << ", edge " << edge;
            EXPECT_EQ(changed.n_faces(), mesh.n_faces() - static_cast<int>(chord.length())) << name;
            EXPECT_EQ(static_cast<int>(changed.singularities().size()),
                      static_cast<int>(mesh.singularities().size()) + verdict.singular_change)
                << name;
            ++done;
        }
    EXPECT_GT(done, 100);
}

// Every face that stays has the corners it had, but for the merged ones; the origins tell which is which.
TEST(CollapseChord, OriginsTellWhatIsWhere) {
    const QuadMesh mesh = chord::samples::scrambled(chord::samples::sphere(6), 12, 5);
    for (const int edge : chord::label(mesh).first) {
        const chord::Chord chord = chord::trace(mesh, edge);
        const chord::Collapse verdict = chord::Judge(mesh, everything)(chord);
        if (verdict.reasons != 0)
            continue;
        QuadMesh changed = mesh;
        const auto result = changed.collapse_chord(chord.sides, merged(verdict));
        std::vector<int> now(at(mesh.n_vertices()), -1);
        for (int v = 0; v < changed.n_vertices(); ++v) {
            now[at(changed.vertex_origin[at(v)])] = v;
            EXPECT_EQ(changed.point(v), mesh.point(changed.vertex_origin[at(v)]));
        }
        for (const auto &[gone, survivor] : merged(verdict)) {
            EXPECT_EQ(now[at(gone)], -1);
            now[at(gone)] = now[at(survivor)];
        }
        for (int f = 0; f < changed.n_faces(); ++f) {
            const auto before = mesh.corners(changed.face_origin[at(f)]), after = changed.corners(f);
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_EQ(after[k], now[at(before[k])]);
        }
        std::vector<char> there(at(mesh.n_edges()), 0);
        for (int e = 0; e < changed.n_edges(); ++e) {
            const auto [v, w] = mesh.edge_vertices(changed.edge_origin[at(e)]);
            EXPECT_EQ(changed.find_edge(now[at(v)], now[at(w)]), e);
            there[at(changed.edge_origin[at(e)])] = 1;
        }
        for (const auto &[gone, kept] : result.glued) {
            EXPECT_FALSE(there[at(gone)]);
            EXPECT_TRUE(there[at(kept)]);
        }
    }
}

TEST(CollapseChord, AGluedEdgeHasTheFlagsAndTheNumberOfBoth) {
    QuadMesh mesh = torus(8, 6).build(3);
    mesh.edge_marker.assign(at(mesh.n_edges()), 0);
    const auto along = [&](int i) { return at(mesh.find_edge(i, 8 + i)); };
    mesh.edge_flags[along(0)] = mesh::feature;
    mesh.edge_marker[along(1)] = 7;
    const chord::Chord chord = chord::trace(mesh, mesh.find_edge(0, 1));
    std::vector<std::array<int, 2>> pairs;
    for (int j = 0; j < 6; ++j)
        pairs.push_back({8 * j + 1, 8 * j});
    mesh.collapse_chord(chord.sides, pairs);
    mesh.check();
    int found = 0;
    for (std::size_t e = 0; e < mesh.edge_flags.size(); ++e)
        if (mesh.edge_flags[e] != 0 || mesh.edge_marker[e] != 0) {
            EXPECT_EQ(mesh.edge_flags[e], mesh::feature);
            EXPECT_EQ(mesh.edge_marker[e], 7);
            ++found;
        }
    EXPECT_EQ(found, 1);
}

TEST(CollapseChord, RefusesWhatIsNoChordAndChangesNothing) {
    QuadMesh mesh = torus(8, 6).build(3);
    const auto digest = mesh.checksum();
    const std::vector<int> sides = chord::trace(mesh, mesh.find_edge(0, 1)).sides;
    const auto fault = [&](std::vector<int> given, std::vector<std::array<int, 2>> pairs) {
        return failure_of([&] { mesh.collapse_chord(given, pairs); }).fault;
    };
    EXPECT_EQ(fault({1 << 20}, {}), Fault::internal);
    EXPECT_EQ(fault({sides[0], sides[0]}, {}), Fault::internal);
    EXPECT_EQ(fault(sides, {{1, 0}, {1, 8}}), Fault::internal);
    EXPECT_EQ(fault(sides, {{1, 0}, {0, 9}}), Fault::internal);
    EXPECT_EQ(fault(sides, {{1, -1}}), Fault::internal);
    EXPECT_EQ(mesh.checksum(), digest);
}

} // namespace
} // namespace alphamst::mesh
