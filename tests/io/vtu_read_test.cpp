#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;
using samples::failure_of;

std::string head(const std::string &more = "") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
           "byte_order=\"LittleEndian\"" +
           more + "><UnstructuredGrid>\n";
}

std::string words(const std::string &type, const std::string &name, const std::string &numbers,
                  const std::string &more = "") {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\"" + more + ">" + numbers +
           "</DataArray>\n";
}

const std::string tail = "</Piece></UnstructuredGrid></VTKFile>\n";
const std::string piece = "<Piece NumberOfPoints=\"6\" NumberOfCells=\"5\">";
const std::string points =
    "<Points>" +
    words("Float32", "Points", "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0", " NumberOfComponents=\"3\"") +
    "</Points>\n";
const std::string cells = "<Cells>" + words("Int64", "connectivity", "0 0 1 2 3 0 1 1 4 5 1 4 2 5") +
                          words("Int32", "offsets", "1 5 7 10 14") + words("UInt8", "types", "1 9 3 4 8") +
                          "</Cells>\n";
const std::vector<std::int32_t> two_faces{0, 1, 2, 3, 1, 4, 5, 2};

TEST(VtuRead, ReadsWords) {
    const std::string data =
        "<PointData Scalars=\"t\">" +
        words("Float64", "t", "1 2 3 4 5 6<InformationKey><Value>7</Value></InformationKey>") +
        words("Int32", "i", "1 2 3 4 5 6") + "</PointData><CellData>" +
        words("Int32", "marker", "9 1 2 3 4") +
        words("Float32", "u", "0 0 1 2 nan nan 0 0 3 4", " NumberOfComponents=\"2\"") + "</CellData>\n";
    const Arrays mesh = parse_vtu(head() + piece + data + points + cells + tail);
    EXPECT_EQ(mesh.faces, two_faces);
    EXPECT_EQ(mesh.dim, 2);
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{1, 4}));
    using Edges = std::vector<std::array<std::int32_t, 3>>;
    EXPECT_EQ(edges_of(mesh), (Edges{{0, 1, 2}, {1, 4, 3}, {4, 5, 3}}));
    ASSERT_EQ(mesh.marked_points.size(), 1u);
    EXPECT_EQ(mesh.fields.find(Entity::face, "u")->values, (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "t")->carry, mesh::Carry::linear);
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "i")->carry, mesh::Carry::inherit);
}

TEST(VtuRead, ReadsAppendedBase64) {
    std::string offsets;
    const auto array = [&](const char *type, const char *name, std::size_t at) {
        return std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
               "\" format=\"appended\" offset=\"" + std::to_string(at) + "\"/>";
    };
    // One face: 0 1 2 3, which ends at 4 and is of type 9; each array has a length of four bytes.
    const std::string text = head() + "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>" +
                             words("Int8", "p", "0 0 0 1 0 0 1 1 0 0 1 0") + "</Points><Cells>" +
                             array("UInt8", "connectivity", 0) + array("UInt8", "offsets", 12) +
                             array("UInt8", "types", 20) +
                             "</Cells></Piece></UnstructuredGrid><AppendedData encoding=\"base64\">\n  "
                             "_BAAAAAABAgM=AQAAAAQ=AQAAAAk=</AppendedData></VTKFile>";
    EXPECT_EQ(parse_vtu(text).faces, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

// Found by fuzzing: the end of a section in an array was taken for that of the section around it.
TEST(VtuRead, PassesOverElementsInArrays) {
    const std::string array = "<Array type=\"Int32\" Name=\"i\" format=\"ascii\">1 2 3 4 5 6"
                              "<PointData><DataArray/></PointData></Array>";
    const Arrays mesh =
        parse_vtu(head() + piece + "<PointData>" + array + words("Int32", "k", "6 5 4 3 2 1") +
                  "</PointData>" + points + cells + tail);
    EXPECT_EQ(mesh.faces, two_faces);
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "i")->values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "k")->values, (std::vector<double>{6, 5, 4, 3, 2, 1}));
}

TEST(VtuRead, RefusesWhatItDoesNotRead) {
    const auto text_of = [&](const std::string &file) { return failure_of([&] { parse_vtu(file); }); };
    const Failure pieces = text_of(head() + piece + points + cells + "</Piece>\n" + piece + tail);
    EXPECT_EQ(pieces.fault, Fault::unsupported);
    EXPECT_NE(pieces.text.find("several pieces"), std::string::npos);
    EXPECT_EQ(text_of("<VTKFile type=\"PolyData\"/>").fault, Fault::unsupported);
    EXPECT_EQ(text_of(head(" compressor=\"vtkLZ4DataCompressor\"") + piece + tail).fault, Fault::unsupported);
    const Arrays mesh = parse_vtu(head() + piece +
                                  "<CellData><Array type=\"String\" Name=\"s\" format=\"ascii\">1 "
                                  "0</Array></CellData>" +
                                  points + cells + tail);
    EXPECT_EQ(mesh.remarks, std::vector<std::string>{"data that are no numbers are left out: 's'"});
    EXPECT_TRUE(mesh.fields.empty());
}

TEST(VtuRead, RejectsWhatIsMalformed) {
    const std::string good = head() + piece + points + cells + tail;
    EXPECT_EQ(parse_vtu(good).faces, two_faces);
    const auto with = [&](const std::string &from, const std::string &to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    for (const std::string &text :
         {std::string(), std::string("no XML"), std::string("<a/>"), head() + "</UnstructuredGrid></VTKFile>",
          head() + piece + tail, head() + piece + points + tail, with("\"6\"", "\"7\""),
          with("NumberOfCells=\"5\"", "NumberOfCells=\"-5\""), with("\"5\"", "\"five\""),
          with("1 5 7", "1 7 5"), with("1 9 3 4 8", "1 9 3 4"), with("ascii", "hex"), with("</Piece>", ""),
          with("2 5<", "2 x<"), with("ascii", "appended"),
          with("<VTKFile", "<!DOCTYPE a [<!ENTITY b \"c\">]><VTKFile")})
        EXPECT_EQ(failure_of([&] { parse_vtu(text); }).fault, Fault::format) << text;
    const Failure far = failure_of([&] { parse_vtu(with("1 4 2 5", "1 4 2 6")); });
    EXPECT_EQ(far.fault, Fault::range);
    EXPECT_EQ(far.text.substr(0, far.text.find(':')),
              "byte " + std::to_string(good.find("0 0 1 2 3 0 1 1 4")));
    EXPECT_EQ(failure_of([&] { parse_vtu(with("1 9 3 4 8", "1 9 3 4 10")); }).fault, Fault::not_quad);
    EXPECT_EQ(failure_of([&] { parse_vtu(with("\"6\"", "\"6000000000\"")); }).fault, Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
