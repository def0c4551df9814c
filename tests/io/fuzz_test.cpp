// Damaged files of every format: each is read to a mesh in order or to a failure,
// never to a crash (run under sanitizers, this says more).
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/formats.h"
#include "io/markers.h"
#include "samples.h"

namespace alphamst::io {
namespace {

struct Sample {
    const char *name;
    Arrays (*parse)(std::string_view);
    std::string bytes;
};

std::string raw(std::initializer_list<int> numbers) { // big-endian
    std::string text;
    for (int number : numbers)
        for (int shift = 24; shift >= 0; shift -= 8)
            text += static_cast<char>(number >> shift & 255);
    return text;
}

std::vector<Sample> all_samples() {
    Arrays mesh = samples::grid(2, 3);
    mesh.face_marker = {1, 2, 3, 4};
    mesh.marked_edges = {{{0, 1}, 3}, {{1, 2}, 5}};
    mesh.marked_points = {{4, 6}};
    mesh.names = {{{Entity::edge, 3}, "low"}, {{Entity::face, 4}, "a region"}};
    const std::string vtk_points = " UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n";
    return {
        {"off", parse_off, print_off(mesh)},
        {"obj", parse_obj, print_obj(mesh)},
        {"ply", parse_ply, print_ply(mesh)},
        {"msh 2", parse_msh, print_msh(mesh)},
        {"vtk", parse_vtk, print_vtk(mesh)},
        {"su2 written", parse_su2, print_su2(mesh)},
        {"msh 4 in parts", parse_msh,
         "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 0\n1 0 0 0 1 0 0 2 5 6 0\n1 0 0 0 1 1 0 1 "
         "9 0\n$EndEntities\n$PartitionedEntities\n2\n1\n4 1\n0 2 1 0\n2 1 1 1 1 0 0 0 1 0 0 1 7 0\n"
         "3 2 1 2 1 2 1 0 0 1 1 0 0 0\n2 2 1 1 1 0 0 0 1 1 0 0 0\n$EndPartitionedEntities\n"
         "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
         "$Elements\n2 2 1 2\n1 2 1 1\n1 1 2\n2 2 3 1\n2 1 2 3 4\n$EndElements\n"},
        {"binary ply", parse_ply,
         "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty "
         "int z\n"
         "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
             raw({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 4, 0, 1, 2, 3})},
        {"msh 4", parse_msh,
         "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 1 1 0\n1 0 0 0 1 0 0 1 5 0\n1 0 0 0 1 1 0 1 "
         "9 0\n"
         "$EndEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
         "$Elements\n2 2 1 2\n1 1 1 1\n1 1 2\n2 1 3 1\n2 1 2 3 4\n$EndElements\n"},
        {"msh 1", parse_msh,
         "$NOD\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$ENDNOD\n"
         "$ELM\n3\n1 15 0 1 1 1\n2 1 5 1 2 1 2\n3 3 7 1 4 1 2 3 4\n$ENDELM\n"},
        {"su2", parse_su2,
         "% a square\nNDIME= 2\nNELEM= 1\n9 0 1 2 3 0\nNPOIN= 4 4\n0 0 0\n1 0 1\n1 1 2\n0 1 3\n"
         "NMARK= 2\nMARKER_TAG= low\nMARKER_ELEMS= 1\n3 0 1\nMARKER_TAG= other\n"
         "MARKER_ELEMS= 2\n3 1 2 0\n3 2 3\nFFD_CORNER_POINTS= 1\n0.5 0.5\n"},
        {"vtk 5.1", parse_vtk,
         "# vtk DataFile Version 5.1\nx\nASCII\nDATASET" + vtk_points +
             "FIELD f 1\na 1 2 int\n1 2\nCELLS 2 4\nOFFSETS int\n0 4\nCONNECTIVITY int\n0 1 2 "
             "3\nCELL_TYPES 1\n9\nPOINT_DATA 4\nVECTORS v int\n1 1 1 1 1 1 1 1 1 1 1 1\nCELL_DATA "
             "1\nFIELD f 1\n"
             "marker 1 1 int\n7\n"},
        {"binary vtk", parse_vtk,
         "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 int\n" +
             raw({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + "\nCELLS 1 5\n" + raw({4, 0, 1, 2, 3}) +
             "\nCELL_TYPES 1\n" + raw({9})}};
}

// Reads; what comes out must be in order. Returns whether it was read.
bool survives(const Sample &sample, std::string_view bytes) {
    Arrays mesh;
    try {
        mesh = sample.parse(bytes);
    } catch (const Failure &failure) {
        EXPECT_NE(failure.fault, Fault::internal);
        EXPECT_FALSE(failure.text.empty());
        return false;
    }
    EXPECT_EQ(mesh.points.size() % 3, 0u);
    EXPECT_EQ(mesh.faces.size() % 4, 0u);
    EXPECT_TRUE(mesh.face_marker.empty() || mesh.face_marker.size() == mesh.faces.size() / 4);
    EXPECT_LT(mesh.points.size(), bytes.size() + 3);
    for (double x : mesh.points)
        EXPECT_TRUE(std::isfinite(x));
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const std::int32_t v = mesh.faces[i];
        EXPECT_TRUE((v >= 0 && static_cast<std::size_t>(v) < mesh.points.size() / 3) ||
                    (v == -1 && i % 4 == 3));
    }
    for (const Arrays::MarkedEdge &edge : mesh.marked_edges)
        for (std::int32_t v : edge.vertices)
            EXPECT_TRUE(v >= 0 && static_cast<std::size_t>(v) < mesh.points.size() / 3);
    for (const Arrays::MarkedPoint &point : mesh.marked_points)
        EXPECT_TRUE(point.vertex >= 0 && static_cast<std::size_t>(point.vertex) < mesh.points.size() / 3);
    for (const auto &[of, name] : mesh.names)
        EXPECT_TRUE(of.second != 0 && !name.empty() && clean_name(name) == name);
    return true;
}

TEST(Fuzz, SamplesAreSound) {
    for (const Sample &sample : all_samples())
        EXPECT_TRUE(survives(sample, sample.bytes)) << sample.name;
}

TEST(Fuzz, Truncations) {
    for (const Sample &sample : all_samples())
        for (std::size_t n = 0; n < sample.bytes.size(); ++n)
            survives(sample, std::string(sample.bytes, 0, n));
}

TEST(Fuzz, DamagedBytes) {
    std::mt19937 random(20);
    static constexpr std::string_view favourites = "0123456789-+.eE \n\r#$/\\\xff\x7f\x80naif";
    for (const Sample &sample : all_samples())
        for (int round = 0; round < 1500; ++round) {
            std::string bytes = sample.bytes;
            for (unsigned n = 1 + random() % 4; n > 0; --n) {
                const std::size_t at = random() % bytes.size();
                switch (random() % 4) {
                case 0:
                    bytes[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    bytes[at] = favourites[random() % favourites.size()];
                    break;
                case 2:
                    bytes.erase(at, random() % 9);
                    bytes += ' ';
                    break;
                default:
                    bytes.insert(at, random() % 2 == 0 ? "99999999999"
                                                       : bytes.substr(random() % bytes.size(), 12));
                }
            }
            survives(sample, bytes);
        }
}

} // namespace
} // namespace alphamst::io
