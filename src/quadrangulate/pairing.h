// Which triangles of a mesh become a quad together.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/sides.h"

namespace alphamst::quadrangulate {

// Of each corner, seen along the normal of the centre; the smallest is the scaled Jacobian.
std::array<double, 4> sines(mesh::Coordinates points, const std::array<std::int32_t, 4> &quad);
inline constexpr double flattest = 0.01; // of a corner that counts as convex
// Of the angle between the normals of triangles abc and bad, 0 if one has no area.
double cosine(mesh::Coordinates points, std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d);

// Why two triangles shall not become a quad together, for each corner: the one across its side.
enum class Bar : std::uint8_t {
    none,
    crease, // it is sharp, but does not part flat sides or has to be crossed: rather than a concave quad
    sharp,  // between flat sides: only if triangles are left over otherwise
    curve   // the caller wants the side, or it is between regions: never, but it can get a midpoint
};

// What a face does with one of its sides; side -1: a quad, or a triangle without a mate.
struct Choice {
    enum class Kind : std::uint8_t {
        none,
        merge, // with the triangle across, its mate
        halve, // the side gets a midpoint, its mate across the side being in the same situation
        cross, // with three others around a vertex: mate is the place in Pairing::crosses
        split  // in three, as all its neighbours are
    };
    Kind kind = Kind::none;
    std::int8_t side = -1;
    std::int32_t mate = -1; // -1: the side is on the boundary
};

// Four triangles around a vertex, from the one of least id on, and the quad that they are.
struct Cross {
    std::array<std::int32_t, 4> faces{}, corners{};
};

struct Pairing {
    std::vector<Choice> choices; // of each face
    std::vector<Cross> crosses;
    std::vector<std::int32_t> poor; // faces without a mate, or that make concave or flat quads with theirs
};

struct TriangleSides {
    std::vector<std::int32_t> across; // the corner on the other side of the edge of each corner, -1: boundary
    std::vector<Bar> bars;            // of each corner; curve without one across: the mesh goes on there
    std::vector<bool> diagonals; // or empty: of each corner, whether the two triangles were given as a quad
    std::vector<bool> held = {}; // or empty: of each vertex, whether it shall keep faces
};

// Of a side with a face beyond it: the quad of the two triangles, how much it is bent (1 less the cosine of
// the angle between them), and whether it could cross a sharp edge, being sound but for that.
std::array<std::int32_t, 4> quad_over(const TriangleSides &sides, mesh::Faces faces, std::size_t corner);
double bend_over(const TriangleSides &sides, mesh::Coordinates points, mesh::Faces faces, std::size_t corner);
bool can_cross(const TriangleSides &sides, mesh::Coordinates points, mesh::Faces faces, std::size_t corner);

// May sides on the boundary get midpoints? At most one of each component whose triangles are odd in number
// does.
Pairing pair_triangles(mesh::Coordinates points, mesh::Faces faces, const TriangleSides &sides,
                       bool may_leave);

} // namespace alphamst::quadrangulate
