// The cross field of a mesh, a field of its faces: one of four directions at right angles that edges should
// have there. And how much its edges do.
#pragma once

#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "pace.h"

namespace alphamst::mesh {

// [faces][3], in the plane of the face and of length one. Along the edges of the boundary, of features and
// of borders of markers; where there are none along the principal directions of curvature, the more the
// curvatures differ there; and as smooth as that allows. For `sweeps` see surface::solve_cross_field.
std::vector<double> cross_field(const QuadMesh &mesh, int sweeps, const Pace &pace = {});

// Mean angle between the sides of faces and the nearest direction of the cross in the plane of the face,
// 0..45 degrees. Sides and directions without length do not count; 0 if none does.
double alignment(const QuadMesh &mesh, std::span<const double> crosses);

} // namespace alphamst::mesh
