// The boundary as the caller knows it: a projection to it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "mesh/quad_mesh.h"
#include "reference/boundary.h"

namespace alphamst::reference {

// The points on the boundary that belong to others, each with the marker of the edge that it is on or near.
// Throws Failure (projection).
using Project = std::function<std::vector<Eigen::Vector3d>(std::span<const std::int32_t> markers,
                                                           const std::vector<Eigen::Vector3d> &points)>;

// Gives the mesh the curves of its boundary, unless it is still on those that it has: its edges, or with a
// projection finer ones between its vertices. tolerance: in edges, how far from these the projection may be.
// Throws Failure (projection).
void keep_boundary(mesh::QuadMesh &mesh, const Project &project, double tolerance);

// Brings the vertices of the boundary that are new to where the projection has them. Throws Failure
// (projection) where that is too far off or turns a face over.
void project_new_vertices(mesh::QuadMesh &mesh, const Project &project, double tolerance);

} // namespace alphamst::reference
