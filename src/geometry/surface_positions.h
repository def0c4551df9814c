// Positions on a curved surface: what `improve` is in the plane.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "geometry/embed.h"
#include "surface/surface.h"

namespace alphamst::geometry {

// Vertices on a surface. All arrays are [vertex]. Normals are those of the surface, of length one; zero for a
// vertex that does not move freely means that it has no say in where its quads look: it is on a crease, where
// they look to two sides.
struct SurfacePositions {
    std::vector<Eigen::Vector3d> points, normals;
    std::vector<int> surface_triangles; // triangle of the surface under each vertex

    void add(const surface::Spot &spot);
    void put(int vertex, const surface::Spot &spot);
};

// A corner is positive if it is so against the mean normal of the surface at the four vertices of its
// quad, against that of the quads there, and against the normal of the quad itself (Verdict's).
Judgement judge(Quads quads, const SurfacePositions &on_surface);
double least_jacobian(const std::array<int, 4> &quad,
                      const SurfacePositions &on_surface); // not against that of the quads
double total_area(Quads quads, const SurfacePositions &on_surface);
// [quad]
std::vector<double> scaled_jacobians(Quads quads, const SurfacePositions &on_surface);

// Moves the free vertices over the surface for squarer quads of the wanted areas: each by Newton steps in
// its tangent plane, and back to the surface by the shortest way from where it was. Corners that are not
// positive are inverted where that comes soon. Those on feature lines, which are free, too, move along these
// alone: exactly on their lines, and never past the vertices that bound them; their normals stay. Returns how
// the quads are then.
Judgement improve(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
                  SurfacePositions &on_surface, const EmbedOptions &options);

} // namespace alphamst::geometry
