#include "io/inp_sets.h"

#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;
using Edges = std::vector<std::array<std::int32_t, 3>>;

// Three squares in a row: nodes 1 .. 4 below and 5 .. 8 above, elements 1 .. 3.
Arrays with(const std::string &sets) {
    return parse_inp("*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n4, 3, 0\n5, 0, 1\n6, 1, 1\n7, 2, 1\n8, 3, 1\n"
                     "*ELEMENT, TYPE=CPE4\n1, 1, 2, 6, 5\n2, 2, 3, 7, 6\n3, 3, 4, 8, 7\n" +
                     sets);
}

TEST(InpSets, OfElementsAreRegions) {
    const Arrays mesh =
        with("*ELSET, ELSET=left\n1\n*ELSET, ELSET=Rest, GENERATE\n2, 3, 1\n*elset, elset=LEFT\n2,\n");
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 1, 2}));
    EXPECT_EQ(mesh.names, (Names{{{Entity::face, 1}, "left"}, {{Entity::face, 2}, "Rest"}}));
    EXPECT_EQ(mesh.remarks,
              std::vector<std::string>{
                  "1 faces, edges and vertices are in several sets, of which the first counts"});
}

TEST(InpSets, OfSetsAndWithNumbersThatAreNotThere) {
    const Arrays mesh =
        with("*ELSET, ELSET=all\nodd, part-1.even, nothing\n*ELSET, ELSET=odd, GENERATE\n1, 3, 2\n*ELSET, "
             "ELSET=even\n2, 99, all\n");
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 1, 1}));
    EXPECT_EQ(mesh.names, (Names{{{Entity::face, 1}, "all"}}));
    EXPECT_EQ(mesh.remarks.size(), 2u);
}

TEST(InpSets, SurfacesAreEdges) {
    const Arrays mesh =
        with("*ELSET, ELSET=two\n1, 2\n*SURFACE, NAME=low, TYPE=ELEMENT\ntwo, S1\n3, E1\n*SURFACE, "
             "NAME=right\n3, S2\n*SURFACE, NAME=top\n3, SPOS\n");
    EXPECT_EQ(edges_of(mesh), (Edges{{0, 1, 2}, {1, 2, 2}, {2, 3, 2}, {3, 7, 3}}));
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 1, 4}));
    EXPECT_EQ(mesh.names.at({Entity::edge, 3}), "right");
    EXPECT_EQ(mesh.names.at({Entity::face, 4}), "top");
}

TEST(InpSets, OfNodesAreEdgesOfTheBoundaryOrAPoint) {
    const Arrays mesh =
        with("*NSET, NSET=ends\n1, 5, 4, 8\n*NSET, NSET=well\n6\n*NSET, NSET=inside\n2, 6, 2\n"
             "*SURFACE, NAME=low, TYPE=NODE\n1\n2\n3\n4\n*NSET, NSET=none\n");
    EXPECT_EQ(edges_of(mesh), (Edges{{0, 1, 4}, {0, 4, 1}, {1, 2, 4}, {2, 3, 4}, {3, 7, 1}}));
    ASSERT_EQ(mesh.marked_points.size(), 1u);
    EXPECT_EQ(mesh.marked_points[0].vertex, 5);
    EXPECT_EQ(mesh.remarks, std::vector<std::string>{
                                "sets of nodes that are no part of the boundary are left out: 'inside'"});
    EXPECT_EQ(mesh.names.size(), 3u);
}

TEST(InpSets, RangesOfAnyNumbersTakeNoTime) {
    const Arrays mesh = with("*ELSET, ELSET=all, GENERATE\n-9000000000000000000, 9000000000000000000, 1\n");
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 1, 1}));
}

} // namespace
} // namespace alphamst::io
