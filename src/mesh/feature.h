// Features: the sharp edges of a curved mesh, and the vertices where they make corners.
#pragma once

#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

struct Features {
    std::vector<int> edges, corners; // ascending
};

// The edges whose two faces have normals more than `angle` degrees apart, that of a face being the
// normal of its area vector; a face without area makes none. The corners are those of the curves of
// these edges and of those flagged as feature already: vertices with one or more than two of them, and
// those where a curve turns by more than 60 degrees, unless it runs straight back, as folded faces make it
// do.
Features find_features(const QuadMesh &mesh, double angle);

// On the boundary, or a feature: flagged as that, numbered or between two regions.
bool on_curve(const QuadMesh &mesh, int edge);

} // namespace alphamst::mesh
