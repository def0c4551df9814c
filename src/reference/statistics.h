// What there is in a mesh, for outcomes of operations on the whole of it.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "geometry/embed.h"
#include "geometry/plane.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::reference {

// Interior vertices by valence, and the singular ones.
void count(const mesh::QuadMesh &mesh, std::map<int, std::int64_t> &valences, std::int64_t &singular);

// The same of the vertices of some faces, those on their border included.
void count(const mesh::QuadMesh &mesh, std::span<const int> faces, std::map<int, std::int64_t> &valences,
           std::int64_t &singular);

// Those of valence other than 4.
std::int64_t singular(const std::map<int, std::int64_t> &valences);
// What is closed, or has such a boundary, has no fewer of valences 3 and 5: all are of one kind.
bool fewest_singular(const std::map<int, std::int64_t> &valences);

// What outcomes tell as quality: the smallest scaled Jacobian as quality::measure has it, whatever an
// operation judges shapes by. 0 where there are no faces.
double least_quality(const mesh::QuadMesh &mesh);
double least_quality(const mesh::QuadMesh &mesh, std::span<const int> faces);
// Of quads that may take the place of faces.
double least_quality(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points);

// The largest aspect ratio as quality::measure has it. 0 where there are no faces.
double largest_aspect_ratio(const mesh::QuadMesh &mesh);
double largest_aspect_ratio(const mesh::QuadMesh &mesh, std::span<const int> faces);
double largest_aspect_ratio(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points);

// What an explicit time step may be as long as, but for a factor: the smallest area over perimeter of the
// faces. 0 where there are no faces.
double time_step(const mesh::QuadMesh &mesh);
double time_step(const mesh::QuadMesh &mesh, std::span<const int> faces);
double time_step(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points);
// What an operation made of it; 1 where nothing has changed, be it 0.
double time_step_ratio(double before, double after);

// All vertices of the mesh in the plane.
geometry::Points flatten(const mesh::QuadMesh &mesh, const geometry::Plane &plane);

// Faces that make a boundary vertex regular less those that it has: its angle over 90 degrees,
// rounded, at least 1.
int mismatch(const mesh::QuadMesh &mesh, int vertex);

} // namespace alphamst::reference
