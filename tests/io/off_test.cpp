#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

const std::string corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Off, ReadsCommentsColoursAndOddHeaders) {
    const std::vector<std::int32_t> quad{0, 1, 2, 3};
    for (const std::string &text :
         {"OFF\n4 1 0\n" + corners + "4 0 1 2 3\n", "OFF 4 1\n" + corners + "4 0 1 2 3",
          "4 1 4\n" + corners + "4 0 1 2 3\n",
          "\n OFF4 1 4 # glued\n" + corners + "4  0 1 2 3 255 0 0\n\n# the end\n",
          std::string("# first\nCOFF # c\n# c\n\n4 1 0 # n\n0 0 0 9 9 9 9\n1 0 0 1 1 1\n\n1 1 0 # v\n0 1 "
                      "0\n4 0 1 2 3"),
          std::string("OFF\r\n4 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3\r\n"),
          std::string("OFF\r4 1 0\r0 0 0\r1 0 0\r1 1 0\r0 1 0\r4 0 1 2 3\r")}) {
        const Arrays mesh = parse_off(text);
        EXPECT_EQ(mesh.faces, quad) << text;
        EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})) << text;
        EXPECT_EQ(mesh.dim, 2);
    }
    EXPECT_EQ(parse_off("OFF\n0 0 0\n").points.size(), 0u);
}

TEST(Off, ReadsTriangles) {
    EXPECT_EQ(parse_off("OFF\n4 2 0\n" + corners + "4 0 1 2 3\n3 0 1 2 255 0 0\n").faces,
              (std::vector<std::int32_t>{0, 1, 2, 3, 0, 1, 2, -1}));
}

TEST(Off, NamesTheFaceOfOtherCorners) {
    const Failure failure =
        failure_of([] { parse_off("OFF\n4 2 0\n" + corners + "4 0 1 2 3\n5 0 1 2 3 0\n"); });
    EXPECT_EQ(failure.fault, Fault::not_quad);
    EXPECT_EQ(failure.entity, Entity::face);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1});
    EXPECT_STREQ(failure.what(),
                 "line 8: face {} has 5 corners, not 3 or 4; divide it into triangles or quadrilaterals");
}

TEST(Off, NamesCornersOutOfRange) {
    for (const char *face : {"4 1 2 3 4", "4 0 1 2 -1", "4 0 1 2 4294967296"}) {
        const Failure failure = failure_of([&] { parse_off("OFF\n4 1 0\n" + corners + face); });
        EXPECT_EQ(failure.fault, Fault::range) << face;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{0});
    }
}

TEST(Off, NamesTheVertexThatIsNotFinite) {
    const Failure failure = failure_of([] { parse_off("OFF\n2 0 0\n0 0 0\n0 inf 0\n"); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.entity, Entity::vertex);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1});
}

TEST(Off, RejectsWhatIsMalformed) {
    for (const std::string &text :
         {std::string(), std::string("OFF"), std::string("OFF\n100000000000 1 0\n0 0 0\n"),
          std::string("OFF\n-1 1 0\n"), std::string("OFF\n1 100000000000 0\n0 0 0\n"),
          std::string("OFF\n99999999999999999999 1 0\n"), std::string("OFF\n1 0 0\n0 0 1e999\n"),
          std::string("OFF\n1 0 0\n0 0 0x1\n"), std::string("nonsense\n"),
          "OFF\n4 1 0\n" + corners + "4 0 1 2", "OFF\n4 1 0\n" + corners,
          "OFF\n4 1 0\n" + corners + "4 0 1 2 3\n4 0 1 2 3\n"})
        EXPECT_EQ(failure_of([&] { parse_off(text); }).fault, Fault::format) << text;
    EXPECT_EQ(failure_of([] { parse_off("OFF BINARY\n"); }).fault, Fault::unsupported);
    EXPECT_EQ(failure_of([] { parse_off("4OFF\n1 0 0\n0 0 0 0\n"); }).fault, Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
