// The boundary of a mesh as curves, on which its vertices come and go.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mesh/quad_mesh.h"
#include "surface/boundary_curve.h"

namespace alphamst::reference {

using EdgeLength = std::function<double(const Eigen::Vector3d &)>; // that is wanted at a place

struct Boundary {
    std::shared_ptr<const surface::BoundaryCurves> curves; // the mesh at their left
    std::vector<surface::CurvePlace> places;               // [vertex] none inside
    // [vertex] Flagged ones, those where something ends on the curve or changes along it, and corners: where
    // it turns by more than 60 degrees (as features do, see mesh/feature.h), and does not turn back within
    // two of the edges that are wanted. All whose place is not known stay, too.
    std::vector<char> stays;

    bool may_go(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return places[v].curve >= 0 && stays[v] == 0;
    }
};

Boundary boundary_of(const mesh::QuadMesh &mesh, const EdgeLength &edge_length);

} // namespace alphamst::reference
