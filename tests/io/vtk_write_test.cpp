#include <gtest/gtest.h>

#include "io/fields.h"
#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;

TEST(VtkWrite, FacesComeBeforeMarkedEdges) {
    Arrays mesh;
    mesh.points = {0, 0, 0, 0.1, 0, 0, 0.1, 2, 0, 0, 2, 0};
    mesh.faces = {0, 1, 2, 3};
    const std::string start =
        "# vtk DataFile Version 3.0\nquadrilateral mesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
        "POINTS 4 double\n0 0 0\n0.1 0 0\n0.1 2 0\n0 2 0\n";
    EXPECT_EQ(print_vtk(mesh), start + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n");
    mesh.marked_edges = {{{0, 1}, 7}, {{1, 2}, 0}};
    EXPECT_EQ(print_vtk(mesh), start + "CELLS 2 8\n4 0 1 2 3\n2 0 1\nCELL_TYPES 2\n9\n3\n"
                                       "CELL_DATA 2\nSCALARS marker int 1\nLOOKUP_TABLE default\n0\n7\n");
}

TEST(VtkWrite, MarkersRoundTrip) {
    Arrays mesh = samples::grid(3, 3);
    const std::string plain = print_vtk(mesh);
    EXPECT_EQ(plain.find("CELL_DATA"), std::string::npos);
    mesh.face_marker = {1, 2, 0, -4, 5, 6, 7, 8, 2147483647};
    mesh.marked_edges = {{{0, 1}, 3}, {{1, 2}, -2147483647 - 1}, {{6, 2}, 0}, {{3, 2}, 3}};
    const Arrays back = parse_vtk(print_vtk(mesh));
    EXPECT_TRUE(samples::same_bits(back.points, mesh.points));
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.face_marker, mesh.face_marker);
    using Edges = std::vector<std::array<std::int32_t, 3>>;
    EXPECT_EQ(edges_of(back), (Edges{{0, 1, 3}, {1, 2, -2147483647 - 1}, {3, 2, 3}}));
    mesh.face_marker.clear();
    EXPECT_TRUE(parse_vtk(print_vtk(mesh)).face_marker.empty());
    EXPECT_EQ(edges_of(parse_vtk(print_vtk(mesh))).size(), 3u);
    mesh.marked_edges.clear();
    mesh.face_marker.assign(9, 5);
    EXPECT_EQ(parse_vtk(print_vtk(mesh)).face_marker, mesh.face_marker);
    mesh.face_marker.clear();
    EXPECT_EQ(print_vtk(mesh), plain);
}

// VTK's own reader of text takes nan for a keyword.
TEST(VtkWrite, FieldsOfFacesAreFiniteOnLines) {
    Arrays mesh = samples::grid(1, 2);
    mesh.marked_edges = {{{0, 1}, 3}};
    add_new_field(mesh, Entity::face, "a load", 2, false, {0.5, 2});
    const std::string text = print_vtk(mesh);
    EXPECT_NE(text.find("FIELD FieldData 1\na%20load 2 2 double\n0.5 2\n0 0\n"), std::string::npos) << text;
    EXPECT_EQ(parse_vtk(text).fields.find(Entity::face, "a load")->values, (std::vector<double>{0.5, 2}));
}

} // namespace
} // namespace alphamst::io
