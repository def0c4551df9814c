// From error to mesh: how long edges shall be so that an error is the same everywhere.
#pragma once

#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::reference {

// What sizes keep to.
struct SizeRules {
    double min_edge = 0;    // least and largest size,
    double max_edge = 0;    // 0: the extent of the mesh
    double gradation = 0.2; // growth over the length that it takes: 1.2 from one face to the next
    double error_order = 1; // the indicator is like the edge length to this power
    int buffer_layers = 2;  // of faces around each that get its size
};

struct Sizes {
    std::vector<double> of_vertex;
    double faces = 0; // what they ask for
};

// Each face asks for the size at which its indicator, [n_faces] >= 0, is the tolerance. The tolerance is
// raised until they ask for no more than `most` faces, 0: any number; tolerance 0: until they ask for as
// many.
Sizes sizes_from_indicator(const mesh::QuadMesh &mesh, std::span<const double> indicator, double tolerance,
                           double most, const SizeRules &rules);

} // namespace alphamst::reference
