#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

// Two squares side by side, with two boundaries.
const std::string head = "NDIME= 2\n";
const std::string elements = "NELEM= 2\n9 0 1 4 3 0\n9 1 2 5 4 1\n";
const std::string points = "NPOIN= 6\n0 0 0\n1 0 1\n2 0 2\n0 1 3\n1 1 4\n2 1 5\n";
const std::string markers = "NMARK= 2\nMARKER_TAG= low\nMARKER_ELEMS= 2\n3 0 1\n3 1 2\n"
                            "MARKER_TAG= high\nMARKER_ELEMS= 1\n3 5 4\n";
const std::string two = head + elements + points + markers;

void expect_two(const std::string &text) {
    const Arrays mesh = parse_su2(text);
    EXPECT_EQ(mesh.dim, 2) << text;
    EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}))
        << text;
    EXPECT_EQ(mesh.faces, (std::vector<std::int32_t>{0, 1, 4, 3, 1, 2, 5, 4})) << text;
    EXPECT_TRUE(mesh.face_marker.empty()) << text;
    ASSERT_EQ(mesh.marked_edges.size(), 3u) << text;
    const std::array<Arrays::MarkedEdge, 3> edges{{{{0, 1}, 1}, {{1, 2}, 1}, {{5, 4}, 2}}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.marked_edges[i].vertices, edges[i].vertices) << text;
        EXPECT_EQ(mesh.marked_edges[i].marker, edges[i].marker) << text;
    }
}

std::string replaced(std::string text, const std::string &from, const std::string &to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string with_line_ends(const std::string &text, const std::string &end) {
    std::string changed;
    for (char c : text)
        changed += c == '\n' ? end : std::string(1, c);
    return changed;
}

TEST(Su2, ReadsElementsBeforeAndAfterPoints) {
    expect_two(two);
    expect_two(head + points + elements + markers);
    expect_two(markers + points + elements + head);
    expect_two(two.substr(0, two.size() - 1)); // no line end
}

TEST(Su2, TagsAreNames) {
    EXPECT_EQ(parse_su2(two).names, (Names{{{Entity::edge, 1}, "low"}, {{Entity::edge, 2}, "high"}}));
    EXPECT_TRUE(parse_su2(replaced(two, "MARKER_TAG= low\n", "")).names.contains({Entity::edge, 2}));
}

TEST(Su2, WritesNamesOrNumbersAsTags) {
    Arrays mesh = samples::grid(2, 2);
    mesh.marked_edges = {{{1, 2}, 30}, {{0, 1}, -4}, {{0, 3}, 7}, {{2, 5}, 30}, {{3, 6}, 0}};
    mesh.names = {
        {{Entity::edge, 30}, "in (left), 5%"}, {{Entity::edge, 7}, "-4"}, {{Entity::edge, 8}, "unused"}};
    const std::string text = print_su2(mesh);
    EXPECT_EQ(text.substr(text.find("NMARK")), "NMARK= 3\nMARKER_TAG= -4\nMARKER_ELEMS= 1\n3 0 1\n"
                                               "MARKER_TAG= -4_7\nMARKER_ELEMS= 1\n3 0 3\n"
                                               "MARKER_TAG= in__left___5_\nMARKER_ELEMS= 2\n3 1 2\n3 2 5\n");
    EXPECT_EQ(samples::edges_of(parse_su2(text)),
              (std::vector<std::array<std::int32_t, 3>>{{0, 1, 1}, {0, 3, 2}, {1, 2, 3}, {2, 5, 3}}));
    mesh = samples::cube();
    const Arrays back = parse_su2(print_su2(mesh));
    EXPECT_EQ(back.dim, 3);
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_TRUE(back.marked_edges.empty());
}

TEST(Su2, ReadsLinesWithAndWithoutIndices) {
    expect_two(head + "NELEM= 2\n9 0 1 4 3\n9 1 2 5 4\n" + "NPOIN= 6\n0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n" +
               replaced(markers, "3 0 1", "3 0 1 0"));
    // A part of a mesh: points of its own, of all; an index in the part, in all.
    expect_two(head + elements + "NPOIN= 6 4\n0 0 0 9\n1 0 1 8\n2 0 2 7\n0 1 3 3\n1 1 4 2\n2 1 5 1\n" +
               markers);
}

TEST(Su2, ReadsBlanksCommentsAndEitherCase) {
    expect_two("%\n% a square = two\n%\nndime = 2% plane\n\n"
               "Nelem=2\n\t9\t0 1 4 3  0 \n% between\n\n9 1 2 5 4 1% NELEM= 3\n" +
               points +
               "\nNMARK =2\nMarker_Tag= low = bottom\nmarker_elems=\t2\n 3 0 1 \n3 1 2\n"
               "MARKERTAG= % no name\nMARKER_ELEMS= 1\n3 5 4\n%\n");
    for (const char *end : {"\r\n", "\r"})
        expect_two(with_line_ends(two, end));
}

TEST(Su2, PassesOverOtherKeywords) {
    expect_two("NZONE= 1\nIZONE= 1\n" + two +
               "FFD_NBOX= 1\nFFD_TAG= BOX\nFFD_CORNER_POINTS= 2\n0.5 0.25\n0.75 1e3\nFFD_SURFACE_POINTS= 1\n"
               "wall 0 0.5\n");
}

TEST(Su2, PassesOverPointsOfAMarker) {
    const std::string shared = "MARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 2\nSEND_RECV= 1\n1 0 0\n1 5 0\n";
    expect_two(replaced(two, "NMARK= 2", "NMARK= 3") + shared);
    const Arrays mesh = parse_su2(
        replaced(replaced(two, "NMARK= 2", "NMARK= 3"), "MARKER_TAG= high", shared + "MARKER_TAG= high"));
    ASSERT_EQ(mesh.marked_edges.size(), 3u);
    EXPECT_EQ(mesh.marked_edges[2].marker, 3); // a marker without an edge counts, too
}

// Files of old have it behind the number of elements.
TEST(Su2, PassesOverTheDestinationOfAMarker) {
    expect_two(replaced(two, "MARKER_ELEMS= 1\n", "MARKER_ELEMS= 1\nSEND_TO= 4 % a part\n"));
    const Arrays mesh = parse_su2(replaced(two, "MARKER_ELEMS= 2\n", "MARKER_ELEMS= 2\nSEND_TO= (none)\n"));
    EXPECT_EQ(mesh.remarks, std::vector<std::string>{"marker 1 has SEND_TO=, which is not kept"});
}

TEST(Su2, ReadsPointsInSpace) {
    const std::string rest =
        elements + "NPOIN= 6\n0 0 0 0\n1 0 0 1\n2 0 0\n0 1 0.5 3\n1 1 0.5 4\n2 1 0.5 5\n" + markers;
    const Arrays mesh = parse_su2("NDIME= 3\n" + rest);
    EXPECT_EQ(mesh.dim, 3);
    EXPECT_EQ(mesh.points, (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0.5, 1, 1, 0.5, 2, 1, 0.5}));
    EXPECT_EQ(failure_of([&] { parse_su2(head + rest); }).fault, Fault::format); // 0.5 is no index
}

TEST(Su2, ReadsTriangles) {
    for (const char *line : {"5 1 2 5 1", "5 1 2 5"})
        EXPECT_EQ(parse_su2(replaced(two, "9 1 2 5 4 1", line)).faces,
                  (std::vector<std::int32_t>{0, 1, 4, 3, 1, 2, 5, -1}))
            << line;
}

TEST(Su2, NamesTheElementThatIsNoFace) {
    for (const char *line : {"3 1 2", "12 0 1 2 3 4 5 0 1", "1 0", "-9 1 2 5 4"}) {
        const Failure failure = failure_of([&] { parse_su2(replaced(two, "9 1 2 5 4 1", line)); });
        EXPECT_EQ(failure.fault, Fault::not_quad) << line;
        EXPECT_EQ(failure.entity, Entity::face) << line;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << line;
        EXPECT_TRUE(failure.text.starts_with("line 4: face {} ")) << failure.text;
    }
}

TEST(Su2, NamesPointsThatAreNotThere) {
    for (const char *line : {"9 1 2 6 4", "9 -1 2 5 4", "9 1 2 5 4294967296"}) {
        const Failure failure = failure_of([&] { parse_su2(replaced(two, "9 1 2 5 4 1", line)); });
        EXPECT_EQ(failure.fault, Fault::range) << line;
        EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1}) << line;
        EXPECT_TRUE(failure.text.starts_with("line 4: ")) << failure.text;
    }
    for (const char *line : {"3 5 6", "3 -1 5", "3 5 4294967301"}) {
        const Failure failure = failure_of([&] { parse_su2(replaced(two, "3 5 4", line)); });
        EXPECT_EQ(failure.fault, Fault::range) << line;
        EXPECT_TRUE(failure.text.starts_with("line 19: ")) << failure.text;
    }
    const Failure failure = failure_of([] { parse_su2(replaced(two, "1 1 4", "1 nan 4")); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{4});
}

TEST(Su2, NamesTheLineThatIsMalformed) {
    struct {
        const char *from, *to, *place;
    } const cases[] = {{"NDIME= 2", "NDIME=", "line 1"},
                       {"NDIME= 2", "NDIME= 4", "line 1"},
                       {"NDIME= 2", "NDIME= two", "line 1"},
                       {"NDIME= 2", "NDIME= 2\nNDIME= 2", "line 2"},
                       {"NELEM= 2", "NELEM=", "line 2"},
                       {"NELEM= 2", "NELEM= 2.0", "line 2"},
                       {"NELEM= 2", "NELEM= -1", "line 2"},
                       {"NELEM= 2", "NELEM= 3", "line 5"},
                       {"NELEM= 2", "NELEM= 1", "line 4"},
                       {"NELEM= 2", "NELEM= 100000000000", "line 2"},
                       {"9 0 1 4 3 0", "9 0 1 4", "line 3"},
                       {"9 0 1 4 3 0", "9 0 1 4 3 0 0 0", "line 3"},
                       {"9 0 1 4 3 0", "9 0 1 4 x", "line 3"},
                       {"9 0 1 4 3 0", "quad 0 1 4 3", "line 3"},
                       {"9 0 1 4 3 0", "9 99999999999999999999 1 4 3", "line 3"},
                       {"NPOIN= 6", "NPOIN= 7", "line 12"},
                       {"NPOIN= 6", "NPOIN= 5", "line 11"},
                       {"NPOIN= 6", "NPOIN= 9223372036854775807", "line 5"},
                       {"2 0 2", "2", "line 8"},
                       {"2 0 2", "2 0 2 2 2", "line 8"},
                       {"2 0 2", "2 1e999", "line 8"},
                       {"2 0 2", "2 0 2.5", "line 8"},
                       {"NMARK= 2", "NMARK= 3", "line 19"},
                       {"NMARK= 2", "NMARK= 1", "line 19"},
                       {"NMARK= 2", "NMARK= 2\nNMARK= 2", "line 13"},
                       {"MARKER_ELEMS= 2", "MARKER_ELEMS= 3", "line 17"},
                       {"MARKER_ELEMS= 2", "MARKER_ELEMS= 1", "line 16"},
                       {"MARKER_ELEMS= 2", "MARKER_ELEMS= many", "line 14"},
                       {"3 1 2\n", "3 1\n", "line 16"},
                       {"3 1 2\n", "2 1 2\n", "line 16"},
                       {"3 1 2\n", "3 1 2 0 0 0\n", "line 16"},
                       {"3 1 2\n", "3 1 2\nMARKER_ELEMS= 0\n", "line 20"}};
    for (const auto &damage : cases) {
        const Failure failure = failure_of([&] { parse_su2(replaced(two, damage.from, damage.to)); });
        EXPECT_EQ(failure.fault, Fault::format) << damage.from << " -> " << damage.to;
        EXPECT_TRUE(failure.text.starts_with(std::string(damage.place) + ":"))
            << damage.from << " -> " << damage.to << ": " << failure.text;
    }
}

TEST(Su2, RejectsWhatIsMissing) {
    EXPECT_NE(failure_of([] { parse_su2(head + elements + points); }).text.find("no NMARK="),
              std::string::npos);
    for (const std::string &text :
         {std::string(), std::string("not a mesh\n"), head, head + elements + points,
          head + elements + markers, head + points + markers, elements + points + markers})
        EXPECT_EQ(failure_of([&] { parse_su2(text); }).fault, Fault::format) << text;
    for (std::size_t end = two.find('\n'); end + 1 < two.size(); end = two.find('\n', end + 1))
        EXPECT_EQ(failure_of([&] { parse_su2(std::string(two, 0, end)); }).fault, Fault::format) << end;
    EXPECT_EQ(failure_of([] { parse_su2("NZONE= 2\nIZONE= 1\n" + two + "IZONE= 2\n" + two); }).fault,
              Fault::unsupported);
}

} // namespace
} // namespace alphamst::io
