// One window of a whole-mesh sweep: a better filling, judged together with the faces around it,
// whose vertices may give way.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "refill/propose.h"

namespace alphamst::refill {

struct Place {
    std::vector<int> faces;  // of the window, ascending
    std::vector<int> buffer; // the faces around them
};

// Of some faces: smallest scaled Jacobian and shape (both Verdict's), and the numbers of poor and inverted
// quads. As a wish: how many quads may become poor for one singularity less.
struct ShapeBounds {
    double scaled_jacobian = 1, shape = 1, poor = 0;
    int inverted = 0;
};

struct Trial {
    Proposal proposal;
    std::vector<std::pair<int, OpenMesh::Vec3d>> moved; // vertices of the buffer and the loop
    // On a surface: the triangles under the new vertices and under the moved ones.
    std::vector<int> surface_triangles, moved_surface_triangles;
    // The samples of the window, or of window and buffer if that moves: their quads are those of the
    // filling, then of the buffer.
    std::vector<reference::SurfaceDistance::Owner> owners;
    double alignment_error = 0; // from the cross field of the reference, if there is one
    int singular_change = 0;    // those of the mesh boundary included
};

// The first filling, best numbers first, that meets the goal and is, together with the buffer, as
// shapely as wanted, or as it was before if that is less; of some with the same numbers the one along the
// cross field, if the reference has one. Nothing if there is none. The result depends on the arguments alone.
std::optional<Trial> attempt(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                             const ShapeBounds &wanted, const Settings &settings,
                             const reference::Reference &reference);

} // namespace alphamst::refill
