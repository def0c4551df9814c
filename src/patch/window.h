// A window: a disk of faces of a mesh, its boundary loop and what the mesh around
// it wants at every boundary vertex.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "surface/boundary_curve.h"

namespace alphamst::patch {

struct Region;

// Numbers equal those of enum amst_defect.
enum Defect : std::int32_t {
    empty = 1,
    not_connected = 2,
    not_disk = 4,
    pinched = 8,
    overlap = 16,
    crosses_feature = 32,
    odd_boundary = 64,
    corners = 128,
    not_convex = 256
};

struct Window {
    std::vector<int> faces;    // ascending
    std::vector<int> loop;     // boundary vertices, counter-clockwise
    std::vector<int> interior; // interior vertices, ascending
    std::vector<int> inside;   // [loop] faces of the window at each boundary vertex
    std::vector<int> outside;  // [loop] faces of the mesh outside the window at it
    std::vector<int> wanted;   // [loop] the boundary word: faces inside that make the vertex regular
    // [loop] interior angle of the window, degrees, from the angles of its faces
    std::vector<double> angles;

    // Where the boundary of the mesh gets other vertices within the window, see refill/respacing.h: those are
    // negative in the loop, and vertices that go count as interior.
    std::vector<OpenMesh::Vec3d> added;            // [negative one of the loop]
    std::vector<surface::CurvePlace> added_places; // likewise
    std::vector<int> parents;                      // [loop] see QuadMesh::replace_disk; empty: none are new
};

// Defect bits of a face set (empty, not_connected, not_disk, pinched,
// crosses_feature, odd_boundary); 0 for a usable disk. An interior edge or vertex with a flag FIXED, FEATURE
// or CORNER, an edge with a marker, or two faces of different markers, is crosses_feature; so is a face
// that is FIXED.
std::int32_t defects(const mesh::QuadMesh &mesh, std::span<const int> faces);
std::int32_t defects_of(const mesh::QuadMesh &mesh, const Region &region);

// The window of a face set whose defects are 0.
//
// wanted: 4 - outside at an interior vertex of the mesh, max(1, round(angle / 90 deg)) -
// outside at a vertex of the mesh boundary, at least 1. Where the angle inside the window is
// not below 175 degrees it is at least 2, and so on for 2 x 175: a corner cannot span it.
Window make_window(const mesh::QuadMesh &mesh, std::span<const int> faces);
// That rule, for a vertex with so many faces outside; regular: 4, or what an angle at the boundary asks for.
int wanted_at(int regular, int outside, double inside_angle);
int regular_at_boundary(double angle);
Window window_of(const mesh::QuadMesh &mesh, Region region);

// 0..1: area of the window over the area of its planar convex hull (in its mean
// plane); 1 is convex.
double convexity(const mesh::QuadMesh &mesh, const Window &window);

// Singular vertices of the mesh in the window, boundary included.
int singularities(const mesh::QuadMesh &mesh, const Window &window);

} // namespace alphamst::patch
