#include "io/msh_groups.h"

#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

Names names_of(const std::string &text) {
    Scanner scan(text);
    PhysicalGroups groups;
    groups.read_names(scan);
    EXPECT_EQ(scan.word(), "$EndPhysicalNames");
    return groups.names();
}

TEST(MshGroups, ReadsNames) {
    EXPECT_EQ(
        names_of("5\n1 5 \"wall\"\n 2  7\t\"a \"b\" c\" \n0 1 \"\"\n3 9 \"volume\"\n0 2 \"$End\"\n"
                 "$EndPhysicalNames\n"),
        (Names{{{Entity::edge, 5}, "wall"}, {{Entity::face, 7}, "a _b_ c"}, {{Entity::vertex, 2}, "$End"}}));
    EXPECT_TRUE(names_of("1\n5 \"version 2.0\"\n$EndPhysicalNames\n").empty()); // of lines or of faces?
    for (const char *text : {"1\n1 5 wall\n", "1\n1 x \"wall\"\n", "2\n1 5 \"wall\"\n$EndPhysicalNames\n",
                             "-1\n", "1\n1 5 \"wall\n"})
        EXPECT_EQ(failure_of([&] { names_of(text); }).fault, Fault::format) << text;
    EXPECT_EQ(failure_of([] { names_of("1\n1 99999999999 \"wall\"\n"); }).fault, Fault::unsupported);
}

// Two squares, one for each of two parts: the curve 1 is cut in two, and so is the surface 1. The curve 7 is
// the border between the parts, and the surface 2 is of one part.
const std::string entities =
    "$Entities\n1 2 2 0\n3 0 0 0 1 5\n1 0 0 0 2 0 0 2 30 20 0\n2 0 1 0 2 1 0 1 -4 0\n"
    "1 0 0 0 2 1 0 1 40 0\n2 0 1 0 2 2 0 0 0\n$EndEntities\n";
const std::string parts =
    "$PartitionedEntities\n2\n1\n9 1\n1 3 3 0\n4 0 3 1 1 0 0 0 1 99\n"
    "5 1 1 1 1 0 0 0 1 0 0 1 98 0\n6 1 1 1 2 1 0 0 2 0 0 1 97 0\n7 2 1 2 1 2 1 0 0 1 1 0 1 96 0\n"
    "3 2 1 1 1 0 0 0 1 1 0 1 95 0\n4 2 1 1 2 1 0 0 2 1 0 0 0\n5 2 8 1 2 1 0 0 2 1 0 1 41 0\n"
    "$EndPartitionedEntities\n";

TEST(MshGroups, PartsAreInTheGroupsOfTheWhole) {
    const std::string text = entities + parts;
    Scanner scan(text);
    PhysicalGroups groups;
    scan.word();
    MshNumbers numbers(scan);
    groups.read_entities(numbers);
    EXPECT_EQ(scan.word(), "$EndEntities");
    EXPECT_EQ(groups.of(1, 1), (std::vector<std::int32_t>{30, 20}));
    EXPECT_EQ(groups.of(1, 2), std::vector<std::int32_t>{4});
    scan.word();
    groups.read_partitions(numbers);
    EXPECT_EQ(scan.word(), "$EndPartitionedEntities");
    EXPECT_EQ(groups.of(0, 4), std::vector<std::int32_t>{5});
    EXPECT_EQ(groups.of(1, 5), (std::vector<std::int32_t>{30, 20}));
    EXPECT_EQ(groups.of(1, 6), (std::vector<std::int32_t>{30, 20}));
    EXPECT_TRUE(groups.of(1, 7).empty());
    EXPECT_EQ(groups.of(2, 4), std::vector<std::int32_t>{40});
    EXPECT_EQ(groups.of(2, 5), std::vector<std::int32_t>{41}); // of a surface that only parts tell of
    EXPECT_EQ(groups.whole_curve(5), 1);
    EXPECT_EQ(groups.whole_curve(7), 0);
    EXPECT_EQ(groups.whole_curve(2), 2);
}

TEST(MshGroups, APartitionedMeshIsReadAsTheWhole) {
    const std::string head =
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 20 \"low\"\n2 40 \"all\"\n"
        "2 95 \"_part{1}\"\n$EndPhysicalNames\n";
    const std::string nodes = "$Nodes\n1 6 1 6\n2 3 0 6\n1\n2\n3\n4\n5\n6\n"
                              "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n$EndNodes\n";
    const std::string elements = "$Elements\n6 6 1 6\n0 4 15 1\n1 1\n1 5 1 1\n2 1 2\n1 6 1 1\n3 2 3\n"
                                 "1 7 1 1\n4 2 5\n2 3 3 1\n5 1 2 5 4\n2 4 3 1\n6 2 3 6 5\n$EndElements\n";
    const Arrays mesh = parse_msh(head + entities + parts + nodes + elements);
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{40, 40}));
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 20}, {1, 2, 20}}));
    ASSERT_EQ(mesh.marked_points.size(), 1U);
    EXPECT_EQ(mesh.marked_points[0].marker, 5);
    EXPECT_EQ(mesh.names, (Names{{{Entity::edge, 20}, "low"}, {{Entity::face, 40}, "all"}}));
    EXPECT_EQ(mesh.remarks.size(), 1U); // 20 and 30
    EXPECT_FALSE(mesh.curve_numbers);
}

} // namespace
} // namespace alphamst::io
