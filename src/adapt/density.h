// Where the faces of a whole mesh are to go.
#pragma once

#include <optional>
#include <vector>

#include "adapt/ground.h"
#include "adapt/locate.h"

namespace alphamst::adapt {

// Wanted faces per unit of area, but for a factor: by the vertex field "size" of the mesh as it was, or, on
// a curved surface, as its curvature asks for.
class Density {
public:
    // Nothing if the mesh has no such field and is flat. The ground must outlive this.
    static std::optional<Density> of(const mesh::QuadMesh &mesh, const Ground &ground, std::int64_t wanted);

    // By a field of the caller.
    bool wished() const { return ground_ == nullptr; }

    double of_face(const mesh::QuadMesh &mesh, int face) const;

    // Of each face: its area times its density.
    std::vector<double> weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const;

private:
    explicit Density(const mesh::QuadMesh &mesh);
    Density(const Ground &ground, std::int64_t wanted);

    double at(const Eigen::Vector3d &point) const;

    // By field. On the heap: the tree of faces keeps its address.
    std::unique_ptr<const mesh::QuadMesh> mesh_;
    std::unique_ptr<const Faces> faces_;
    std::vector<double> size_;
    // By curvature.
    const Ground *ground_ = nullptr;
    std::vector<double> density_; // [triangle of the surface]
};

} // namespace alphamst::adapt
