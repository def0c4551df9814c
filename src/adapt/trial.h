// One window of a whole-mesh sweep: a better filling, judged together with the faces around it,
// whose vertices may give way.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "adapt/propose.h"

namespace alphamst::adapt {

struct Place {
    std::vector<int> faces; // of the window, ascending
    std::vector<int> rim;   // the faces around them
};

// Of some faces: smallest scaled Jacobian and shape (both Verdict's), and the numbers of poor and inverted
// quads. As a wish: how many quads may become poor for one singularity less.
struct Shapeliness {
    double scaled_jacobian = 1, shape = 1, poor = 0;
    int inverted = 0;
};

struct Trial {
    Proposal proposal;
    std::vector<std::pair<int, OpenMesh::Vec3d>> moved; // vertices of the rim and the loop
    // On a surface: the triangles under the new vertices and under the moved ones.
    std::vector<int> anchors, moved_anchors;
    // The samples of the window, or of window and rim if that moves: their quads are those of the
    // filling, then of the rim.
    std::vector<Coverage::Owner> owners;
    double straying = 0;     // from the cross field of the ground, if there is one
    int singular_change = 0; // those of the mesh boundary included
};

// The first filling, best numbers first, that meets the goal and is, together with the rim, as
// shapely as wanted, or as it was before if that is less; of some with the same numbers the one along the
// cross field, if the ground has one. Nothing if there is none. The result depends on the arguments alone.
std::optional<Trial> attempt(const mesh::QuadMesh &mesh, const Place &place, const Goal &goal,
                             const Shapeliness &wanted, const Settings &settings, const Ground &ground);

} // namespace alphamst::adapt
