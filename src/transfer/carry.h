// Fields follow the mesh through an operation.
#pragma once

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::transfer {

// Whether faces or edges are not all where they were when the origins of `after` were last reset.
bool reconnected(const mesh::QuadMesh &before, const mesh::QuadMesh &after);

// Gives `after` the fields of `before`, its origins telling what of `before` it is. Every entity that
// was there keeps its values, bit for bit; the rule of the field gives those of the new ones, out of
// the faces of `before` that were replaced or changed their shape (the changed ones, below):
//
//   drop      the field goes if the mesh was reconnected
//   inherit   the nearest entity of the changed faces, by points, midpoints and centroids
//   linear    (vertices) each changed face as two triangles; nearest point, so nothing is
//             extrapolated. In the plane linear functions come out as they were
//   conserve  (faces) averages weighted by geometry::overlap. A face that was there but changed its shape
//   counts
//             as new, so that the sum of value * area stays the same over each connected set of
//             changed faces. Where they are curved, the sum of the averages is not quite the old one:
//             the rest is spread in proportion to value * area
//
// Averages stay between their least and largest term. Costs O(changed log changed), and one look at
// every face. Throws before `after` has changed; `progress` is called before each field.
void carry(const mesh::QuadMesh &before, mesh::QuadMesh &after, const Progress &progress);

} // namespace alphamst::transfer
