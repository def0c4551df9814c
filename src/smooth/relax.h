// Smoothing of a whole mesh that keeps coarse regions coarse and fine ones fine, or makes them so.
#pragma once

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "reference/reference.h"
#include "reference/sizing_field.h"
#include "settings.h"

namespace alphamst::smooth {

// Moves all vertices that may move, on a surface also along straight features. The smallest scaled Jacobian
// of the mesh never falls, and no corner inverts.
void relax_by_sizes(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const std::optional<reference::SizingField> &density, const Settings &settings);

// The same to the end: in a plane with a density sizes come as near as the connectivity lets them. No face
// that had a scaled Jacobian of a half gets below that, and none of less gets worse.
void settle_by_sizes(mesh::QuadMesh &mesh, reference::Reference &reference,
                     const std::optional<reference::SizingField> &density, const Settings &settings);

// Moves all vertices of a curved mesh that may move, over the surface, so that the faces come nearer to it
// between them; shapes may suffer, but no scaled Jacobian falls below 0.3 by that.
void fit_to_surface(mesh::QuadMesh &mesh, reference::Reference &reference,
                    const std::optional<reference::SizingField> &density, const Settings &settings);

// 1 for vertices that do not move freely, those of flat faces among them.
std::vector<char> constrained_vertices(const mesh::QuadMesh &mesh);
// Whether an edge of the face has no length, as at a pole: nothing opens it, and others would pay for trying.
bool is_flat(const mesh::QuadMesh &mesh, int face);

// Moves the vertices of a curved mesh from where they are, `start`, to `on_surface`; where that spoils quads
// or uncovers the surface they stay, and so do those on feature lines that would come past each other. False
// if all do.
bool accept_or_roll_back(mesh::QuadMesh &mesh, reference::Reference &reference,
                         const geometry::SurfacePositions &start, geometry::SurfacePositions &on_surface,
                         const geometry::Run &run, std::span<const geometry::FeatureLine> feature_lines = {});

} // namespace alphamst::smooth
