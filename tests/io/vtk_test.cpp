#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

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

TEST(Vtk, ReadsUnstructuredGrids) {
    // A vertex and a line are passed over, a pixel is a quadrilateral with another order.
    const std::string text = head("ASCII", "UNSTRUCTURED_GRID") +
                             "FIELD FieldData 1\nTIME 1 1 double\n0.5\n" + points +
                             "CELLS 4 15\n1 0 2 0 1\n4 0 1 2 3 4 1 4 2 5\nCELL_TYPES 4\n1 3 9 8\n"
                             "CELL_DATA 4\nSCALARS s int 1\n";
    const Arrays mesh = parse_vtk(text);
    EXPECT_EQ(mesh.points.size(), 18u);
    EXPECT_EQ(mesh.faces, two_faces);
    EXPECT_EQ(mesh.dim, 2);
}

TEST(Vtk, ReadsVersion51) {
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

TEST(Vtk, ReadsPolyData) {
    EXPECT_EQ(parse_vtk(head("ASCII", "POLYDATA") + points +
                        "LINES 1 3\n2 0 1\nPOLYGONS 2 10\n4 0 1 2 3\n4 1 4 5 2\n")
                  .faces,
              two_faces);
}

TEST(Vtk, ReadsBinary) {
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

TEST(Vtk, RejectsOtherCells) {
    const std::string grid = head("ASCII", "UNSTRUCTURED_GRID") + points;
    for (const char *cells : {"CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n9 5\n",
                              "CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n9 7\n",
                              "CELLS 2 10\n4 0 1 2 3\n4 0 1 2 3\nCELL_TYPES 2\n9 10\n"}) {
        const Failure failure = failure_of([&] { parse_vtk(grid + cells); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << cells;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << cells;
    }
    const std::string polygons = head("ASCII", "POLYDATA") + points;
    EXPECT_EQ(failure_of([&] { parse_vtk(polygons + "POLYGONS 1 4\n3 0 1 2\n"); }).fault, Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_vtk(polygons + "TRIANGLE_STRIPS 1 4\n3 0 1 2\n"); }).fault,
              Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_vtk(polygons + "POLYGONS 1 5\n4 0 1 2 6\n"); }).fault, Fault::range);
}

TEST(Vtk, RejectsWhatIsMalformed) {
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
