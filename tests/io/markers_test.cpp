#include <gtest/gtest.h>

#include "io/formats.h"
#include "io/markers.h"
#include "samples.h"

namespace alphamst::io {
namespace {

// The node numbers of a file that counts by tens.
std::int64_t tens(std::int32_t vertex) { return 10 * (vertex + 1); }

TEST(Markers, TheSmallestOfSeveralCounts) {
    Arrays mesh = samples::grid(2, 2);
    mesh.face_marker = {4, 4, 4, 4};
    mesh.marked_edges = {{{0, 1}, 7}, {{1, 2}, 5}, {{1, 0}, 3}, {{1, 2}, 5}};
    mesh.marked_points = {{4, 9}, {4, 8}};
    mesh.faces.insert(mesh.faces.end(), mesh.faces.begin(), mesh.faces.begin() + 4);
    mesh.face_marker.push_back(2);
    settle_markers(mesh, tens);
    EXPECT_EQ(mesh.faces, samples::grid(2, 2).faces);
    EXPECT_EQ(mesh.face_marker, (std::vector<std::int32_t>{2, 4, 4, 4}));
    EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 3}, {1, 2, 5}}));
    ASSERT_EQ(mesh.marked_points.size(), 1U);
    EXPECT_EQ(mesh.marked_points[0].marker, 8);
    EXPECT_EQ(
        mesh.remarks,
        (std::vector<std::string>{
            "1 faces have several markers, of which the smallest counts; nodes (markers): "
            "10-20-50-40 (2, 4)",
            "1 lines have several markers, of which the smallest counts; nodes (markers): 10-20 (3, 7)",
            "1 points have several markers, of which the smallest counts; nodes (markers): 50 (8, 9)"}));
    EXPECT_EQ(mesh.left_out, ""); // all have one
}

TEST(Markers, WhatNoFaceHasIsLeftOut) {
    for (const bool curve_numbers : {false, true}) {
        Arrays mesh = samples::grid(2, 2);
        mesh.points.insert(mesh.points.end(), {9, 9, 0});
        mesh.marked_edges = {{{0, 2}, 7}, {{0, 1}, 1}, {{0, 4}, 6}};
        mesh.marked_points = {{8, 5}, {9, 5}};
        mesh.curve_numbers = curve_numbers;
        settle_markers(mesh, tens);
        EXPECT_EQ(samples::edges_of(mesh), (std::vector<std::array<std::int32_t, 3>>{{0, 1, 1}}));
        ASSERT_EQ(mesh.marked_points.size(), 1U);
        EXPECT_EQ(mesh.marked_points[0].vertex, 8);
        ASSERT_EQ(mesh.remarks.size(), 2U);
        EXPECT_EQ(mesh.remarks[0], "2 lines with a marker are no edges of faces and are left out; nodes "
                                   "(markers): 10-30 (7), 10-50 (6)");
        EXPECT_EQ(mesh.remarks[1],
                  "1 points with a marker have no face and are left out; nodes (markers): 100 (5)");
        EXPECT_EQ(mesh.left_out, mesh.remarks[curve_numbers ? 1 : 0]);
    }
}

TEST(Markers, OfManyTheFirstAreTold) {
    Arrays mesh = samples::grid(4, 2);
    for (std::int32_t v = 0; v < 20; ++v)
        mesh.marked_edges.push_back({{v, v + 2}, 1});
    settle_markers(mesh, tens);
    ASSERT_EQ(mesh.remarks.size(), 1U);
    EXPECT_TRUE(mesh.remarks[0].starts_with("20 lines")) << mesh.remarks[0];
    EXPECT_TRUE(mesh.remarks[0].ends_with(", 100-120 (1), ...")) << mesh.remarks[0];
}

TEST(Markers, AFaceTwiceIsNoMatterOfMarkers) {
    for (const std::int32_t marker : {4, 0}) {
        Arrays mesh = samples::grid(2, 2);
        mesh.faces.insert(mesh.faces.end(), mesh.faces.begin(), mesh.faces.begin() + 4);
        mesh.face_marker = {4, 4, 5, 4, marker};
        settle_markers(mesh, tens);
        EXPECT_EQ(mesh.faces.size(), 20U); // building the mesh refuses it
        EXPECT_TRUE(mesh.remarks.empty());
    }
}

// Every format that holds markers gives back what it was given.
TEST(Markers, ThereAndBack) {
    Arrays mesh = samples::grid(3, 3);
    mesh.face_marker = {1, 1, 1, 20, 20, 20, 0, 0, 0};
    mesh.marked_edges = {{{0, 1}, 1}, {{1, 2}, 1}, {{2, 3}, 2}};
    mesh.marked_points = {{5, 77}, {10, 3}};
    mesh.names = {{{Entity::edge, 1}, "inlet"},
                  {{Entity::edge, 2}, "no_slip"},
                  {{Entity::face, 20}, "Überlauf 2"},
                  {{Entity::vertex, 77}, "well"}};
    const struct {
        Arrays (*parse)(std::string_view);
        std::string (*print)(const Arrays &);
        bool others;
    } formats[] = {{parse_msh, print_msh, true},
                   {parse_vtk, print_vtk, true},
                   {parse_vtu, print_vtu, true},
                   {parse_su2, print_su2, false}};
    for (const auto &format : formats) {
        const Arrays back = format.parse(format.print(mesh));
        EXPECT_TRUE(samples::same_bits(back.points, mesh.points));
        EXPECT_EQ(back.faces, mesh.faces);
        EXPECT_EQ(samples::edges_of(back), samples::edges_of(mesh));
        EXPECT_EQ(back.face_marker, format.others ? mesh.face_marker : std::vector<std::int32_t>());
        ASSERT_EQ(back.marked_points.size(), format.others ? 2U : 0U);
        for (std::size_t i = 0; i < back.marked_points.size(); ++i) {
            EXPECT_EQ(back.marked_points[i].vertex, mesh.marked_points[i].vertex);
            EXPECT_EQ(back.marked_points[i].marker, mesh.marked_points[i].marker);
        }
        Names names = mesh.names;
        if (!format.others)
            std::erase_if(names, [](const auto &name) { return name.first.first != Entity::edge; });
        EXPECT_EQ(back.names, names);
        EXPECT_TRUE(back.remarks.empty());
    }
}

TEST(Markers, CleanNamesFitIntoQuotes) {
    EXPECT_EQ(clean_name("Fußweg 1"), "Fußweg 1");
    EXPECT_EQ(clean_name("a\"b\tc\x7f"), "a_b_c_");
}

} // namespace
} // namespace alphamst::io
