// Damaged files of every format: each is read to a mesh in order or to a failure,
// never to a crash (run under sanitizers, this says more).
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <random>

#include "io/checkpoint.h"
#include "io/fields.h"
#include "io/formats.h"
#include "io/markers.h"
#include "samples.h"

namespace {

std::atomic<long> live_bytes{0}, peak_bytes{0};

void *counted(void *p) {
    if (p == nullptr)
        throw std::bad_alloc();
    const long now = live_bytes += static_cast<long>(malloc_usable_size(p));
    if (now > peak_bytes)
        peak_bytes = now;
    return p;
}

void release(void *p) noexcept {
    live_bytes -= static_cast<long>(malloc_usable_size(p));
    std::free(p);
}

} // namespace

// Not inline: g++ 12 would take malloc and delete for a mismatch.
[[gnu::noinline]] void *operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }
// Who asks this way can do without, as std::stable_sort.
[[gnu::noinline]] void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    try {
        return operator new(size);
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}
[[gnu::noinline]] void operator delete(void *p) noexcept { release(p); }
[[gnu::noinline]] void operator delete(void *p, std::size_t) noexcept { release(p); }

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

// n x n squares with markers, names and fields.
Arrays full(int n) {
    Arrays mesh = samples::grid(n, 3);
    const std::size_t n_faces = mesh.faces.size() / 4;
    for (std::size_t f = 0; f < n_faces; ++f)
        mesh.face_marker.push_back(static_cast<std::int32_t>(f % 4) + 1);
    mesh.marked_edges = {{{0, 1}, 3}, {{1, 2}, 5}};
    mesh.marked_points = {{4, 6}};
    mesh.names = {{{Entity::edge, 3}, "low"}, {{Entity::face, 4}, "a region"}};
    add_new_field(mesh, Entity::vertex, "t", 1, false, std::vector<double>(mesh.points.size() / 3, 1));
    add_new_field(mesh, Entity::face, "a label", 2, true, std::vector<double>(2 * n_faces, 3));
    return mesh;
}

Arrays parse_amst(std::string_view bytes) {
    const Checkpoint found = parse_checkpoint(bytes);
    Arrays mesh;
    for (int v = 0; v < found.mesh->n_vertices(); ++v)
        mesh.points.insert(mesh.points.end(), found.mesh->point(v).data(), found.mesh->point(v).data() + 3);
    for (const std::array<int, 4> &face : found.mesh->faces())
        mesh.faces.insert(mesh.faces.end(), face.begin(), face.end());
    mesh.face_marker = found.mesh->face_marker;
    mesh.names = found.mesh->names;
    mesh.fields = found.mesh->fields;
    return mesh;
}

std::string print_amst(const Arrays &arrays) {
    mesh::QuadMesh mesh = mesh::QuadMesh::build(arrays.dim, arrays.points, arrays.faces);
    mesh.face_marker = arrays.face_marker;
    mesh.names = arrays.names;
    mesh.fields = arrays.fields;
    return print_checkpoint(mesh, {});
}

// What is written of one mesh.
std::vector<Sample> written(const Arrays &mesh) {
    return {{"off", parse_off, print_off(mesh)},           {"obj", parse_obj, print_obj(mesh)},
            {"ply", parse_ply, print_ply(mesh)},           {"msh 2", parse_msh, print_msh(mesh)},
            {"vtk", parse_vtk, print_vtk(mesh)},           {"vtu", parse_vtu, print_vtu(mesh)},
            {"su2 written", parse_su2, print_su2(mesh)},   {"amst", parse_amst, print_amst(mesh)},
            {"msh 4 written", parse_msh, print_msh4(mesh)}};
}

std::vector<Sample> all_samples() {
    std::vector<Sample> all = written(full(2));
    const std::string vtk_points = " UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n";
    const std::vector<Sample> others{
        {"inp", parse_inp,
         "*NODE, NSET=n\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n*ELEMENT, TYPE=S4, ELSET=e\n1, 1, 2, 3, 4\n"
         "*NSET, NSET=g, GENERATE\n1, 2, 1\n*ELSET, ELSET=f\ne, 1\n*SURFACE, NAME=s\nf, S1\n1, E2\n"},
        {"msh 2 binary", parse_msh,
         "$MeshFormat\n2.2 1 8\n" + raw({1}) + "\n$EndMeshFormat\n$Nodes\n4\n" + raw({1, 0, 0, 0, 0, 0, 0}) +
             raw({2, 0x3ff00000, 0, 0, 0, 0, 0}) + raw({3, 0x3ff00000, 0, 0x3ff00000, 0, 0, 0}) +
             raw({4, 0, 0, 0x3ff00000, 0, 0, 0}) + "\n$EndNodes\n$Elements\n2\n" +
             raw({1, 1, 2, 1, 5, 1, 1, 2, 3, 1, 2, 2, 7, 1, 1, 2, 3, 4}) + "\n$EndElements\n"},
        {"msh 4 binary", parse_msh,
         "$MeshFormat\n4.1 1 8\n" + raw({1}) + "\n$EndMeshFormat\n$Entities\n" +
             raw({0, 0, 0, 0, 0, 1, 0, 0}) + raw({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 9, 0, 0}) +
             "\n$EndEntities\n$Nodes\n" +
             raw({0, 1, 0, 4, 0, 1, 0, 4, 2, 1, 0, 0, 4, 0, 1, 0, 2, 0, 3, 0, 4}) +
             raw({0,          0, 0,          0, 0, 0, 0x3ff00000, 0, 0,          0, 0, 0,
                  0x3ff00000, 0, 0x3ff00000, 0, 0, 0, 0,          0, 0x3ff00000, 0, 0, 0}) +
             "\n$EndNodes\n$Elements\n" +
             raw({0, 1, 0, 1, 0, 1, 0, 1, 2, 1, 3, 0, 1, 0, 1, 0, 1, 0, 2, 0, 3, 0, 4}) + "\n$EndElements\n"},
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
    all.insert(all.end(), others.begin(), others.end());
    return all;
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
    for (const auto &field : mesh.fields) {
        mesh::require_sound(*field);
        const std::size_t n = field->entity == Entity::face ? mesh.faces.size() / 4 : mesh.points.size() / 3;
        EXPECT_EQ(field->values.size(), n * static_cast<std::size_t>(field->components));
    }
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

// Of good files as of those that promise more than they have.
TEST(Fuzz, MemoryStaysBelowTenTimesTheFile) {
    constexpr long constant = 1 << 17; // sentences, and what the streams of a parser begin with
    for (const Sample &sample : written(full(40))) {
        const auto most_of = [&](const std::string &bytes) {
            const long before = live_bytes;
            peak_bytes = before;
            survives(sample, bytes);
            return peak_bytes - before;
        };
        const auto most = static_cast<long>(10 * sample.bytes.size()) + constant;
        EXPECT_LT(most_of(sample.bytes), most) << sample.name;
        for (const char *const longer :
             {"1681", "1600", "1603", "8406"}) { // numbers of vertices, faces, cells
            std::string bytes = sample.bytes;
            if (const std::size_t place = bytes.find(longer); place != std::string::npos) {
                EXPECT_LT(most_of(bytes.replace(place, 4, "1999999999")), most) << sample.name << longer;
            }
        }
        std::string half = sample.bytes.substr(0, sample.bytes.size() / 2);
        EXPECT_LT(most_of(half), most) << sample.name;
    }
}

} // namespace
} // namespace alphamst::io
