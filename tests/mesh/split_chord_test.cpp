#include <gtest/gtest.h>

#include <algorithm>

#include "chord/judge.h"
#include "chord/meshes.h"

namespace alphamst::mesh {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

TEST(SplitChord, AddsFacesAndNoSingularVertex) {
    for (const auto &[name, mesh] : chord::samples::kinds())
        for (const int edge : chord::label(mesh).first)
            for (const int copies : {1, 3}) {
                const chord::Chord chord = chord::trace(mesh, edge);
                QuadMesh changed = mesh;
                const QuadMesh::Cut cut = changed.split_chord(chord.sides, copies);
                ASSERT_NO_THROW(changed.check()) << name << ", edge " << edge;
                EXPECT_EQ(changed.n_faces(), mesh.n_faces() + chord::faces_added(chord, copies)) << name;
                EXPECT_EQ(changed.singularities(), mesh.singularities()) << name;
                EXPECT_EQ(cut.faces.size(), chord.length() - at(chord.crossings) +
                                                static_cast<std::size_t>(chord::faces_added(chord, copies)));
                EXPECT_EQ(cut.vertices.size(), at(changed.n_vertices() - mesh.n_vertices()));
                // Where the chord crosses itself the copies do, too: they are one chord or several.
                if (chord.crossings == 0) {
                    EXPECT_EQ(chord::trace(changed, edge).length(), chord.length());
                }
            }
}

TEST(SplitChord, KeepsWhatWasThereAndTellsWhereThePiecesAreFrom) {
    QuadMesh mesh = chord::samples::scrambled(chord::samples::sphere(6), 12, 5);
    mesh.face_marker.resize(at(mesh.n_faces()));
    mesh.edge_marker.resize(at(mesh.n_edges()));
    for (int f = 0; f < mesh.n_faces(); ++f)
        mesh.face_marker[at(f)] = f;
    for (int e = 0; e < mesh.n_edges(); ++e)
        mesh.edge_marker[at(e)] = e + 1;
    for (const int edge : chord::label(mesh).first) {
        const chord::Chord chord = chord::trace(mesh, edge);
        QuadMesh changed = mesh;
        changed.split_chord(chord.sides, 2);
        for (int v = 0; v < mesh.n_vertices(); ++v)
            EXPECT_EQ(changed.point(v), mesh.point(v));
        for (int f = 0; f < changed.n_faces(); ++f) {
            const int origin = changed.face_origin[at(f)];
            EXPECT_EQ(changed.face_marker[at(f)], origin);
            // At most one corner is new at each corner of the old face, in the same order.
            const auto corners = changed.corners(f), before = mesh.corners(origin);
            for (std::size_t k = 0; k < 4; ++k)
                if (corners[k] < mesh.n_vertices()) {
                    EXPECT_EQ(corners[k], before[k]);
                }
        }
        std::vector<int> pieces(at(mesh.n_edges()), 0);
        for (int e = 0; e < changed.n_edges(); ++e) {
            const int origin = changed.edge_origin[at(e)];
            EXPECT_EQ(changed.edge_marker[at(e)], origin + 1);
            if (origin >= 0)
                ++pieces[at(origin)];
        }
        for (int e = 0; e < mesh.n_edges(); ++e)
            EXPECT_EQ(pieces[at(e)], std::any_of(chord.sides.begin(), chord.sides.end(),
                                                 [&](int side) { return side / 2 == e; })
                                         ? 3
                                         : 1);
    }
}

TEST(SplitChord, PiecesAreOfEqualWidth) {
    QuadMesh mesh = chord::samples::grid(3, 2);
    mesh.split_chord(chord::trace(mesh, mesh.find_edge(0, 1)).sides, 3);
    mesh.check();
    std::vector<double> x;
    for (int v = 12; v < mesh.n_vertices(); ++v)
        x.push_back(mesh.point(v)[0]);
    std::sort(x.begin(), x.end());
    EXPECT_EQ(x, (std::vector{0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.75, 0.75, 0.75}));
}

TEST(SplitChord, RefusesWhatIsNoChordAndChangesNothing) {
    QuadMesh mesh = torus(8, 6).build(3);
    const auto digest = mesh.checksum();
    const std::vector<int> sides = chord::trace(mesh, mesh.find_edge(0, 1)).sides;
    const auto fault = [&](std::vector<int> given, int copies) {
        return failure_of([&] { mesh.split_chord(given, copies); }).fault;
    };
    EXPECT_EQ(fault(sides, 0), Fault::internal);
    EXPECT_EQ(fault({}, 1), Fault::internal);
    EXPECT_EQ(fault({-1}, 1), Fault::internal);
    EXPECT_EQ(fault({sides[0], sides[0] ^ 1}, 1), Fault::internal);
    EXPECT_EQ(fault({sides[0], sides[2]}, 1), Fault::internal);
    EXPECT_EQ(mesh.checksum(), digest);
}

} // namespace
} // namespace alphamst::mesh
