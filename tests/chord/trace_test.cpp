#include "chord/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "chord/meshes.h"

namespace alphamst::chord {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

TEST(Trace, EveryEdgeIsOnOneChordAndEveryFaceOnTwo) {
    for (const auto &[name, mesh] : samples::kinds()) {
        const Labels labels = label(mesh);
        std::vector<int> met(at(mesh.n_faces()), 0), on(at(mesh.n_edges()), 0);
        std::size_t sum = 0;
        for (const int first : labels.first) {
            const Chord chord = trace(mesh, first);
            sum += chord.length();
            EXPECT_EQ(chord.sides.size(), chord.length() + (chord.closed ? 0U : 1U)) << name;
            for (const int face : chord.faces)
                ++met[at(face)];
            for (const int side : chord.sides) {
                ++on[at(side / 2)];
                EXPECT_EQ(labels.of_edge[at(side / 2)], labels.of_edge[at(first)]) << name;
            }
        }
        EXPECT_EQ(sum, 2 * at(mesh.n_faces())) << name;
        EXPECT_TRUE(std::all_of(met.begin(), met.end(), [](int n) { return n == 2; })) << name;
        EXPECT_TRUE(std::all_of(on.begin(), on.end(), [](int n) { return n == 1; })) << name;
    }
}

TEST(Trace, ChordsAreNumberedByTheirSmallestEdges) {
    for (const auto &[name, mesh] : samples::kinds()) {
        const Labels labels = label(mesh);
        std::set<int> met;
        for (int edge = 0; edge < mesh.n_edges(); ++edge)
            if (met.insert(labels.of_edge[at(edge)]).second) {
                EXPECT_EQ(labels.of_edge[at(edge)], static_cast<int>(met.size()) - 1) << name;
                EXPECT_EQ(labels.first[met.size() - 1], edge) << name;
            }
    }
}

TEST(Trace, SidesAreOppositeInTheirFaceAndPointTheSameWay) {
    const mesh::QuadMesh mesh = samples::scrambled(samples::sphere(5), 20, 7);
    const mesh::Kernel &kernel = mesh.kernel();
    using Halfedge = mesh::Kernel::HalfedgeHandle;
    for (const int first : label(mesh).first) {
        const Chord chord = trace(mesh, first);
        for (std::size_t i = 0; i < chord.length(); ++i) {
            const int side = chord.sides[i], next = chord.sides[(i + 1) % chord.sides.size()];
            EXPECT_EQ(kernel.face_handle(Halfedge(side)).idx(), chord.faces[i]);
            EXPECT_EQ(kernel.face_handle(Halfedge(next ^ 1)).idx(), chord.faces[i]);
            const int start = kernel.to_vertex_handle(Halfedge(side ^ 1)).idx();
            EXPECT_GE(mesh.find_edge(start, kernel.to_vertex_handle(Halfedge(next ^ 1)).idx()), 0);
        }
    }
}

TEST(Trace, AnOpenChordIsTheSameFromEachOfItsEdges) {
    const mesh::QuadMesh mesh = samples::grid(4, 3);
    const Chord chord = trace(mesh, mesh.find_edge(1, 2)); // up a column
    EXPECT_FALSE(chord.closed);
    EXPECT_EQ(chord.faces, (std::vector{1, 5, 9}));
    EXPECT_EQ(chord.crossings, 0);
    EXPECT_EQ(chord.touches, 0);
    for (const int side : chord.sides)
        EXPECT_EQ(trace(mesh, side / 2).sides, chord.sides);
}

TEST(Trace, AClosedChordBeginsWithItsEdge) {
    const mesh::QuadMesh mesh = samples::sphere(3);
    const Labels labels = label(mesh);
    EXPECT_EQ(labels.first.size(), 9U);
    for (int edge = 0; edge < mesh.n_edges(); ++edge) {
        const Chord chord = trace(mesh, edge);
        EXPECT_TRUE(chord.closed);
        EXPECT_EQ(chord.length(), 12U);
        EXPECT_EQ(chord.sides.front() / 2, edge);
    }
}

TEST(Trace, CountsFacesPassedTwiceAndVerticesTouchedTwice) {
    int crossings = 0, touches = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const mesh::QuadMesh mesh = samples::scrambled(samples::grid(10, 10, 3), 40, seed);
        for (const int first : label(mesh).first) {
            const Chord chord = trace(mesh, first);
            std::map<int, int> faces, vertices;
            for (const int face : chord.faces)
                ++faces[face];
            for (const int side : chord.sides)
                for (const int v : mesh.edge_vertices(side / 2))
                    ++vertices[v];
            const auto twice = [](const auto &counts) {
                return std::count_if(counts.begin(), counts.end(),
                                     [](const auto &c) { return c.second > 1; });
            };
            EXPECT_EQ(chord.crossings, twice(faces));
            EXPECT_EQ(chord.touches, twice(vertices));
            crossings += chord.crossings;
            touches += chord.touches;
        }
    }
    EXPECT_GT(crossings, 0);
    EXPECT_GT(touches, 0);
}

} // namespace
} // namespace alphamst::chord
