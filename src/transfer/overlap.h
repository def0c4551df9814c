// Which cells of a mesh cover which of another one.
#pragma once

#include <vector>

#include "reference/locate.h"
#include "transfer/cell.h"

namespace alphamst::transfer {

struct Overlap {
    int before, after; // cells
    double area;
    Eigen::Vector3d centroid;
};

// The overlaps of the parts that the cells have of some faces of both meshes; those of `before` are in the
// tree. In the order of these faces of `after`, then of those of `before`. Costs O((n + overlaps) log n).
std::vector<Overlap> overlaps(const Cells &before, const reference::FaceTree &tree, const Cells &after,
                              const std::vector<int> &faces);

// Those of all faces of two meshes.
std::vector<Overlap> overlaps(const mesh::QuadMesh &before, const mesh::QuadMesh &after);

} // namespace alphamst::transfer
