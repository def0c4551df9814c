#include "io/scanner.h"

#include <gtest/gtest.h>

#include <limits>

#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

TEST(Scanner, WordsAreBetweenBlanksAndLineEnds) {
    Scanner scan(" a\tbc\r\nd\re # f");
    for (const char *word : {"a", "bc", "d", "e", "#", "f"})
        EXPECT_EQ(scan.word(), word);
    EXPECT_TRUE(scan.at_end());
    EXPECT_EQ(failure_of([&] { scan.word(); }).fault, Fault::format);
}

TEST(Scanner, CommentsHideTheRestOfTheirLine) {
    Scanner scan("a#b c\n# all of it\nd #", '#');
    EXPECT_EQ(scan.word(), "a");
    EXPECT_TRUE(scan.at_line_end());
    EXPECT_EQ(scan.word(), "d");
    EXPECT_TRUE(scan.at_end());
}

TEST(Scanner, ABackslashJoinsLinesWhereItMay) {
    Scanner joined("a\\\nb\\\r\nc\nd", '\0', true), apart("a\\\nb");
    EXPECT_EQ(joined.word(), "a");
    EXPECT_FALSE(joined.at_line_end());
    EXPECT_EQ(joined.word(), "b");
    EXPECT_EQ(joined.word(), "c");
    EXPECT_TRUE(joined.at_line_end());
    EXPECT_EQ(apart.word(), "a\\");
    EXPECT_TRUE(apart.at_line_end());
}

TEST(Scanner, LinesLoseTheirEndAndBlanksBeforeIt) {
    Scanner scan("one two \t\r\n\n  three\rlast");
    EXPECT_EQ(scan.line(), "one two");
    EXPECT_EQ(scan.line(), "");
    EXPECT_EQ(scan.line(), "  three");
    EXPECT_TRUE(scan.ahead("la"));
    EXPECT_EQ(scan.line(), "last");
    EXPECT_EQ(scan.remaining(), 0U);
}

TEST(Scanner, NumbersAreWholeWords) {
    Scanner scan("-3 2.5e1 4x 1.5 1e999");
    EXPECT_EQ(scan.integer(), -3);
    EXPECT_EQ(scan.real(), 25);
    EXPECT_EQ(failure_of([&] { scan.real(); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { scan.integer(); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { scan.real(); }).fault, Fault::format);
}

TEST(Scanner, BelievesNoCountThatTheFileCannotHold) {
    const std::string text = "3 1 2 3"; // six bytes and a line end that is missing for 3 numbers
    Scanner enough(text), large(text), negative("-1 0");
    EXPECT_EQ(enough.count("numbers", 2), 3);
    EXPECT_EQ(failure_of([&] { large.count("numbers", 3); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { negative.count("numbers", 1); }).fault, Fault::format);
}

TEST(Scanner, FailuresNameTheLineOrAfterBytesTheByte) {
    Scanner scan("a\r\nb\rc\nd1234567");
    for (int i = 0; i < 4; ++i)
        scan.word();
    EXPECT_EQ(failure_of([&] { scan.malformed("so"); }).text, "line 4: so");
    Scanner bytes("ab\ncdef");
    EXPECT_EQ(bytes.take(3), "ab\n");
    EXPECT_EQ(bytes.take(2), "cd");
    EXPECT_EQ(failure_of([&] { bytes.malformed("so"); }).text, "byte 3: so");
    EXPECT_EQ(failure_of([&] { bytes.take(3); }).fault, Fault::format);
}

TEST(Scanner, QuotedWordsAreShortAndPrintable) {
    EXPECT_EQ(io::quoted("word"), "'word'");
    EXPECT_EQ(io::quoted("a{b c}d\xff"), "'a?b?c?d?'");
    EXPECT_EQ(io::quoted(std::string(25, 'x')), "'xxxxxxxxxxxxxxxxxxxxxxxx...'");
}

TEST(Scanner, SameWordInEitherCase) {
    EXPECT_TRUE(same_word("Points", "POINTS"));
    EXPECT_FALSE(same_word("Points", "POINT"));
    EXPECT_FALSE(same_word("[", "{")); // no letters, though as far apart
}

TEST(Scanner, DecodesBothByteOrders) {
    const char bytes[] = {1, 2};
    EXPECT_EQ(decode<std::uint16_t>(bytes, true), 0x0102);
    EXPECT_EQ(decode<std::uint16_t>(bytes, false), 0x0201);
}

TEST(Scanner, MeshesKeepTheirBounds) {
    const Scanner scan("");
    Arrays mesh;
    add_vertex(scan, mesh, 1, 2, 0);
    EXPECT_EQ(mesh.points, (std::vector<double>{1, 2, 0}));
    const double infinite = std::numeric_limits<double>::infinity();
    const Failure failure = failure_of([&] { add_vertex(scan, mesh, 1, infinite, 0); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1});
    EXPECT_EQ(corner(scan, mesh, 4, 4, 1), 3);
    EXPECT_EQ(failure_of([&] { corner(scan, mesh, 5, 4, 1); }).fault, Fault::range);
    EXPECT_EQ(failure_of([&] { corner(scan, mesh, 0, 4, 1); }).fault, Fault::range);
    EXPECT_EQ(need_corners(scan, mesh, 3), 3U);
    EXPECT_EQ(failure_of([&] { need_corners(scan, mesh, 5); }).fault, Fault::not_quad);
    EXPECT_EQ(finished(mesh).dim, 2);
    mesh.points.back() = 0.5;
    EXPECT_EQ(finished(mesh).dim, 3);
}

} // namespace
} // namespace alphamst::io
