// What building and quadrangulating share: the tests of points and faces, and the sides of
// faces paired into edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace alphamst::mesh {

using Coordinates = std::span<const double>; // [n][3]
using Faces = std::span<const std::int32_t>; // [n][4], the last corner of a triangle is -1

inline bool is_triangle(Faces faces, std::size_t face) { return faces[4 * face + 3] < 0; }

inline bool any_triangle(Faces faces) {
    for (std::size_t face = 0; face < faces.size() / 4; ++face)
        if (is_triangle(faces, face))
            return true;
    return false;
}

// Corner c of the list stands for the side of its face from there to the next corner.
inline std::size_t next_corner(Faces faces, std::size_t c) {
    if (c % 4 == 3)
        return c - 3;
    return c % 4 == 2 && faces[c + 1] < 0 ? c - 2 : c + 1;
}

// Lengths and coordinates are to be between these, so that their fourth powers, and distances as float, which
// trees and samples of surfaces keep, neither overflow nor become 0. A light year and the radius of a proton
// are well inside, in metres.
constexpr double least_extent = 1e-30, largest_coordinate = 1e30;

// These throw what QuadMesh::build says. Triangles only where they are allowed.
void test_lengths(int dim, Coordinates points, Faces faces);
void test_points(Coordinates points); // all at one place are allowed
void test_corners(Faces faces, std::size_t n_vertices, bool triangles);

// Edges in ascending order of their vertices, smaller first.
struct Halfedges {
    std::vector<std::int32_t> of_corner; // 2 * edge, + 1 if it runs from the larger vertex
    std::size_t n_edges = 0;
};

// Throws not_manifold: an edge with three faces, or two that run along it the same way.
Halfedges pair_sides(Faces faces, std::size_t n_vertices);

} // namespace alphamst::mesh
