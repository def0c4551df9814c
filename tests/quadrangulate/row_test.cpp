#include "quadrangulate/row.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "quadrangulate/halve.h"
#include "triangles.h"

namespace alphamst::quadrangulate {
namespace {

using Sides = std::vector<std::array<std::int32_t, 2>>;

QuadArrays arrays(std::vector<double> points, std::vector<std::int32_t> faces) {
    QuadArrays quads;
    quads.points = std::move(points);
    quads.faces = std::move(faces);
    for (std::size_t f = 0; f < quads.faces.size() / 4; ++f)
        quads.origin.push_back(static_cast<std::int32_t>(f));
    return quads;
}

std::int64_t count_origin(const QuadArrays &quads, std::int32_t face) {
    return std::count(quads.origin.begin(), quads.origin.end(), face);
}

std::size_t n_boundary(const QuadArrays &quads) {
    const auto across = across_edges(quads.faces, mesh::pair_sides(quads.faces, quads.points.size() / 3));
    return static_cast<std::size_t>(std::count(across.begin(), across.end(), -1));
}

// Faces 0 and 1 of a prism are triangles: a row leads through one of the others.
TEST(Row, LeadsFromTriangleToTriangle) {
    QuadArrays quads = arrays({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1},
                              {0, 2, 1, -1, 3, 4, 5, -1, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5});
    Sides flat;
    split_rows(quads, flat);
    EXPECT_FALSE(mesh::any_triangle(quads.faces));
    EXPECT_EQ(quads.origin.size(), 6u);
    EXPECT_EQ(quads.points.size(), 3u * 8);
    EXPECT_EQ(n_boundary(quads), 0u);
    EXPECT_EQ(count_origin(quads, 0), 1);
    EXPECT_EQ(count_origin(quads, 1), 1);
    EXPECT_EQ(count_origin(quads, 2) * count_origin(quads, 3) * count_origin(quads, 4), 2); // one is split
    ASSERT_EQ(quads.midpoints.size(), 2u);
    ASSERT_EQ(flat.size(), 2u);
    for (const auto &[from, midpoint] : flat) {
        EXPECT_LT(from, 6);
        EXPECT_GE(midpoint, 6);
    }
}

// A triangle within three quads goes through one of them.
TEST(Row, LeadsToTheBoundary) {
    QuadArrays quads = arrays({0, 1, 0, -1, -1, 0, 1, -1, 0, 0, 3, 0, -3, -3, 0, 3, -3, 0},
                              {0, 1, 2, -1, 1, 0, 3, 4, 2, 1, 4, 5, 0, 2, 5, 3});
    Sides flat;
    split_rows(quads, flat);
    EXPECT_FALSE(mesh::any_triangle(quads.faces));
    EXPECT_EQ(quads.origin.size(), 5u);
    EXPECT_EQ(quads.points.size(), 3u * 8);
    EXPECT_EQ(n_boundary(quads), 4u); // one side of three is halved
    EXPECT_EQ(flat.size(), 1u);
    const mesh::QuadMesh mesh = mesh::QuadMesh::build(2, quads.points, quads.faces);
    for (const auto &[edge, vertex] : quads.midpoints)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.point(vertex)[static_cast<unsigned>(k)],
                      (mesh.point(edge[0])[static_cast<unsigned>(k)] +
                       mesh.point(edge[1])[static_cast<unsigned>(k)]) /
                          2);
}

TEST(Row, QuadsAloneStay) {
    const std::vector<std::int32_t> faces{0, 1, 2, 3};
    QuadArrays quads = arrays({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, faces);
    Sides flat;
    split_rows(quads, flat);
    EXPECT_EQ(quads.faces, faces);
    EXPECT_EQ(quads.points.size(), 12u);
    EXPECT_TRUE(flat.empty());
}

} // namespace
} // namespace alphamst::quadrangulate
