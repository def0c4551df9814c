// A disk of faces that is to be replaced: what goes and what stays at its rim, and whether new quads fit
// there.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

struct OldDisk {
    std::vector<int> faces, edges, vertices; // that go, ascending
    std::vector<int> sides; // [loop] from here to the next vertex, the disk at the left; -1: new
    // Where edges of the loop are new, the old sides, the disk at their left, one at most from each vertex;
    // nothing beyond the boundary was at them.
    std::vector<int> rim;
    int rim_side(const Kernel &kernel, int vertex) const; // the one from there, -1 if there is none
};

// What replace_disk has to know of its loop and faces. Throws Failure (internal) if they are no disk, or if
// vertices of the loop come or go elsewhere than on the boundary of the mesh.
OldDisk find_disk(const Kernel &kernel, std::span<const int> faces, std::span<const int> loop,
                  std::span<const int> parents);

// For each corner of the quads (4 * quad + i) the one whose side is the same edge from the other end, -1 on
// the loop. Throws Failure (internal) if the quads are no disk within such a loop, or if an edge of theirs
// would double one outside the disk.
std::vector<int> fit_quads(const QuadMesh &mesh, const OldDisk &disk, std::span<const int> loop,
                           std::span<const std::array<int, 4>> quads, int n_vertices);

} // namespace alphamst::mesh
