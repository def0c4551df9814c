#include "io/vtk_values.h"

#include <gtest/gtest.h>

#include <string>

#include "samples.h"

namespace alphamst::io::vtk {
namespace {

using samples::failure_of;

std::string bytes(std::initializer_list<int> values) { return {values.begin(), values.end()}; }

// The value of a type of VTK that these big-endian bytes are.
std::int64_t integer(std::string_view type, const std::string &text) {
    Scanner scan(text);
    Values values(scan);
    values.binary = true;
    const std::int64_t value = values.integer(find_type(type).value());
    EXPECT_EQ(scan.remaining(), 0U) << type;
    return value;
}

double real(std::string_view type, const std::string &text) {
    Scanner scan(text);
    Values values(scan);
    values.binary = true;
    return values.real(find_type(type).value());
}

TEST(VtkValues, TypesAreFoundInEitherCase) {
    EXPECT_EQ(find_type("Double")->size, 8U);
    EXPECT_EQ(find_type("double")->kind, Kind::real);
    EXPECT_EQ(find_type("UNSIGNED_SHORT")->size, 2U);
    EXPECT_EQ(find_type("unsigned_short")->kind, Kind::natural);
    EXPECT_EQ(find_type("vtkIdType")->size, 4U);
    EXPECT_EQ(find_type("vtktypeint64")->size, 8U);
    EXPECT_EQ(find_type("bit")->size, 0U);
    EXPECT_FALSE(find_type("string"));
    EXPECT_FALSE(find_type(""));
}

TEST(VtkValues, BinaryWholeNumbersHaveTheirSign) {
    EXPECT_EQ(integer("char", bytes({0xfe})), -2);
    EXPECT_EQ(integer("unsigned_char", bytes({0xfe})), 254);
    EXPECT_EQ(integer("short", bytes({0xff, 0xfe})), -2);
    EXPECT_EQ(integer("unsigned_short", bytes({0x01, 0x02})), 258);
    EXPECT_EQ(integer("int", bytes({0xff, 0xff, 0xff, 0xfd})), -3);
    EXPECT_EQ(integer("unsigned_int", bytes({0xff, 0xff, 0xff, 0xfd})), 4294967293);
    EXPECT_EQ(integer("long", bytes({0, 0, 0, 1, 0, 0, 0, 2})), 4294967298);
}

TEST(VtkValues, RealsComeFromEveryType) {
    EXPECT_EQ(real("float", bytes({0xbf, 0xc0, 0, 0})), -1.5);
    EXPECT_EQ(real("double", bytes({0x3f, 0xe0, 0, 0, 0, 0, 0, 0})), 0.5);
    EXPECT_EQ(real("short", bytes({0xff, 0xfe})), -2);
    Scanner scan(" 0.25 7");
    Values values(scan);
    EXPECT_EQ(values.real({Kind::real, 4}), 0.25);
    EXPECT_EQ(values.real({Kind::whole, 4}), 7);
}

TEST(VtkValues, ValuesBeginBehindTheLineThatAnnouncesThem) {
    const std::string text = " 2 short\n" + bytes({0, 10, 1, 0});
    Scanner binary(text);
    Values values(binary);
    values.binary = true;
    EXPECT_EQ(binary.integer(), 2);
    const Type type = values.read_type();
    EXPECT_EQ(values.integers(2, type), (std::vector<std::int64_t>{10, 256})); // 10 is no end of a line
    Scanner plain("2 short 10\n256");
    Values words(plain);
    EXPECT_EQ(plain.integer(), 2);
    EXPECT_EQ(words.integers(2, words.read_type()), (std::vector<std::int64_t>{10, 256}));
}

TEST(VtkValues, RealsOfAnyType) {
    const std::string text = bytes({1, 2, 3, 4, 5});
    Scanner binary(text);
    Values values(binary);
    values.binary = true;
    EXPECT_EQ(values.reals(2, {Kind::natural, 2}), (std::vector<double>{258, 772}));
    EXPECT_EQ(values.integer({Kind::natural, 1}), 5);
    Scanner plain("1 2.5 -3 4");
    Values words(plain);
    EXPECT_EQ(words.reals(3, {Kind::real, 4}), (std::vector<double>{1, 2.5, -3}));
    EXPECT_EQ(words.integer({Kind::whole, 4}), 4);
    EXPECT_EQ(integer_of("\x02\x01", {Kind::whole, 2}, false), 258);
    EXPECT_EQ(real_of("\xff", {Kind::whole, 1}, false), -1);
}

TEST(VtkValues, NoMoreThanTheFileMayHold) {
    const std::string text(11, '\0');
    Scanner scan(text);
    Values values(scan);
    EXPECT_EQ(values.least({Kind::real, 8}), 2U); // a digit and a blank
    values.binary = true;
    EXPECT_EQ(values.least({Kind::real, 8}), 8U);
    EXPECT_EQ(values.least({Kind::natural, 0}), 1U);
    EXPECT_EQ(failure_of([&] { values.integers(1000, {Kind::whole, 4}); }).fault, Fault::format);
}

TEST(VtkValues, RefusesWhatIsNoWholeNumberAndNoType) {
    Scanner scan("string\n1 2 3");
    Values values(scan);
    EXPECT_EQ(failure_of([&] { values.read_type(); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { values.integers(3, {Kind::real, 4}); }).fault, Fault::format);
    EXPECT_EQ(failure_of([&] { values.integers(3, {Kind::natural, 0}); }).fault, Fault::format);
}

} // namespace
} // namespace alphamst::io::vtk
