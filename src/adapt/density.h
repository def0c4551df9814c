// Where the faces of a whole mesh are to go.
#pragma once

#include <optional>
#include <vector>

#include "adapt/locate.h"

namespace alphamst::adapt {

// Wanted faces per unit of area, but for a factor, by the vertex field "size" of the mesh as it was.
class Density {
public:
    // Nothing if the mesh has no such field.
    static std::optional<Density> of(const mesh::QuadMesh &mesh);

    double at(const Eigen::Vector3d &point) const;

    // Of each face: its area times the density in its middle.
    std::vector<double> weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const;

private:
    explicit Density(const mesh::QuadMesh &mesh);

    // On the heap: the tree of faces keeps its address.
    std::unique_ptr<const mesh::QuadMesh> mesh_;
    std::unique_ptr<const Faces> faces_;
    std::vector<double> size_;
};

} // namespace alphamst::adapt
