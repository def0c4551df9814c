#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

std::string header(const std::string &format, const std::string &vertex_extra = "",
                   const std::string &face_extra = "") {
    return "ply\nformat " + format + " 1.0\ncomment x\nobj_info y\nelement vertex 4\nproperty double x\n" +
           vertex_extra + "property float y\nproperty int z\nelement face 1\n" + face_extra +
           "property list uchar int vertex_indices\nend_header\n";
}

template <class Number> void put(std::string &text, Number value, bool big) {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &value, sizeof(Number));
    if (big != (std::endian::native == std::endian::big))
        std::reverse(bytes, bytes + sizeof(Number));
    text.append(bytes, sizeof(Number));
}

std::string binary(bool big, unsigned char n_corners = 4) {
    std::string text = header(big ? "binary_big_endian" : "binary_little_endian",
                              "property list short uchar more\n", "property ushort colour\n");
    for (int v = 0; v < 4; ++v) {
        put(text, v + 0.1, big);
        put(text, std::int16_t{2}, big);
        text += "\n\r";
        put(text, float(v) * 0.5F, big);
        put(text, std::int32_t{-v}, big);
    }
    put(text, std::uint16_t{0x0a0a}, big);
    put(text, n_corners, big);
    for (std::int32_t v = 0; v < 4; ++v)
        put(text, v, big);
    return text;
}

TEST(Ply, ReadsAscii) {
    const Arrays mesh = parse_ply(header("ascii", "property list uchar float w\n", "property uchar red\n") +
                                  "0.1 2 8 8 0.5 -3\n1 0 0 0\n1 1 9 1 0\n0 0 1 0\n200 4 0 1 2 3\n");
    EXPECT_EQ(mesh.points, (std::vector<double>{0.1, 0.5, -3, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3}));
}

TEST(Ply, ReadsBothByteOrders) {
    for (bool big : {false, true}) {
        const Arrays mesh = parse_ply(binary(big));
        EXPECT_EQ(mesh.points, (std::vector<double>{0.1, 0, 0, 1.1, 0.5, -1, 2.1, 1, -2, 3.1, 1.5, -3}));
        EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3}));
    }
}

TEST(Ply, ReadsFacesBeforeVerticesAndOtherElements) {
    const Arrays mesh =
        parse_ply("ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list int uint vertex_index\r\n"
                  "element edge 1\r\nproperty int a\r\nelement vertex 4\r\nproperty float x\r\n"
                  "property float y\r\nproperty float z\r\nend_header\r\n4 3 2 1 0\r\n7\r\n"
                  "0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n");
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{3, 2, 1, 0}));
    EXPECT_EQ(mesh.dim, 2);
}

TEST(Ply, ReadsTriangles) {
    EXPECT_EQ(parse_ply(binary(true, 3)).faces, (std::vector<std::int32_t>{0, 1, 2, -1}));
    EXPECT_EQ(parse_ply(header("ascii") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n").faces,
              (std::vector<std::int32_t>{0, 1, 2, -1}));
}

TEST(Ply, RejectsOtherFaces) {
    Failure failure = failure_of([] { parse_ply(binary(true, 5)); });
    EXPECT_EQ(failure.fault, Fault::not_quad);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{0});
    EXPECT_EQ(std::string(failure.what()).substr(0, 5), "byte ");
    failure = failure_of([] {
        parse_ply("ply\nformat ascii 1.0\nelement vertex 0\nelement tristrips 1\n"
                  "property list int int vertex_indices\nend_header\n3 0 1 2\n");
    });
    EXPECT_EQ(failure.fault, Fault::not_quad);
}

TEST(Ply, RejectsWhatIsMalformed) {
    const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    EXPECT_EQ(failure_of([&] { parse_ply(header("ascii") + points + "4 0 1 2 4\n"); }).fault, Fault::range);
    const std::string all = binary(false);
    for (std::size_t n = 0; n < all.size(); ++n)
        EXPECT_EQ(failure_of([&] { parse_ply(std::string_view(all).substr(0, n)); }).fault, Fault::format)
            << n;
    for (const std::string &text :
         {header("ascii") + points + "4 0 1 2 3 5\n", header("ascii") + points + "4 0 1 2\n",
          header("binary") + points, header("ascii", "property double x\n") + points,
          header("ascii", "property list float int w\n") + points,
          header("ascii", "element vertex 9\n") + points,
          std::string("ply\nformat ascii 1.0\nelement vertex 100000000000\nproperty float x\nproperty float "
                      "y\nproperty float z\nend_header\n0 0 0\n"),
          std::string("ply\nformat ascii 1.0\nelement vertex 0\nelement nothing 100000000000\nend_header\n"),
          std::string("ply\nelement vertex 0\nend_header\n")})
        EXPECT_EQ(failure_of([&] { parse_ply(text); }).fault, Fault::format) << text;
}

} // namespace
} // namespace alphamst::io
