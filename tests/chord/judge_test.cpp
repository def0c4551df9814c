// Judgements against an oracle that merges the vertices in plain arrays and builds the mesh anew.
#include "chord/judge.h"

#include <gtest/gtest.h>

#include <numeric>
#include <optional>

#include "chord/meshes.h"

namespace alphamst::chord {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

const Rules everything{true, 400};

int find(std::vector<int> &parent, int v) {
    while (parent[at(v)] != v)
        v = parent[at(v)];
    return v;
}

// The mesh without the chord; nothing if that is no mesh as it should be.
std::optional<mesh::QuadMesh> collapsed(const mesh::QuadMesh &mesh, const Chord &chord) {
    std::vector<int> parent(at(mesh.n_vertices()));
    std::iota(parent.begin(), parent.end(), 0);
    int merged = 0;
    for (const int side : chord.sides) {
        const auto [v, w] = mesh.edge_vertices(side / 2);
        const int a = find(parent, v), b = find(parent, w);
        merged += a != b;
        parent[at(a)] = b;
    }
    const std::set<int> gone(chord.faces.begin(), chord.faces.end());
    if (gone.size() == at(mesh.n_faces()))
        return {};
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const double x : mesh.point(v))
            points.push_back(x);
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (!gone.contains(f))
            for (const int v : mesh.corners(f))
                faces.push_back(find(parent, v));
    try {
        mesh::QuadMesh result = mesh::QuadMesh::build(3, points, faces);
        const int crossed = static_cast<int>(chord.sides.size());
        int edges = 0, lost = 0;
        for (int v = 0; v < mesh.n_vertices(); ++v)
            lost += result.isolated(v) && !mesh.isolated(v);
        edges = mesh.n_edges() - crossed - static_cast<int>(chord.length());
        if (result.n_edges() != edges || lost != merged || merged != crossed)
            return {};
        for (int v = 0; v < mesh.n_vertices(); ++v)
            if (!result.isolated(v) && (result.valence(v) > (mesh.valence(v) > 6 ? 12 : 6) ||
                                        (!result.on_boundary(v) && result.valence(v) < 3)))
                return {};
        return result;
    } catch (const Failure &) {
        return {};
    }
}

TEST(Judge, AllowsExactlyWhatLeavesAMesh) {
    int allowed = 0, refused = 0;
    std::int32_t reasons = 0;
    for (const auto &[name, mesh] : samples::kinds()) {
        Judge judge(mesh, everything);
        for (const int first : label(mesh).first) {
            const Chord chord = trace(mesh, first);
            const Collapse verdict = judge(chord);
            const auto oracle = collapsed(mesh, chord);
            reasons |= verdict.reasons;
            if (verdict.reasons == 0) {
                ASSERT_TRUE(oracle.has_value()) << name << ", edge " << first;
                EXPECT_EQ(verdict.singular_change, static_cast<int>(oracle->singularities().size()) -
                                                       static_cast<int>(mesh.singularities().size()))
                    << name << ", edge " << first;
                ++allowed;
            } else {
                // Curves are not the oracle's: of two boundary vertices one is a crossing at most.
                EXPECT_TRUE(!oracle.has_value() || (verdict.reasons & (at_boundary | crosses_itself)) != 0)
                    << name << ", edge " << first << ": " << verdict.text();
                ++refused;
            }
        }
    }
    EXPECT_GT(allowed, 100);
    EXPECT_GT(refused, 50);
    EXPECT_EQ(reasons & (crosses_itself | closes_up | at_boundary | bad_valence | doubles_edge),
              crosses_itself | closes_up | at_boundary | bad_valence | doubles_edge);
}

TEST(Judge, LeavesNothingBehind) {
    const mesh::QuadMesh mesh = samples::scrambled(samples::sphere(5), 20, 3);
    Judge judge(mesh, everything);
    const Labels labels = label(mesh);
    std::vector<std::int32_t> before;
    for (const int first : labels.first)
        before.push_back(Judge(mesh, everything)(trace(mesh, first)).reasons);
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < labels.first.size(); ++i)
            EXPECT_EQ(judge(trace(mesh, labels.first[i])).reasons, before[i]);
}

TEST(Judge, TheBoundaryChangesOnlyWhereTheCallerAllows) {
    const mesh::QuadMesh mesh = samples::grid(4, 3);
    const Chord column = trace(mesh, mesh.find_edge(1, 2));
    EXPECT_EQ(Judge(mesh, {})(column).reasons, at_boundary);
    EXPECT_EQ(judge_split(mesh, column, {}).reasons, at_boundary);
    const Rules rules{true};
    EXPECT_EQ(Judge(mesh, rules)(column).reasons, 0);
    EXPECT_EQ(judge_split(mesh, column, rules).reasons, 0);
    // The corner of the plate survives the row beside it.
    const Collapse first = Judge(mesh, rules)(trace(mesh, mesh.find_edge(0, 1)));
    ASSERT_EQ(first.reasons, 0);
    std::set<int> survivors;
    for (const Group &group : first.groups) {
        EXPECT_TRUE(group.held);
        survivors.insert(group.survivor);
    }
    EXPECT_TRUE(survivors.contains(0) && survivors.contains(15));
}

TEST(Judge, TwoCornersOfTheBoundaryAreNotMerged) {
    const mesh::QuadMesh mesh = samples::grid(1, 4);
    const Collapse verdict = Judge(mesh, {true})(trace(mesh, mesh.find_edge(0, 1)));
    EXPECT_NE(verdict.reasons, 0);
    const mesh::QuadMesh narrow = samples::grid(3, 1);
    EXPECT_EQ(Judge(narrow, {true})(trace(narrow, narrow.find_edge(1, 2))).reasons, 0);
}

TEST(Judge, FlagsAndFeaturesHold) {
    const auto ring = [](auto flag) {
        mesh::QuadMesh mesh = mesh::torus(8, 6).build(3);
        flag(mesh);
        const Collapse verdict = Judge(mesh, {})(trace(mesh, mesh.find_edge(0, 1)));
        return verdict.reasons;
    };
    const auto nothing = [](mesh::QuadMesh &) {};
    EXPECT_EQ(ring(nothing), 0);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) { m.vertex_flags[0] = mesh::fixed; }), 0);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) { m.vertex_flags[0] = m.vertex_flags[1] = mesh::fixed; }), is_fixed);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) { m.edge_flags[at(m.find_edge(8, 9))] = mesh::fixed; }) & is_fixed,
              is_fixed);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) { m.face_flags[0] = mesh::fixed; }) & is_fixed, is_fixed);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) { m.edge_flags[at(m.find_edge(0, 1))] = mesh::feature; }),
              at_feature);
    // Curves along both borders of the ring of faces would become one.
    EXPECT_EQ(ring([](mesh::QuadMesh &m) {
                  for (int j = 0; j < 6; ++j)
                      for (const int i : {0, 1})
                          m.edge_flags[at(m.find_edge(8 * j + i, 8 * ((j + 1) % 6) + i))] = mesh::feature;
              }),
              at_feature);
    // One curve is kept, and so is a region border.
    EXPECT_EQ(ring([](mesh::QuadMesh &m) {
                  for (int j = 0; j < 6; ++j)
                      m.edge_flags[at(m.find_edge(8 * j, 8 * ((j + 1) % 6)))] = mesh::feature;
              }),
              0);
    EXPECT_EQ(ring([](mesh::QuadMesh &m) {
                  m.face_marker.assign(at(m.n_faces()), 1);
                  for (int j = 0; j < 6; ++j)
                      for (int i = 1; i < 5; ++i)
                          m.face_marker[at(8 * j + i)] = 2;
              }),
              0);
}

TEST(Judge, ASplitOfAFixedFaceIsRefused) {
    mesh::QuadMesh mesh = mesh::torus(8, 6).build(3);
    const Chord chord = trace(mesh, mesh.find_edge(0, 1));
    EXPECT_EQ(judge_split(mesh, chord, {}).reasons, 0);
    EXPECT_EQ(faces_added(chord, 3), 18);
    mesh.face_flags[at(chord.faces[2])] = mesh::fixed;
    EXPECT_EQ(judge_split(mesh, chord, {}).reasons, is_fixed);
}

TEST(Judge, FeaturesLoseWhatIsSparedAndTheBoundaryNothing) {
    mesh::QuadMesh mesh = samples::sphere(4);
    const auto sides = [&](int v) { // of the cube
        int n = 0;
        for (const double x : mesh.point(v))
            n += x == 0 || x == 4;
        return n;
    };
    int across = -1; // an edge of the mesh amid an edge of the cube
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (sides(v) >= 2 && sides(w) >= 2)
            mesh.edge_flags[at(e)] = mesh::feature;
        if (sides(v) == 2 && sides(w) == 2)
            across = e;
    }
    const Chord chord = trace(mesh, across);
    const auto reasons = [&](const std::function<bool(const mesh::QuadMesh &, int)> &spared) {
        Rules rules;
        rules.spared = spared;
        return Judge(mesh, rules)(chord).reasons;
    };
    EXPECT_EQ(reasons(nullptr), at_feature);
    EXPECT_EQ(reasons([](const mesh::QuadMesh &, int) { return true; }), 0);
    EXPECT_EQ(reasons([](const mesh::QuadMesh &, int) { return false; }), at_feature);
    // Of the two ends of each edge one is enough.
    std::set<int> ends;
    for (const int side : chord.sides)
        if (mesh.edge_flags[at(side / 2)] != 0)
            ends.insert(mesh.edge_vertices(side / 2)[0]);
    EXPECT_EQ(reasons([&](const mesh::QuadMesh &, int v) { return ends.contains(v); }), 0);

    const mesh::QuadMesh open = samples::grid(4, 4);
    Rules rules;
    rules.spared = [](const mesh::QuadMesh &, int) { return true; };
    EXPECT_EQ(Judge(open, rules)(trace(open, label(open).first[0])).reasons, at_boundary);
}

} // namespace
} // namespace alphamst::chord
