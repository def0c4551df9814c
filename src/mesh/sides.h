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

// Whether a face has four corners, or three where triangles are allowed, that are different vertices.
inline bool has_corners(Faces faces, std::size_t face, std::size_t n_vertices, bool triangles) {
    const Faces corners = faces.subspan(4 * face, triangles && is_triangle(faces, face) ? 3 : 4);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < 0 || static_cast<std::size_t>(corners[i]) >= n_vertices)
            return false;
        for (std::size_t j = 0; j < i; ++j)
            if (corners[i] == corners[j])
                return false;
    }
    return true;
}

// These throw what QuadMesh::build says; the second names all that is wrong. Triangles only where they are
// allowed.
void test_lengths(int dim, Coordinates points, Faces faces);
void test_points(Coordinates points); // all at one place are allowed
void test_arrays(Coordinates points, Faces faces, bool triangles);

// One side of a face, filed under the smaller of its two vertices.
struct Side {
    std::int32_t larger;
    std::int32_t corner;
};

// Of all faces, in ascending order of their vertices, smaller first, and then of their corners.
struct EdgeSides {
    std::vector<std::int32_t> end; // [smaller vertex], one behind its last side
    std::vector<Side> sides;
};

// Corners of -1 have no sides.
EdgeSides sort_sides(Faces faces, std::size_t n_vertices);

// Calls visit(sides) with those of each edge, in their order.
template <class Visit> void visit_edges(const EdgeSides &sorted, Visit visit) {
    const std::span<const Side> sides = sorted.sides;
    for (std::size_t v = 0, i = 0; v < sorted.end.size(); ++v) {
        const auto end = static_cast<std::size_t>(sorted.end[v]);
        while (i < end) {
            std::size_t last = i + 1;
            while (last < end && sides[last].larger == sides[i].larger)
                ++last;
            visit(sides.subspan(i, last - i));
            i = last;
        }
    }
}

// Whether a side runs from its larger vertex to the smaller one.
inline bool runs_down(Faces faces, const Side &side) {
    return faces[static_cast<std::size_t>(side.corner)] == side.larger;
}

// Edges in ascending order of their vertices, smaller first.
struct Halfedges {
    std::vector<std::int32_t> of_corner; // 2 * edge, + 1 if it runs from the larger vertex
    std::size_t n_edges = 0;
};

// Throws not_manifold, and names all that is wrong: edges with three faces, or two that run along it the same
// way.
Halfedges pair_sides(Faces faces, std::size_t n_vertices);

} // namespace alphamst::mesh
