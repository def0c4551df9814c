#include <gtest/gtest.h>

#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::edges_of;

TEST(MshWrite, MarkersRoundTrip) {
    Arrays mesh = samples::grid(3, 3);
    mesh.face_marker = {1, 2, 0, -4, 5, 6, 7, 8, 2147483647};
    mesh.marked_edges = {{{0, 1}, 3}, {{1, 2}, -2147483647 - 1}, {{2, 3}, 3}};
    const Arrays back = parse_msh(print_msh(mesh));
    EXPECT_TRUE(samples::same_bits(back.points, mesh.points));
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.face_marker, mesh.face_marker);
    ASSERT_EQ(back.marked_edges.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(back.marked_edges[i].vertices, mesh.marked_edges[i].vertices);
        EXPECT_EQ(back.marked_edges[i].marker, mesh.marked_edges[i].marker);
    }
    mesh.face_marker.clear();
    EXPECT_TRUE(parse_msh(print_msh(mesh)).face_marker.empty());
}

TEST(MshWrite, Version4KeepsMarkersAndNames) {
    Arrays mesh = samples::grid(3, 3);
    mesh.face_marker = {1, 2, 0, 4, 5, 6, 7, 8, 2147483647};
    mesh.marked_edges = {{{0, 1}, 3}, {{1, 2}, 8}, {{2, 3}, 3}, {{3, 7}, 0}};
    mesh.marked_points = {{5, 9}, {10, 9}};
    mesh.names = {{{Entity::edge, 3}, "a rim"}, {{Entity::vertex, 9}, "well"}};
    const Arrays back = parse_msh(print_msh4(mesh));
    EXPECT_TRUE(samples::same_bits(back.points, mesh.points));
    // Faces come in the order of their markers.
    EXPECT_EQ(back.face_marker, (std::vector<std::int32_t>{0, 1, 2, 4, 5, 6, 7, 8, 2147483647}));
    EXPECT_EQ(std::vector(back.faces.begin(), back.faces.begin() + 4),
              std::vector(mesh.faces.begin() + 8, mesh.faces.begin() + 12));
    EXPECT_EQ(edges_of(back), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 3}, {2, 3, 3}, {1, 2, 8}}));
    EXPECT_EQ(back.marked_points.size(), 2u);
    EXPECT_EQ(back.names, mesh.names);
    const samples::Folder folder;
    mesh.face_marker[1] = -2;
    EXPECT_EQ(
        write(folder / "m.msh4", mesh),
        std::vector<std::string>{".msh4 has no place for 1 signs of markers, which are orientations in it"});
    mesh = samples::grid(1, 2);
    EXPECT_EQ(parse_msh(print_msh4(mesh)).faces, mesh.faces);
}

} // namespace
} // namespace alphamst::io
