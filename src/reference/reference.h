// What a mesh lies on: a plane, or a curved surface to which its vertices always come back.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/plane.h"
#include "geometry/surface_positions.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "reference/boundary.h"
#include "reference/surface_distance.h"
#include "settings.h"

namespace alphamst::reference {

class CrossField;
class RegionSizes;
class SizingField;

struct Reference {
    std::optional<geometry::Plane> plane;
    // Where there is no plane: the surface, and the triangle of it under each vertex of the mesh.
    std::shared_ptr<const surface::Surface> surface;
    std::vector<int> surface_triangles;
    const CrossField *cross_field = nullptr;   // to which edges shall turn, if there are any
    const SizingField *sizes = nullptr;        // of the caller, for patches; of windows in a plane
    const RegionSizes *region_sizes = nullptr; // of a region whose parts are patches; these come first
    double face_weight = 0;                    // by these sizes, of a face as it is wanted
    std::optional<Boundary> boundary;          // where its vertices may come and go, as edge_length wants it
    EdgeLength edge_length;
    // Patches that are flat lie in their plane, though the mesh keeps to a surface.
    bool planes_first = false;
    std::optional<SurfaceDistance> surface_distance; // where the whole of it is to stay covered
    // [triangle of the surface] wanted faces per unit of area, but for a factor; empty: even.
    std::vector<double> density;

    // The surface at all vertices, where there is no plane.
    geometry::SurfacePositions on_surface(const mesh::QuadMesh &mesh) const;
    // [quad] Wanted areas of quads on the surface, which sum up to theirs; empty: all equal.
    std::vector<double> areas(geometry::Quads quads, const geometry::SurfacePositions &on_surface) const;
    // [face]
    std::vector<double> scaled_jacobians(const mesh::QuadMesh &mesh) const;
};

// Of the whole mesh. Where that is curved and keeps to no surface yet, it does so from now on: to itself. Its
// features keep to their curves likewise.
Reference reference_of(mesh::QuadMesh &mesh);

// The triangle of the surface under each vertex.
std::vector<int> triangles_under(const mesh::QuadMesh &mesh, const surface::Surface &surface);

// For patches: the surface, where one of them is curved or the mesh keeps to one already.
Reference reference_of(const mesh::QuadMesh &mesh, std::span<const Patch> patches);

// The side from which the faces run counter-clockwise; nothing if they do not lie in a plane.
std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh, std::span<const int> faces);
std::optional<geometry::Plane> plane_of(const mesh::QuadMesh &mesh); // of all faces

// The surface at some vertices of the mesh.
geometry::SurfacePositions positions_on_surface(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                                                const std::vector<int> &surface_triangles,
                                                std::span<const int> vertices);
// Without triangles: the place whose normal agrees with that of the faces around the vertex.
surface::Spot spot_of(const mesh::QuadMesh &mesh, const surface::Surface &surface, int vertex);

} // namespace alphamst::reference
