#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

// Two squares; node numbers sparse and unordered, node 7 in no face.
const std::string two =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"$wall\"\n$EndPhysicalNames\n"
    "$Nodes\n7\n10 0 0 0\n3 1 0 0\n900 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n7 9 9 0\n$EndNodes\n";

std::string elements(const std::string &lines, int n) {
    return two + "$Elements\n" + std::to_string(n) + "\n" + lines + "$EndElements\n";
}

TEST(Msh, ReadsVersion2) {
    const Arrays mesh = parse_msh(elements("1 15 2 0 1 10\n2 1 2 5 1 10 3\n3 1 2 0 8 3 5\n4 1 0 5 6\n"
                                           "5 3 2 0 1 10 3 900 4\n6 3 4 17 1 1 1 3 5 6 900\n",
                                           6));
    EXPECT_EQ(mesh.dim, 2);
    EXPECT_EQ(mesh.points.size(), 21u);
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{0, 17}));
    // One line has the tag of its curve, but another one is in a group.
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}}));
    EXPECT_FALSE(mesh.curve_numbers);
    EXPECT_EQ(mesh.names, (Names{{{Entity::edge, 5}, "$wall"}}));
    EXPECT_TRUE(mesh.marked_points.empty());
}

// As Gmsh writes it with Mesh.SaveAll: all curves, whether somebody asked for them or not.
TEST(Msh, TagsOfCurvesCountWhereNoLineIsInAGroup) {
    const Arrays mesh = parse_msh(elements(
        "1 15 2 0 1 10\n2 1 2 0 3 10 3\n3 1 2 0 8 3 5\n5 3 2 6 1 10 3 900 4\n6 3 2 6 1 3 5 6 900\n", 5));
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 3}, {1, 4, 8}}));
    EXPECT_TRUE(mesh.curve_numbers);
}

// A square of two faces in blocks, with physical tags in $Entities.
const std::string four_head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string four_entities =
    "$Entities\n1 2 2 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 5 2 1 -1\n2 0 0 0 1 0 0 0 2 1 -1\n"
    "1 0 0 0 1 1 0 1 -9 0\n2 0 0 0 1 1 0 0 0\n$EndEntities\n";
const std::string four_nodes =
    "$Nodes\n2 6 1 60\n1 1 1 2\n10\n3\n0 0 0 0.25\n1 0 0 0.75\n2 1 0 4\n60\n4\n5\n6\n"
    "1 1 0\n0 1 0\n2 0 0\n2 1 0\n$EndNodes\n";
const std::string four_elements =
    "$Elements\n4 4 1 4\n1 1 1 1\n1 10 3\n1 2 1 1\n2 3 5\n2 1 3 1\n3 10 3 60 4\n"
    "2 2 3 1\n4 3 5 6 60\n$EndElements\n";

TEST(Msh, ReadsVersion4) {
    const Arrays mesh = parse_msh(four_head + four_entities + four_nodes + four_elements);
    EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}));
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{9, 0}));
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}}));
    EXPECT_TRUE(parse_msh(four_head + four_nodes + four_elements).face_marker.empty());
}

// Points have boxes, blocks first their entities, and nodes their tags on their own lines.
TEST(Msh, ReadsVersion40) {
    const std::string head = "$MeshFormat\n4 0 8\n$EndMeshFormat\n";
    const std::string entities =
        "$Entities\n2 2 2 0\n1 0 0 0 0 0 0 0\n2 1 0 0 1 0 0 1 3\n1 0 0 0 1 0 0 1 5 2 1 -2\n"
        "2 0 0 0 1 1 0 0 2 1 -1\n1 0 0 0 1 1 0 1 -9 0\n2 0 0 0 1 1 0 0 0\n$EndEntities\n";
    const std::string nodes =
        "$Nodes\n2 6\n1 1 1 2\n10 0 0 0 0.25\n3 1 0 0 0.75\n1 2 0 4\n60 1 1 0\n4 0 1 0\n"
        "5 2 0 0\n6 2 1 0\n$EndNodes\n";
    const std::string elements = "$Elements\n5 5\n1 1 1 1\n1 10 3\n2 1 1 1\n2 3 5\n2 0 15 1\n5 3\n1 2 3 1\n"
                                 "3 10 3 60 4\n2 2 3 1\n4 3 5 6 60\n$EndElements\n";
    const Arrays mesh = parse_msh(head + entities + nodes + elements);
    EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}));
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{9, 0}));
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}}));
    ASSERT_EQ(mesh.marked_points.size(), 1U);
    EXPECT_EQ(mesh.marked_points[0].marker, 3);
}

TEST(Msh, OneRuleForSeveralGroupsInEveryVersion) {
    const std::string lines = "1 1 2 9 1 10 3\n2 1 2 5 1 10 3\n3 3 2 7 1 10 3 900 4\n4 3 2 6 1 10 3 900 4\n"
                              "5 3 2 7 1 3 5 6 900\n6 15 2 4 1 3\n7 15 2 2 1 3\n";
    const Arrays old = parse_msh(elements(lines, 7));
    const Arrays now = parse_msh(
        four_head +
        "$Entities\n1 1 2 0\n1 0 0 0 2 4 2\n1 0 0 0 1 0 0 2 9 -5 0\n1 0 0 0 1 1 0 2 7 6 0\n2 0 0 0 1 1 0 1 7 "
        "0\n"
        "$EndEntities\n" +
        four_nodes +
        "$Elements\n4 4 1 4\n1 1 1 1\n1 10 3\n0 1 15 1\n2 3\n2 1 3 1\n3 10 3 60 4\n2 2 3 1\n4 3 5 6 60\n"
        "$EndElements\n");
    for (const Arrays *mesh : {&old, &now}) {
        EXPECT_EQ(mesh->face_marker, (std::vector<std::int32_t>{6, 7}));
        EXPECT_EQ(samples::edges_of(*mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}}));
        ASSERT_EQ(mesh->marked_points.size(), 1U);
        EXPECT_EQ(mesh->marked_points[0].vertex, 1);
        EXPECT_EQ(mesh->marked_points[0].marker, 2);
        EXPECT_EQ(mesh->remarks.size(), 3U);
    }
    EXPECT_EQ(old.remarks[1], now.remarks[1]);
}

// The mesh of version 2 in version 1.
const std::string one_nodes =
    "$NOD\n7\n10 0 0 0\n3 1 0 0\n900 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n7 9 9 0\n$ENDNOD\n";

std::string one(const std::string &lines, int n) {
    return one_nodes + "$ELM\n" + std::to_string(n) + "\n" + lines + "$ENDELM\n";
}

TEST(Msh, ReadsVersion1) {
    const std::string lines = "1 15 0 1 1 10\n2 1 5 1 2 10 3\n3 1 0 8 2 3 5\n4 1 0 0 2 5 6\n"
                              "5 3 0 1 4 10 3 900 4\n9 3 17 1 4 3 5 6 900\n";
    for (const std::string &text :
         {one(lines, 6), " \n" + one(lines, 6),
          one(lines, 6) + "$PostFormat\n1.4 0 8\n$EndPostFormat\n$VIEW\n0\n$ENDVIEW\n"}) {
        const Arrays mesh = parse_msh(text);
        EXPECT_EQ(mesh.dim, 2);
        EXPECT_EQ(mesh.points,
                  (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0, 9, 9, 0}));
        EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 2, 3, 1, 4, 5, 2}));
        EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{0, 17}));
        EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 5}}));
    }
    EXPECT_TRUE(parse_msh(one("1 3 0 1 4 10 3 900 4\n", 1)).face_marker.empty());
}

TEST(Msh, RejectsOtherElementsOfVersion1) {
    for (const char *line :
         {"2 9 0 1 6 10 3 900 4 1 2\n", "2 10 0 1 9 1 2 3 4 5 6 7 8 9\n", "2 5 0 1 8 1 2 3 4 5 6 7 8\n"}) {
        const Failure failure =
            failure_of([&] { parse_msh(one("1 3 0 1 4 10 3 900 4\n" + std::string(line), 2)); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << line;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << line;
        EXPECT_TRUE(failure.text.starts_with("line 14: ")) << failure.text;
    }
    EXPECT_EQ(failure_of([] { parse_msh(one("1 3 0 1 4 10 3 900 1\n", 1)); }).fault, Fault::range);
    EXPECT_EQ(failure_of([] { parse_msh(one("1 1 0 1 2 10 0\n", 1)); }).fault, Fault::range);
}

TEST(Msh, NamesTheLineOfVersion1ThatIsMalformed) {
    const std::string quad = "1 3 0 1 4 10 3 900 4\n";
    const std::string nodes = "$NOD\n2\n1 0 0 0\n";
    struct {
        std::string text, place;
    } const cases[] = {{one("1 3 0 1 3 10 3 900\n", 1), "line 13"},
                       {one("1 3 0 1 5 10 3 900 4 5\n", 1), "line 13"},
                       {one("1 1 0 1 3 10 3 900\n", 1), "line 13"},
                       {one("1 3 0 1 4 10 3 900 4 5\n", 1), "line 13"},
                       {one("1 3 0 1 4 10 3 900\n", 1), "line 14"},
                       {one("1 3 0 x 4 10 3 900 4\n", 1), "line 13"},
                       {one(quad, 2), "line 14"},
                       {one(quad, 0), "line 13"},
                       {one(quad, -1), "line 12"},
                       {one_nodes + "$ELM\n100000000000\n" + quad, "line 12"},
                       {one(quad, 1) + "$ELM\n", "line 15"},
                       {one(quad, 1) + one_nodes, "line 15"},
                       {one(quad, 1) + "$VIEW\n1\n", "line 16"},
                       {one(quad, 1) + "$ENDELM\n", "line 15"},
                       {nodes + "1 1 1 1\n$ENDNOD\n", "line 5"},
                       {nodes + "2 1 1 1\n$EndNodes\n", "line 5"},
                       {nodes + "2 1 1\n$ENDNOD\n", "line 5"},
                       {"$NOD\n100000000000\n1 0 0 0\n", "line 2"}};
    for (const auto &damaged : cases) {
        const Failure failure = failure_of([&] { parse_msh(damaged.text); });
        EXPECT_EQ(failure.fault, Fault::format) << damaged.text;
        EXPECT_TRUE(failure.text.starts_with(damaged.place + ":")) << damaged.text << failure.text;
    }
    const std::string all = one(quad, 1);
    for (const char *end : {"$ENDNOD", "$ENDELM"}) {
        std::string other = all;
        other.replace(other.find(end), 7, "$EndNod");
        EXPECT_EQ(failure_of([&] { parse_msh(other); }).fault, Fault::format) << end;
    }
    EXPECT_NE(failure_of([&] { parse_msh(all + "$ENDELM\n"); }).text.find("in place of a section"),
              std::string::npos);
    for (std::size_t end = all.find('\n'); end + 1 < all.size(); end = all.find('\n', end + 1))
        EXPECT_EQ(failure_of([&] { parse_msh(std::string(all, 0, end)); }).fault, Fault::format) << end;
    EXPECT_EQ(failure_of([] { parse_msh(one("1 3 99999999999 1 4 10 3 900 4\n", 1)); }).fault,
              Fault::unsupported);
}

TEST(Msh, ReadsTriangles) {
    const Arrays mesh = parse_msh(elements("1 3 2 7 1 10 3 900 4\n2 2 2 8 1 10 3 900\n", 2));
    EXPECT_EQ(mesh.faces.size(), 8U);
    EXPECT_EQ(mesh.faces.back(), -1);
    EXPECT_TRUE(std::equal(mesh.faces.begin(), mesh.faces.begin() + 3, mesh.faces.begin() + 4));
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{7, 8}));
    EXPECT_EQ(parse_msh(one("1 2 9 1 3 10 3 900\n", 1)).faces.back(), -1);
    EXPECT_EQ(failure_of([] { parse_msh(elements("1 2 2 8 1 10 3 900 4\n", 1)); }).fault, Fault::format);
}

TEST(Msh, RejectsOtherElements) {
    for (const char *line :
         {"2 9 2 0 1 10 3 900 4 1 2\n", "2 10 2 0 1 1 2 3 4 5 6 7 8 9\n", "2 5 0 1 2 3 4 5 6 7 8\n"}) {
        const Failure failure =
            failure_of([&] { parse_msh(elements("1 3 2 0 1 10 3 900 4\n" + std::string(line), 2)); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << line;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << line;
    }
}

TEST(Msh, RejectsNodesThatAreNotThere) {
    const Failure failure = failure_of([] { parse_msh(elements("1 3 2 0 1 10 3 900 1\n", 1)); });
    EXPECT_EQ(failure.fault, Fault::range);
    EXPECT_EQ(failure.entity, Entity::face);
    EXPECT_EQ(failure_of([] { parse_msh(elements("1 1 2 0 1 10 0\n", 1)); }).fault, Fault::range);
}

TEST(Msh, RejectsWhatIsMalformed) {
    for (const std::string &text :
         {std::string(), std::string("$Nodes\n0\n$EndNodes\n"), four_head,
          elements("1 3 2 0 1 10 3 900\n", 1), elements("1 3 2 0 1 10 3 900 4 5\n", 1),
          elements("1 3 2 0 1 10 3 900 4\n", 2), elements("1 3 2 0 1 10 3 900 4\n", 0), elements("", -1),
          elements("1 3 100000000 0 1 10 3 900 4\n", 1), two + two.substr(two.find("$Nodes")),
          two + "$Elements\n100000000000\n1 3\n", two + "$Comment\nno end\n", two + "stray\n",
          four_head + "$Nodes\n1 100000000000 1 1\n2 1 0 1\n1\n0 0 0\n$EndNodes\n",
          four_head + "$Nodes\n1 2 1 1\n2 1 0 1\n1\n0 0 0\n$EndNodes\n",
          std::string("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n1 1 1 1\n$EndNodes\n")})
        EXPECT_EQ(failure_of([&] { parse_msh(text); }).fault, Fault::format) << text;
    for (const char *text :
         {"$MeshFormat\n4.2 0 8\n$EndMeshFormat\n", "$MeshFormat\n1.5 0 8\n$EndMeshFormat\n",
          "$MeshFormat\n5.0 0 8\n$EndMeshFormat\n"})
        EXPECT_EQ(failure_of([&] { parse_msh(text); }).fault, Fault::unsupported) << text;
}

} // namespace
} // namespace alphamst::io
