// What an entity owns of the mesh, on which a field that is conserved has a mean value: of a face the face,
// of a vertex a quarter of each face at it, between the middles of two edges and the centre (mean of the
// corners).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "failure.h"
#include "geometry/quad.h"
#include "mesh/quad_mesh.h"

namespace alphamst::transfer {

class Cells {
public:
    // The mesh must outlive this.
    Cells(const mesh::QuadMesh &mesh, Entity entity) : mesh_(mesh), entity_(entity) {}

    const mesh::QuadMesh &mesh() const { return mesh_; }
    Entity entity() const { return entity_; }
    int count() const;

    struct Part {
        int cell;
        geometry::Quad quad;
    };
    struct Parts {
        std::array<Part, 4> all;
        std::size_t count = 0;
        const Part *begin() const { return all.data(); }
        const Part *end() const { return all.data() + count; }
    };
    // What cells own of one face, which they cover together.
    Parts parts(int face) const;
    // Cells that own a part of one of the faces, ascending.
    std::vector<int> of(const std::vector<int> &faces) const;

    double area(int cell) const; // as AMST_METRIC_AREA, part by part
    struct Place {
        Eigen::Vector3d centroid, normal; // the normal is as long as the area
    };
    Place place(int cell) const;
    // Cells with a vertex in common; of vertices, with a face. None is beyond a line that parts faces: a
    // feature, a numbered edge or the border of a region, where fields may jump.
    std::vector<int> neighbours(int cell) const;

private:
    std::vector<geometry::Quad> quads(int cell) const;
    bool parted(int face, int other, std::size_t side) const;

    const mesh::QuadMesh &mesh_;
    Entity entity_;
};

} // namespace alphamst::transfer
