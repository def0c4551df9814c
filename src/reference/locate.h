// Where a point is among faces or other points: a tree of boxes finds the few that are near.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "geometry/quad.h"
#include "mesh/quad_mesh.h"

namespace alphamst::reference {

geometry::Quad quad_of(const mesh::QuadMesh &mesh, int face);
Eigen::Vector3d point_of(const mesh::QuadMesh &mesh, int vertex);

// Of equally near ones the first in the order given is taken, so that answers do not depend on the
// tree. A question costs O(log n).
class PointTree {
public:
    explicit PointTree(std::vector<Eigen::Vector3d> points); // at least one
    ~PointTree();
    std::size_t nearest(const Eigen::Vector3d &point) const; // its place in the order given

private:
    struct Tree;
    std::vector<Eigen::Vector3d> points_;
    std::unique_ptr<const Tree> tree_;
};

class FaceTree {
public:
    // At least one face; the mesh must outlive this.
    FaceTree(const mesh::QuadMesh &mesh, std::vector<int> faces);
    ~FaceTree();

    struct Place {
        int face;
        geometry::QuadPoint spot;
    };
    Place nearest(const Eigen::Vector3d &point) const;
    // The faces whose boxes meet that of the quad, made an eighth wider, ascending.
    void around(const geometry::Quad &quad, std::vector<int> &found) const;

private:
    struct Tree;
    const mesh::QuadMesh &mesh_;
    std::unique_ptr<const Tree> tree_;
};

} // namespace alphamst::reference
