#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;
using samples::failure_of;

std::string head(const std::string &encoding, const std::string &set, const std::string &version = "3.0") {
    return "# vtk DataFile Version " + version + "\ntitle CELLS 9 9\n" + encoding + "\nDATASET " + set + "\n";
}

const std::string points = "POINTS 6 float\n0 0 0 1 0 0\n1 1 0\n0 1 0 2 0 0 2 1 0\n";
const std::vector<std::int32_t> two_faces{0, 1, 2, 3, 1, 4, 5, 2};

// Big-endian, as legacy VTK is.
template <class Number> std::string big(std::initializer_list<Number> numbers) {
    std::string text;
    for (Number number : numbers) {
        char bytes[sizeof(Number)];
        std::memcpy(bytes, &number, sizeof(Number));
        if (std::endian::native == std::endian::little)
            std::reverse(bytes, bytes + sizeof(Number));
        text.append(bytes, sizeof(Number));
    }
    return text;
}

const std::string binary_points =
    "POINTS 6 double\n" + big<double>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}) + "\n";

TEST(VtkRead, ReadsUnstructuredGrids) {
    // A vertex and a line are passed over, a pixel is a quadrilateral with another order.
    const std::string text = head("ASCII", "UNSTRUCTURED_GRID") +
                             "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + points +
                             "CELLS 4 15\n1 0 2 0 1\n4 0 1 2 3 4 1 4 2 5\nCELL_TYPES 4\n1 3 9 8\n"
                             "CELL_DATA 4\nSCALARS s int 1\nLOOKUP_TABLE default\n1 2 3 4\n";
    const Arrays mesh = parse_vtk(text);
    EXPECT_EQ(mesh.points.size(), 18u);
    EXPECT_EQ(mesh.faces, two_faces);
    EXPECT_EQ(mesh.dim, 2);
}

TEST(VtkRead, ReadsVersion51) {
    const std::string grid = head("ASCII", "UNSTRUCTURED_GRID", "5.1") + points +
                             "METADATA\nINFORMATION 0\n\nCELLS 3 8\nOFFSETS vtktypeint64\n0 4 8\n"
                             "CONNECTIVITY vtktypeint64\n0 1 2 3 1 4 5 2\nCELL_TYPES 2\n9\n7\n";
    EXPECT_EQ(parse_vtk(grid).faces, two_faces);
    const std::string polygons =
        head("ASCII", "POLYDATA", "5.1") + points +
        "VERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n0\n"
        "POLYGONS 3 8\nOFFSETS vtktypeint64\n0 4 8\nCONNECTIVITY vtktypeint64\n0 1 2 3 1 4 5 2\n";
    EXPECT_EQ(parse_vtk(polygons).faces, two_faces);
}

TEST(VtkRead, ReadsPolyData) {
    EXPECT_EQ(parse_vtk(head("ASCII", "POLYDATA") + points +
                        "LINES 1 3\n2 0 1\nPOLYGONS 2 10\n4 0 1 2 3\n4 1 4 5 2\n")
                  .faces,
              two_faces);
}

TEST(VtkRead, ReadsBinary) {
    const std::string old = head("BINARY", "UNSTRUCTURED_GRID") + binary_points + "CELLS 2 10\n" +
                            big<std::int32_t>({4, 0, 1, 2, 3, 4, 1, 4, 5, 2}) + "\nCELL_TYPES 2\n" +
                            big<std::int32_t>({9, 9}) + "\n";
    const std::string version51 = head("BINARY", "POLYDATA", "5.1") + binary_points +
                                  "METADATA\nINFORMATION 0\n\nPOLYGONS 3 8\nOFFSETS vtktypeint64\n" +
                                  big<std::int64_t>({0, 4, 8}) + "\nCONNECTIVITY vtktypeint32\n" +
                                  big<std::int32_t>({0, 1, 2, 3, 1, 4, 5, 2}) + "\n";
    for (const std::string &text : {old, version51}) {
        const Arrays mesh = parse_vtk(text);
        EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}));
        EXPECT_EQ(mesh.faces, two_faces);
    }
    const std::size_t whole = old.size() - 1; // the last line end may be missing
    for (std::size_t n = old.find("POINTS"); n < whole; ++n)
        EXPECT_EQ(failure_of([&] { parse_vtk(std::string_view(old).substr(0, n)); }).fault, Fault::format)
            << n;
}

// A vertex, a line, a poly-line and two faces, and what comes behind them.
std::string marked_grid(const std::string &attributes) {
    return head("ASCII", "UNSTRUCTURED_GRID") + points +
           "CELLS 5 19\n1 0\n4 0 1 2 3\n2 0 1\n3 1 4 5\n4 1 4 5 2\nCELL_TYPES 5\n1 9 3 4 9\n" + attributes;
}

TEST(VtkRead, FindsTheMarkersAmongOtherAttributes) {
    using Edges = std::vector<std::array<std::int32_t, 3>>;
    const std::string marker = "SCALARS marker int 1\nLOOKUP_TABLE default\n9 1 2 3 4\n";
    const std::string field =
        "FIELD FieldData 2\nother 2 5 float\n1 2 3 4 5 6 7 8 9 10\nMETADATA\nINFORMATION "
        "0\n\nmarker 1 5 vtktypeint64\n9 1 2 3 4\n";
    const std::string before = "POINT_DATA 6\nSCALARS marker int\nLOOKUP_TABLE default\n7 7 7 7 7 7\n"
                               "VECTORS v double\n1 1 1 2 2 2 3 3 3 4 4 4 5 5 5 6 6 6\nCELL_DATA 5\n";
    for (const std::string &text :
         {"CELL_DATA 5\n" + marker, before + marker, before + field,
          "cell_data 5\n" + field + "POINT_DATA 6\n",
          std::string("CELL_DATA 5\nSCALARS marker short\n9 1 2 3 4\n"),
          before + marker + "COLOR_SCALARS c 1 and so on",
          "CELL_DATA 5\nNORMALS n float\n1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\nGLOBAL_IDS g int\n1 2 3 4 5\n" +
              marker}) {
        const Arrays mesh = parse_vtk(marked_grid(text));
        EXPECT_EQ(mesh.faces, two_faces) << text;
        EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 4})) << text;
        EXPECT_EQ(edges_of(mesh), (Edges{{0, 1, 2}, {1, 4, 3}, {4, 5, 3}})) << text;
    }
}

TEST(VtkRead, PassesOverOtherAttributes) {
    for (const char *text :
         {"CELL_DATA 5\n", "CELL_DATA 5\nSCALARS marker float 1\nLOOKUP_TABLE default\n1 1 1 1 1\n",
          "CELL_DATA 5\nSCALARS marker int 2\nLOOKUP_TABLE default\n1 1 1 1 1 1 1 1 1 1\n",
          "CELL_DATA 5\nSCALARS marker string 1\nfive words are not read\n",
          "CELL_DATA 5\nFIELD f 1\nmarker 1 5 string\nwords\n",
          "CELL_DATA 5\nSCALARS marker int 1\nLOOKUP_TABLE default\n9 0 0 0 0\n",
          "POINT_DATA 6\nSCALARS marker int 1\nLOOKUP_TABLE default\n1 1 1 1 1 1\n"}) {
        const Arrays mesh = parse_vtk(marked_grid(text));
        EXPECT_EQ(mesh.faces, two_faces) << text;
        EXPECT_TRUE(mesh.face_marker.empty() && mesh.marked_edges.empty()) << text;
    }
}

TEST(VtkRead, ReadsMarkersOfPolyDataAndOfBinary) {
    using Edges = std::vector<std::array<std::int32_t, 3>>;
    const std::string data = "CELL_DATA 5\nSCALARS marker int 1\nLOOKUP_TABLE default\n";
    // Whatever comes first in the file: vertices, lines, faces.
    const Arrays polygons = parse_vtk(head("ASCII", "POLYDATA") + points +
                                      "POLYGONS 2 10\n4 0 1 2 3\n4 1 4 5 2\nLINES 2 7\n2 0 1\n3 1 4 5\n"
                                      "VERTICES 1 2\n1 0\n" +
                                      data + "9 1 2 3 4\n");
    EXPECT_EQ(polygons.face_marker, (std::vector<std::int32_t>{3, 4}));
    EXPECT_EQ(edges_of(polygons), (Edges{{0, 1, 1}, {1, 4, 2}, {4, 5, 2}}));
    const std::string grid = head("BINARY", "UNSTRUCTURED_GRID") + binary_points + "CELLS 3 13\n" +
                             big<std::int32_t>({4, 0, 1, 2, 3, 2, 0, 1, 4, 1, 4, 5, 2}) + "\nCELL_TYPES 3\n" +
                             big<std::int32_t>({9, 3, 9}) +
                             "\nPOINT_DATA 6\nSCALARS c unsigned_char 1\nLOOKUP_TABLE default\nLOOKUP\n"
                             "CELL_DATA 3\nFIELD FieldData 1\nmarker 1 3 short\n" +
                             big<std::int16_t>({-2, 7, 300}) + "\n";
    const Arrays binary = parse_vtk(grid);
    EXPECT_EQ(binary.face_marker, (std::vector<std::int32_t>{-2, 300}));
    EXPECT_EQ(edges_of(binary), (Edges{{0, 1, 7}}));
}

// What ParaView, meshio, Medit, dolfinx and Gmsh call them.
TEST(VtkRead, KnowsOtherNamesOfMarkers) {
    using Edges = std::vector<std::array<std::int32_t, 3>>;
    for (const char *name :
         {"gmsh:physical", "medit:ref", "cell_tags", "MaterialIds", "RegionId", "CellEntityIds"}) {
        const Arrays mesh = parse_vtk(
            marked_grid("CELL_DATA 5\nFIELD FieldData 1\n" + std::string(name) + " 1 5 long\n9 1 2 3 4\n"));
        const bool of_gmsh = std::string(name) == "CellEntityIds"; // tags of entities, not of groups
        EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 4})) << name;
        EXPECT_EQ(edges_of(mesh), (Edges{{0, 1, 2}, {1, 4, 3}, {4, 5, 3}})) << name;
        EXPECT_EQ(mesh.marked_points.size(), of_gmsh ? 0U : 1U) << name;
        EXPECT_EQ(mesh.curve_numbers, of_gmsh) << name;
        EXPECT_TRUE(mesh.remarks.empty()) << name;
    }
    const std::string physical = "gmsh:physical 1 5 int\n9 1 2 3 4\n", marker = "marker 1 5 int\n0 5 0 0 5\n";
    for (const std::string &fields : {physical + marker, marker + physical}) {
        const Arrays mesh = parse_vtk(marked_grid("CELL_DATA 5\nFIELD FieldData 2\n" + fields));
        EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{5, 5}));
        EXPECT_TRUE(mesh.marked_edges.empty() && mesh.marked_points.empty());
        EXPECT_EQ(mesh.remarks.size(), 1U);
    }
}

TEST(VtkRead, VertexCellsAreMarkedPoints) {
    const Arrays grid = parse_vtk(head("ASCII", "UNSTRUCTURED_GRID") + points +
                                  "CELLS 4 15\n1 0\n4 0 1 2 3\n2 1 5\n4 1 4 5 2\nCELL_TYPES 4\n1 9 2 9\n"
                                  "CELL_DATA 4\nSCALARS marker int 1\nLOOKUP_TABLE default\n8 0 -3 0\n");
    const Arrays polygons = parse_vtk(head("ASCII", "POLYDATA") + points +
                                      "POLYGONS 2 10\n4 0 1 2 3\n4 1 4 5 2\nVERTICES 2 5\n1 0\n2 1 5\n"
                                      "CELL_DATA 4\nSCALARS marker int 1\nLOOKUP_TABLE default\n8 -3 0 0\n");
    for (const Arrays *mesh : {&grid, &polygons}) {
        ASSERT_EQ(mesh->marked_points.size(), 3U);
        const std::array<std::array<std::int32_t, 2>, 3> wanted{{{0, 8}, {1, -3}, {5, -3}}};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(mesh->marked_points[i].vertex, wanted[i][0]);
            EXPECT_EQ(mesh->marked_points[i].marker, wanted[i][1]);
        }
    }
}

TEST(VtkRead, RejectsMarkersThatDoNotFit) {
    const std::string array = "SCALARS marker vtktypeint64 1\nLOOKUP_TABLE default\n";
    for (const std::string &text :
         {"CELL_DATA 4\n" + array + "1 2 3 4\n", "CELL_DATA 5\n" + array + "1 2 3 4\n",
          "CELL_DATA 5\n" + array + "1 2 3 4 x\n", "CELL_DATA -5\n" + array + "1 2 3 4 5\n",
          std::string("CELL_DATA 9000000000000000000\nTENSORS t float\n1\n"),
          std::string("CELL_DATA 5\nFIELD f 1\nmarker 1 4 int\n1 2 3 4\n")})
        EXPECT_EQ(failure_of([&] { parse_vtk(marked_grid(text)); }).fault, Fault::format) << text;
    EXPECT_EQ(
        failure_of([&] { parse_vtk(marked_grid("CELL_DATA 5\n" + array + "0 0 0 0 2147483648\n")); }).fault,
        Fault::unsupported);
    std::string outside = marked_grid("CELL_DATA 5\n" + array + "1 2 3 4 5\n");
    outside.replace(outside.find("3 1 4 5"), 7, "3 1 6 5");
    EXPECT_EQ(failure_of([&] { parse_vtk(outside); }).fault, Fault::range);
}

TEST(VtkRead, ReadsTriangles) {
    const std::vector<std::int32_t> faces{0, 1, 2, 3, 0, 1, 2, -1};
    for (const char *type : {"5", "7"})
        EXPECT_EQ(parse_vtk(head("ASCII", "UNSTRUCTURED_GRID") + points +
                            "CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n9 " + type + "\n")
                      .faces,
                  faces);
    EXPECT_EQ(parse_vtk(head("ASCII", "POLYDATA") + points + "POLYGONS 2 9\n4 0 1 2 3\n3 0 1 2\n").faces,
              faces);
    // A quad of three corners, a triangle of four
    for (const char *cells :
         {"CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n9\n", "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n"})
        EXPECT_EQ(failure_of([&] { parse_vtk(head("ASCII", "UNSTRUCTURED_GRID") + points + cells); }).fault,
                  Fault::format)
            << cells;
}

TEST(VtkRead, RejectsOtherCells) {
    const std::string grid = head("ASCII", "UNSTRUCTURED_GRID") + points;
    for (const char *cells : {"CELLS 2 11\n4 0 1 2 3\n5 0 1 2 3 1\nCELL_TYPES 2\n9 7\n",
                              "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 2\n9 10\n"}) {
        const Failure failure = failure_of([&] { parse_vtk(grid + cells); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << cells;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << cells;
    }
    const std::string polygons = head("ASCII", "POLYDATA") + points;
    EXPECT_EQ(failure_of([&] { parse_vtk(polygons + "TRIANGLE_STRIPS 1 4\n3 0 1 2\n"); }).fault,
              Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_vtk(polygons + "POLYGONS 1 5\n4 0 1 2 6\n"); }).fault, Fault::range);
}

TEST(VtkRead, RejectsWhatIsMalformed) {
    const std::string grid = head("ASCII", "UNSTRUCTURED_GRID") + points;
    for (const std::string &text :
         {std::string(), std::string("# vtk DataFile\nx\nTEXT\n"), head("ASCII", "UNSTRUCTURED_GRID"),
          grid + "CELLS 1 5\n4 0 1 2 3\n", grid + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n9 9\n",
          grid + "POLYGONS 0 0\n", grid + "CELLS 1 4\n4 0 1 2 3\nCELL_TYPES 1\n9\n",
          grid + "CELLS 1 6\n4 0 1 2 3 3\nCELL_TYPES 1\n9\n",
          grid + "CELLS 1 5\n-4 0 1 2 3\nCELL_TYPES 1\n9\n",
          grid + "CELLS 2 4\nOFFSETS int\n0 5\nCONNECTIVITY int\n0 1 2 3\nCELL_TYPES 1\n9\n",
          grid + "CELLS 3 4\nOFFSETS int\n0 9 4\nCONNECTIVITY int\n0 1 2 3\nCELL_TYPES 2\n9 9\n",
          grid + points, head("ASCII", "POLYDATA") + "POINTS 100000000000 float\n0 0 0\n",
          head("ASCII", "POLYDATA") + "FIELD f 1\na 2000000000 2000000000 int\n1\n"})
        EXPECT_EQ(failure_of([&] { parse_vtk(text); }).fault, Fault::format) << text;
    EXPECT_EQ(failure_of([] { parse_vtk(head("ASCII", "STRUCTURED_GRID")); }).fault, Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
