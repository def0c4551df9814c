// All-quad meshes from triangles and quads.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/sides.h"

namespace alphamst::quadrangulate {

struct Polygons {
    mesh::Coordinates points;
    mesh::Faces faces;
    std::span<const std::int32_t> face_marker;           // [n], or empty
    std::span<const std::array<std::int32_t, 2>> curves; // edges that shall stay, given by their vertices
    std::span<const std::int32_t> held = {};             // vertices that shall keep faces
};

enum class Quadrangulation {
    pair, // two triangles along their common side
    split // every side is halved: three quads of a triangle, four of a quad
};

struct PairingRules {
    double sharp_angle = 180; // degrees between the normals of two triangles that are not paired; 180: none
    bool new_boundary_vertices = true; // else Failure (argument) where the triangles are odd in number
};

struct QuadArrays {
    struct Midpoint {
        std::array<std::int32_t, 2> edge; // which is no longer one
        std::int32_t vertex;
    };

    std::vector<double> points; // those given, then new ones
    std::vector<std::int32_t> faces;
    std::vector<std::int32_t> origin; // [n] the face given that a quad, or its first triangle, was
    std::vector<Midpoint> midpoints;  // by edge, smaller vertex first; one may end at another midpoint
    std::vector<std::array<std::int32_t, 2>> crossed; // sharp edges that are in quads now
};

// Pairing leaves no triangle over, adds no vertex and crosses no curve or border of regions
// where that is possible at all; on closed surfaces of triangles it is (Petersen 1891), but
// for borders. Pairs are convex and bent by less than 60 degrees where that leaves none
// over. A triangle that is left over, their number being odd or something in the way, gets a
// vertex at the midpoint of a side: on the boundary; or on a border or curve, where it makes a
// quad of the triangle beyond, too; or else, among quads, a row of them to the next such triangle
// or to the boundary is split. Quads that are given stay, but for those in such rows and
// beside such midpoints. A triangle on its own is split in three.
//
// Memory is linear, and so is time but where triangles left over by their neighbours are far
// from each other, as in a lattice with a row shifted. Throws what QuadMesh::build does, ids being
// those of the polygons, but for vertices whose faces are not one fan, which only it looks for.
QuadArrays quadrangulate(const Polygons &polygons, Quadrangulation how, const PairingRules &rules = {});

// The pieces an edge was cut into, in order from its first vertex.
std::vector<std::array<std::int32_t, 2>> pieces(const QuadArrays &quads, std::array<std::int32_t, 2> edge);

} // namespace alphamst::quadrangulate
