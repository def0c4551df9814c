// The cross field that a mesh keeps to, by places.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "reference/locate.h"

namespace alphamst::reference {

// A cross field by places: the face field "cross" of the mesh as it was or, if there is none, the one along
// its curvature, boundary and features.
class CrossField {
public:
    explicit CrossField(const mesh::QuadMesh &mesh);

    Eigen::Vector3d at(const Eigen::Vector3d &point) const;
    // Mean angle between the sides of quads and the nearest of the four directions there, 0 to 45 degrees.
    double alignment_error(std::span<const geometry::Quad> quads) const;

private:
    std::unique_ptr<const mesh::QuadMesh> mesh_; // on the heap: the tree of faces keeps its address
    std::vector<double> values_;                 // [face][3]
    std::unique_ptr<const FaceTree> faces_;
};

} // namespace alphamst::reference
