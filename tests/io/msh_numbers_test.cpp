#include "io/msh_numbers.h"

#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

template <class... Number> std::string little(Number... numbers) {
    std::string bytes;
    (append_little(bytes, numbers), ...);
    return bytes;
}

TEST(MshNumbers, OfEitherOrderOfBytesAndOfText) {
    const std::string text = "1 -2 0.5", bytes = little(1, -2, std::int64_t{-3}, 0.5);
    Scanner words(text), scan(bytes);
    MshNumbers in_text(words), numbers(scan);
    EXPECT_EQ(in_text.integer(), 1);
    EXPECT_EQ(in_text.long_integer(), -2);
    EXPECT_EQ(in_text.real(), 0.5);
    numbers.begin_binary();
    EXPECT_EQ(numbers.integer(), -2);
    EXPECT_EQ(numbers.long_integer(), -3);
    EXPECT_EQ(numbers.real(), 0.5);
    const std::string big{0, 0, 0, 1, 0, 0, 2, 0}, none{1, 0, 0, 1};
    Scanner of_big(big), of_none(none);
    MshNumbers big_endian(of_big), damaged(of_none);
    big_endian.begin_binary();
    EXPECT_EQ(big_endian.integer(), 512);
    EXPECT_EQ(failure_of([&] { damaged.begin_binary(); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { numbers.integer(); }).text.substr(0, 8), "byte 24:");
}

TEST(MshNumbers, CountsFitInTheFile) {
    const std::string bytes = little(1, std::int64_t{2}, 0.0) + little(std::int64_t{2}, 0.0);
    Scanner scan(bytes);
    MshNumbers numbers(scan);
    numbers.begin_binary();
    EXPECT_EQ(numbers.count("things", 2, 8), 2);
    numbers.real();
    EXPECT_EQ(failure_of([&] { numbers.count("things", 2, 8); }).fault, Fault::format);
}

// Two squares: low edges in a group, one square in two, a point in one; the curve has a node of order 2.
std::string version_2() {
    std::string text = "$MeshFormat\n2.2 1 8\n" + little(1) + "\n$EndMeshFormat\n$Nodes\n6\n";
    for (int v = 0; v < 6; ++v)
        text += little(10 + v, double(v % 3), double(v / 3), 0.0);
    text += "\n$EndNodes\n$Elements\n5\n";
    text += little(15, 1, 2) + little(1, 6, 1, 10);                              // a point
    text += little(1, 2, 2) + little(2, 5, 1, 10, 11) + little(3, 5, 1, 11, 12); // two lines
    text += little(3, 2, 2) + little(4, 8, 1, 10, 11, 14, 13) + little(5, 9, 1, 11, 12, 15, 14);
    return text + "\n$EndElements\n";
}

std::string version_4() {
    using Long = std::int64_t;
    const std::string box = little(0.0, 0.0, 0.0, 2.0, 1.0, 0.0);
    std::string text = "$MeshFormat\n4.1 1 8\n" + little(1) +
                       "\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"low\"\n" +
                       "$EndPhysicalNames\n$Entities\n" + little(Long{1}, Long{1}, Long{2}, Long{0});
    text += little(1, 0.0, 0.0, 0.0, Long{1}, 6);
    text += little(7) + box + little(Long{1}, 5, Long{2}, 1, -1);
    text += little(1) + box + little(Long{1}, 8, Long{1}, 7);
    text += little(2) + box + little(Long{1}, 9, Long{0});
    text += "\n$EndEntities\n$Nodes\n" + little(Long{2}, Long{6}, Long{10}, Long{15});
    text += little(1, 7, 1, Long{3}, Long{10}, Long{11}, Long{12}); // with a parameter each
    for (int v = 0; v < 3; ++v)
        text += little(double(v), 0.0, 0.0, 0.25);
    text += little(2, 1, 0, Long{3}, Long{13}, Long{14}, Long{15});
    for (int v = 0; v < 3; ++v)
        text += little(double(v), 1.0, 0.0);
    text += "\n$EndNodes\n$Elements\n" + little(Long{4}, Long{5}, Long{1}, Long{5});
    text += little(0, 1, 15, Long{1}, Long{1}, Long{10});
    text += little(1, 7, 8, Long{2}, Long{2}, Long{10}, Long{11}, Long{13}) +
            little(Long{3}, Long{11}, Long{12}, Long{13}); // with a node in the middle
    text += little(2, 1, 3, Long{1}, Long{4}, Long{10}, Long{11}, Long{14}, Long{13});
    text += little(2, 2, 3, Long{1}, Long{5}, Long{11}, Long{12}, Long{15}, Long{14});
    return text + "\n$EndElements\n";
}

TEST(MshNumbers, BinaryFilesAreReadAsTextIs) {
    for (const std::string &text : {version_2(), version_4()}) {
        const Arrays mesh = parse_msh(text);
        EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}));
        EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 4, 3, 1, 2, 5, 4}));
        EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{8, 9}));
        EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}, {1, 2, 5}}));
        ASSERT_EQ(mesh.marked_points.size(), 1u);
        EXPECT_EQ(mesh.marked_points[0].marker, 6);
    }
    EXPECT_EQ(parse_msh(version_4()).names, (Names{{{Entity::edge, 5}, "low"}}));
}

TEST(MshNumbers, DamagedBinaryFilesNameTheByte) {
    for (const std::string &text : {version_2(), version_4()})
        for (std::size_t n = 0; n < text.size() - 1; n += 3) {
            const Failure failure = failure_of([&] { parse_msh(text.substr(0, n)); });
            EXPECT_EQ(failure.fault, Fault::format) << n;
            EXPECT_TRUE(n < 25 || failure.text.starts_with("byte ")) << failure.text;
        }
    for (const char *head : {"4 1 8\n", "4.1 1 4\n"})
        EXPECT_EQ(failure_of([&] { parse_msh("$MeshFormat\n" + std::string(head)); }).fault,
                  Fault::unsupported);
    EXPECT_EQ(failure_of([] { parse_msh("$MeshFormat\n4.1 7 8\n"); }).fault, Fault::format);
}

} // namespace
} // namespace alphamst::io
