// Where vertices on the features of a curved mesh may slide.
#pragma once

#include <span>
#include <vector>

#include "geometry/surface_positions.h"
#include "mesh/quad_mesh.h"
#include "settings.h"

namespace alphamst::reference {

// How far edges may be from the bends of features, in their lengths; 0: features do not change.
double bend_tolerance(const Settings &settings);

// For a vertex on a feature that may slide there, see patch::slide, and that is on one line of the curves of
// the mesh with its two neighbours, between them: then the feature does not change wherever it slides. No
// feature line for all other vertices; with a tolerance, though, lines go on where curves bend.
geometry::FeatureLine feature_line_of(const mesh::QuadMesh &mesh, int vertex, double tolerance = 0);

// [vertex]; empty if no vertex may slide.
std::vector<geometry::FeatureLine> feature_lines_of(const mesh::QuadMesh &mesh, double tolerance = 0);

// Vertices of features that came to lie off their curve, as the middle of an edge does, go to it.
void keep_to_curves(mesh::QuadMesh &mesh);

// Where a feature runs back on itself along a line, so that quads at it are folded, its vertices are put in
// order: it stays the same set of points.
void straighten(mesh::QuadMesh &mesh);

// Vertices on features get no normals, see geometry::SurfacePositions: the surface would give them one of a
// side that chance chooses, and the quads on the other side would look ill-shaped. vertices: those of the
// mesh among the positions; quads use their places there.
void forget_normals(const mesh::QuadMesh &mesh, std::span<const int> vertices, geometry::Quads quads,
                    geometry::SurfacePositions &on_surface);

} // namespace alphamst::reference
