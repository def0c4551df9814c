// Edges along a cross field.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "adapt/ground.h"
#include "adapt/locate.h"

namespace alphamst::adapt {

// A cross field by places: the face field "cross" of the mesh as it was or, if there is none, the one along
// its curvature, boundary and features.
class Crosses {
public:
    explicit Crosses(const mesh::QuadMesh &mesh);

    Eigen::Vector3d at(const Eigen::Vector3d &point) const;
    // Mean angle between the sides of quads and the nearest of the four directions there, 0 to 45 degrees.
    double straying(std::span<const Quad> quads) const;

private:
    std::unique_ptr<const mesh::QuadMesh> mesh_; // on the heap: the tree of faces keeps its address
    std::vector<double> values_;                 // [face][3]
    std::unique_ptr<const Faces> faces_;
};

// Turns the faces of the whole curved mesh as far towards the field as their connectivity, their shapes and
// the cover of the surface allow.
void align(mesh::QuadMesh &mesh, Ground &ground, const Crosses &crosses, const Settings &settings);

} // namespace alphamst::adapt
