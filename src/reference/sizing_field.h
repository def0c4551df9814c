// Where the faces of a whole mesh are to go.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "reference/locate.h"
#include "reference/reference.h"

namespace alphamst::reference {

// Wanted faces per unit of area, but for a factor: by the vertex field "size" of the mesh as it was, or, on
// a curved surface without, as its curvature asks for.
class SizingField {
public:
    // Nothing if the mesh has no such field and is flat. That of a curved surface is written to the
    // reference, which must outlive this and stay where it is.
    static std::optional<SizingField> of(const mesh::QuadMesh &mesh, Reference &reference,
                                         std::int64_t wanted);

    // By a field of the caller.
    bool wished() const { return wished_; }

    double of_face(const mesh::QuadMesh &mesh, int face) const;
    // In a plane, but for a factor: of edges that are wanted at a place.
    double edge_length(const Eigen::Vector3d &place) const { return 1 / std::sqrt(at(place)); }
    // In a plane, of any quad: its area times its density.
    double weight(const geometry::Quad &quad) const;

    // Of each face: its area times its density.
    std::vector<double> weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const;
    // Of all faces together.
    double total(const mesh::QuadMesh &mesh) const;

private:
    // sizes: [vertex of the mesh]
    SizingField(std::shared_ptr<const mesh::QuadMesh> mesh, std::vector<double> sizes, bool wished);
    SizingField(Reference &reference, const SizingField &field);
    SizingField(Reference &reference, std::int64_t wanted);

    double at(const Eigen::Vector3d &point) const;

    // In a plane: the mesh as it was, on the heap, as the tree of faces keeps its address.
    std::shared_ptr<const mesh::QuadMesh> mesh_;
    std::unique_ptr<const FaceTree> faces_;
    std::vector<double> size_;
    const Reference *reference_ = nullptr; // on a surface
    bool wished_ = true;
};

} // namespace alphamst::reference
