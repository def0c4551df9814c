// Fields follow the mesh through an operation.
#pragma once

#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::transfer {

// Whether faces or edges are not all where they were when the origins of `after` were last reset.
bool reconnected(const mesh::QuadMesh &before, const mesh::QuadMesh &after);

// Brings the fields of `before` along to `after`, and those that `after` has in their place, with values for
// the entities of `before`. Origins tell what of that is there. Every entity that was there keeps its values,
// bit for bit, unless the rule of the field says otherwise; this gives those of the new ones, out of the
// faces of `before` that were replaced or changed their shape (the changed ones, below):
//
//   drop      the field goes if the mesh was reconnected
//   inherit   the nearest entity of the changed faces, by points, midpoints and centroids; of edges the
//             nearest on the boundary for those there, the nearest inside for those inside, of the same
//             number if there is one, and 0 where there is none at all
//   linear    (vertices, also where they have moved) each changed face as two triangles; nearest point.
//             In the plane linear functions come out as they were: beyond the boundary the triangle is
//             continued
//   conserve  (faces, vertices) see transfer/reconstruct.h. A cell that was there but changed its shape
//             counts as new, so that the sum of value * area stays the same over each connected set of
//             changed faces. Where they are curved, the sum of the means is not quite the old one: the
//             rest is spread in proportion to value * area
//   average   likewise, from constant values
//
// But for what is continued, and the rest, values stay between those that they are made of. Costs
// O(changed log changed), and one look at every face. Throws before `after` has changed; `progress` is called
// before each field.
void carry(const mesh::QuadMesh &before, mesh::QuadMesh &after, const Progress &progress);

} // namespace alphamst::transfer
