// The boundary of a mesh as curves, on which its vertices come and go.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "surface/boundary_curve.h"

namespace alphamst::reference {

using EdgeLength = std::function<double(surface::CurvePlace)>; // that is wanted there

struct Boundary {
    std::shared_ptr<const surface::BoundaryCurves> curves; // the mesh at their left
    std::vector<surface::CurvePlace> places;               // [vertex] none inside
    // [vertex] Flagged ones, those where something ends on the curve or changes along it, and corners: where
    // it turns by more than 60 degrees (as features do, see mesh/feature.h), and does not turn back within
    // two of the edges that are wanted. All whose place is not known stay, too.
    std::vector<char> stays;

    // What edges had at first around a place, smoothed: one short edge among long ones is an accident.
    double present_length(surface::CurvePlace place) const;
    struct Length {
        double along, log; // from the first point of the curve to the middle of the edge
    };
    std::vector<std::vector<Length>> lengths; // [curve][edge], in order

    // Whether an edge between two vertices may become others: it is on a curve and not FIXED.
    bool may_change(const mesh::QuadMesh &mesh, int v, int w) const;
    // Whether the straight line between two places misses the curve by no more than that, and meets no other
    // part of the boundary.
    bool keeps_curve(surface::CurvePlace from, double length, double most) const;
    // Vertices of the mesh were renumbered, in this order; now there are so many.
    void follow(std::span<const std::array<int, 2>> moved, int n_vertices);
    bool may_go(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return places[v].curve >= 0 && stays[v] == 0;
    }
};

// [curve][vertex], the mesh at their left.
std::vector<std::vector<int>> boundary_cycles(const mesh::QuadMesh &mesh);
// The curves that the boundary runs along as it is.
std::shared_ptr<const surface::BoundaryCurves> curves_of_boundary(const mesh::QuadMesh &mesh);
// All vertices of the boundary are on the curves, in order.
bool is_on(const mesh::QuadMesh &mesh, const surface::BoundaryCurves &curves);

// On the curves that the mesh keeps to, or on those of its boundary as it is. longer: times so much edges are
// to be as long as they are.
Boundary boundary_of(const mesh::QuadMesh &mesh, double longer);

} // namespace alphamst::reference
