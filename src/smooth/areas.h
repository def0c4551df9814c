// The areas that smoothing gives to faces.
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"
#include "reference/sizing_field.h"

namespace alphamst::smooth {

// Of each face: the mean over the faces around it, some layers deep; or, with a field "size" that is of the
// mesh as it is, the square of its size.
std::vector<double> local_areas(const mesh::QuadMesh &mesh);
std::vector<double> wished_areas(const mesh::QuadMesh &mesh, const std::vector<double> &sizes);

// By the density, so scaled that they sum up to the area of the mesh.
std::vector<double> wanted_areas(const mesh::QuadMesh &mesh, const reference::SizingField &density);

} // namespace alphamst::smooth
