// Maps of a disk in space to the plane, and what tells a good one.
#pragma once

#include <Eigen/Core>
#include <span>

#include "geometry/embed.h"

namespace alphamst::geometry {

// Vertices 0 .. boundary-1 run counter-clockwise around the disk, seen from the side of the map.
struct Disk {
    Quads quads;
    int boundary = 0;
    std::span<const Eigen::Vector3d> points; // [vertex]
};

// Each gives the positions of all vertices, none where the disk is so degenerate that its equations have no
// solution. Whether it folded is told by is_bijective. All are deterministic.

// Mean value coordinates (Floater 2003), of the vertices at the other ends of the edges, with the loop on a
// circle, spaced by length: weights are positive, so every quad is convex but for rounding (Tutte 1963,
// Floater 1997).
Points mean_value_on_circle(const Disk &disk);

// The same with neighbours weighed down by how much the surface is stretched at them, again and again while
// that makes the stretch of the whole fall (Yoshizawa, Belyaev, Seidel 2004).
Points low_stretch_on_circle(const Disk &disk);

// Least squares conformal map (Levy, Petitjean, Ray, Maillot 2002): angles are kept as well as can be, the
// loop goes where it wants. Two vertices of it that are far apart are constrained. As large as the disk in
// space.
Points conformal(const Disk &disk);

// Every corner of every quad turns left, and the loop does not meet itself: nothing lies on anything else.
bool is_bijective(Quads quads, int boundary, const Points &positions);

// The loop is a simple polygon.
bool is_simple(std::span<const Eigen::Vector2d> loop);

// How much the plane has to be stretched to become the disk, root of the mean square over the area (Sander,
// Snyder, Gortler, Hoppe 2001), at the best scale: 1 where the map is a similarity, else more.
double stretch(const Disk &disk, const Points &positions);

// [vertex] of the quads around each, without the scale. Infinite where a quad has no area in the plane.
std::vector<double> vertex_stretch(const Disk &disk, const Points &positions);

} // namespace alphamst::geometry
