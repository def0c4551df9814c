// What a mesh lies on: a plane, or a curved surface to which its vertices always come back.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "adapt/adapt.h"
#include "adapt/coverage.h"
#include "geometry/drape.h"
#include "geometry/plane.h"
#include "mesh/quad_mesh.h"

namespace alphamst::adapt {

class Crosses;

struct Ground {
    std::optional<geometry::Plane> plane;
    // Where there is no plane: the surface, and the triangle of it under each vertex of the mesh.
    std::shared_ptr<const surface::Surface> surface;
    std::vector<int> anchors;
    const Crosses *crosses = nullptr; // to which edges shall turn, if there are any
    std::optional<Coverage> coverage; // where the whole of it is to stay covered
    // [triangle of the surface] wanted faces per unit of area, but for a factor; empty: even.
    std::vector<double> density;

    // The surface at all vertices, where there is no plane.
    geometry::Drape drape(const mesh::QuadMesh &mesh) const;
    // [quad] Wanted areas of quads on the surface, which sum up to theirs; empty: all equal.
    std::vector<double> areas(geometry::Quads quads, const geometry::Drape &drape) const;
    // [face]
    std::vector<double> scaled_jacobians(const mesh::QuadMesh &mesh) const;
};

// Of the whole mesh. Where that is curved and keeps to no surface yet, it does so from now on: to itself. Its
// features keep to their curves likewise.
Ground ground_of(mesh::QuadMesh &mesh);

// For patches: the surface, where one of them is curved or the mesh keeps to one already.
Ground ground_of(const mesh::QuadMesh &mesh, std::span<const Region> patches);

// The side from which the faces run counter-clockwise; nothing if they do not lie in a plane.
std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh, std::span<const int> faces);

// The surface at some vertices of the mesh.
geometry::Drape drape_of(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                         const std::vector<int> &anchors, std::span<const int> vertices);
// Without anchors: the place whose normal agrees with that of the faces around the vertex.
surface::Spot spot_of(const mesh::QuadMesh &mesh, const surface::Surface &surface, int vertex);

} // namespace alphamst::adapt
