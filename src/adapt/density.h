// Where the faces of a whole mesh are to go.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "adapt/ground.h"
#include "adapt/locate.h"

namespace alphamst::adapt {

// Wanted faces per unit of area, but for a factor: by the vertex field "size" of the mesh as it was, or, on
// a curved surface without, as its curvature asks for.
class Density {
public:
    // Nothing if the mesh has no such field and is flat. That of a curved surface is written to the ground,
    // which must outlive this and stay where it is.
    static std::optional<Density> of(const mesh::QuadMesh &mesh, Ground &ground, std::int64_t wanted);

    // By a field of the caller.
    bool wished() const { return wished_; }

    double of_face(const mesh::QuadMesh &mesh, int face) const;

    // Of each face: its area times its density.
    std::vector<double> weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const;

private:
    explicit Density(const mesh::QuadMesh &mesh);
    Density(Ground &ground, const Density &field);
    Density(Ground &ground, std::int64_t wanted);

    double at(const Eigen::Vector3d &point) const;

    // In a plane: the mesh as it was, on the heap, as the tree of faces keeps its address.
    std::unique_ptr<const mesh::QuadMesh> mesh_;
    std::unique_ptr<const Faces> faces_;
    std::vector<double> size_;
    const Ground *ground_ = nullptr; // on a surface
    bool wished_ = true;
};

} // namespace alphamst::adapt
