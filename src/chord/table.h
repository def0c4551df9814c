// What there is to know of each chord of a mesh, for a program to choose by.
#pragma once

#include <vector>

#include "chord/judge.h"

namespace alphamst::chord {

struct Row {
    int edge = -1; // the smallest one
    bool closed = false;
    int length = 0; // faces, those passed twice counted twice
    int crossings = 0, touches = 0;
    int singularities = 0;    // singular vertices at its edges
    std::int32_t reasons = 0; // why it cannot be collapsed; 0: it can
    int singular_after = 0;   // of the mesh without it; of the mesh as it is, where it must stay
};

// Rows in the order of Labels::first. Costs O(edges log edges).
std::vector<Row> table(const mesh::QuadMesh &mesh, const Rules &rules);

} // namespace alphamst::chord
