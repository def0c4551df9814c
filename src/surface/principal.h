// Principal directions: in which ways a surface bends most and least at each of its nodes.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "surface/cross_field.h"
#include "surface/rosy.h"

namespace alphamst::surface {

// A way in the surface, and how the normal of length one changes along it.
struct Bend {
    Eigen::Vector3d way, change;
};

// Half the difference of the principal curvatures, at twice the angle of a principal direction, which is
// the same one at all nodes. Of the second fundamental form that suits the bends best (Rusinkiewicz 2004);
// zero if they do not tell.
Complex deviation(const Frame &frame, std::span<const Bend> bends);

// Averages the deviations `rounds` times over each node and its neighbours, weighing the node as much as all
// of these: what changes from one node to the next is left out.
void average(const Links &links, std::vector<Complex> &deviations, int rounds);

} // namespace alphamst::surface
