#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;
using samples::failure_of;

const std::string nodes =
    "*HEADING\nsome, words\n*Node, NSET=all\n10, 0., 0., 0.\n 3, 1.0, 0.0\n900, 1, 1, 0\n4, 0, 1\n"
    "5, 2., 0.\n6, 2., 1.\n";
const std::string faces =
    "** a comment\n*ELEMENT, type=CPS4R, elset=Fluid\n1, 10, 3, 900, 4\n*Element, TYPE=S4\n"
    "7, 3, 5,\n6, 900\n";

TEST(Inp, ReadsNodesAndElements) {
    const Arrays mesh = parse_inp(nodes + faces + "*MATERIAL, NAME=steel\n1, 2, 3\n*STEP\n*END STEP\n");
    EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}));
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(mesh.dim, 2);
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{2, 0})); // the second set
    EXPECT_EQ(mesh.names.at({Entity::face, 2}), "Fluid");
}

TEST(Inp, LinesAndTriangles) {
    const Arrays mesh =
        parse_inp(nodes + "*ELEMENT, TYPE=T3D2, ELSET=low\n20, 10, 3\n*ELEMENT, TYPE=CPS3\n1, 10, 3, 4\n");
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 3, -1}));
    EXPECT_EQ(mesh.names.at({Entity::edge, 2}), "low");
    EXPECT_EQ(edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}}));
    EXPECT_EQ(mesh.remarks,
              std::vector<std::string>{"sets of nodes that are no part of the boundary are left out: 'all'"});
}

TEST(Inp, RejectsWhatIsMalformed) {
    for (const std::string &text :
         {std::string(), nodes, nodes + "*ELEMENT\n1, 10, 3, 900, 4\n",
          nodes + "*ELEMENT, TYPE=S4\n1, 10, 3, 900\n", nodes + "*ELEMENT, TYPE=S4\n1, 10, 3, 900, x\n",
          nodes + "10, 0, 0\n" + faces, nodes + faces + "1, 10, 3, 900, 4\n", std::string("*NODE\n1, x, 0\n"),
          std::string("*NODE\n1, 0\n"), nodes + faces + "*\n", nodes + faces + "*NSET\n1\n",
          nodes + faces + "*NSET, NSET=a, GENERATE\n1\n",
          nodes + faces + "*NSET, NSET=a, GENERATE\n1, 2, 0\n", nodes + faces + "*SURFACE, NAME=a\n1, S7\n"})
        EXPECT_EQ(failure_of([&] { parse_inp(text); }).fault, Fault::format) << text;
    EXPECT_EQ(failure_of([&] { parse_inp(nodes + "*ELEMENT, TYPE=C3D8\n"); }).fault, Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_inp(nodes + "*ELEMENT, TYPE=S8R\n"); }).fault, Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_inp(nodes + "*NGEN\n"); }).fault, Fault::unsupported);
    EXPECT_EQ(failure_of([&] { parse_inp(nodes + faces + nodes); }).fault, Fault::unsupported);
    const Failure far = failure_of([&] { parse_inp(nodes + "*ELEMENT, TYPE=S4\n1, 10, 3, 900, 77\n"); });
    EXPECT_EQ(far.fault, Fault::range);
    EXPECT_EQ(far.text, "line 11: element 1 has node 77, which is not in the file");
}

TEST(Inp, IsOnlyRead) {
    EXPECT_EQ(failure_of([] { write("mesh.inp", samples::grid(1, 2)); }).fault, Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
