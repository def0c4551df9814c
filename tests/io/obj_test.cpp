#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\n";

TEST(Obj, ReadsEveryWayToNameCorners) {
    const std::vector<std::int32_t> quad{0, 1, 2, 3};
    for (const std::string &text :
         {corners + "f 1 2 3 4\n", corners + "f 1/1 2/2 3/3 4/4", corners + "f 1//1 2//1 3//1 4//1 # end\n",
          corners + "f 1/7/1 2/7/1 3/7/1 4/7/1\n", corners + "f -4 -3 -2 -1\n", "f 1 2 3 4\n" + corners,
          corners + "f 1 2 \\\n 3 4\n", corners + "f 1 2 \\\r\n3\\\r\n 4\r\n", corners + "\tf\t1 2 3 4\n",
          "# c\nmtllib none.mtl\no x\ng\ns off\nvn 0 0 1\nvt 0 0\n" + corners +
              "l 1 2\np 1\nusemtl a#b\nf 1 2 3 4\n",
          std::string("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0.5\nf 1 2 3 4\nv 0 1 0\n")}) {
        const Arrays mesh = parse_obj(text);
        EXPECT_EQ(mesh.faces, quad) << text;
        EXPECT_EQ(mesh.points.size(), 12u) << text;
        EXPECT_EQ(mesh.dim, 3);
    }
    // Relative numbers count from where the face is.
    EXPECT_EQ(parse_obj(corners + "f -4 -3 -2 -1\nv 9 9 9\n").faces, quad);
}

TEST(Obj, KeepsWhatOthersDrop) {
    // A repeated corner, a repeated face, an edge of three faces: for the mesh builder to judge.
    const Arrays mesh = parse_obj(corners + "v 2 2 2\nf 1 1 2 3\nf 1 2 3 4\nf 1 2 3 4\n");
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3}));
    EXPECT_EQ(mesh.points.size(), 15u); // and a vertex without a face
}

TEST(Obj, ReadsTriangles) {
    EXPECT_EQ(parse_obj(corners + "f 1 2 3 4\nf 1/1 2/2 3/3\n").faces,
              (std::vector<std::int32_t>{0, 1, 2, 3, 0, 1, 2, -1}));
}

TEST(Obj, RejectsOtherFaces) {
    for (const char *face : {"f 1 2", "f", "f 1 2 3 4 1"}) {
        const Failure failure = failure_of([&] { parse_obj(corners + "f 1 2 3 4\n" + face); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << face;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << face;
    }
}

TEST(Obj, RejectsCornersOutOfRange) {
    for (const char *face : {"f 0 1 2 3", "f 1 2 3 5", "f -5 1 2 3", "f 1 2 3 2147483648",
                             "f 1 2 3 -9223372036854775808", "f 1 2 3 9223372036854775807"}) {
        const Failure failure = failure_of([&] { parse_obj(corners + face); });
        EXPECT_EQ(failure.fault, Fault::range) << face;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{0}) << face;
    }
}

TEST(Obj, RejectsWhatIsMalformed) {
    for (const char *line :
         {"v 1 2", "v 1 2 x", "v 1 2 1e999", "f 1 2 3 x", "f 1 2 3 /4", "f 1 2 3 4.0", "\x01\x02"})
        EXPECT_EQ(failure_of([&] { parse_obj(corners + line); }).fault, Fault::format) << line;
    EXPECT_EQ(failure_of([] { parse_obj(""); }).fault, Fault::format);
    const Failure failure = failure_of([] { parse_obj(corners + "v nan 0 0\n"); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{4});
}

} // namespace
} // namespace alphamst::io
