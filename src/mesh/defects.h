// Why arrays are no mesh: all that is wrong with them, for the user to mend at once.
#pragma once

#include "failure.h"
#include "mesh/sides.h"

namespace alphamst::mesh {

// A sentence for each kind of defect, which names the first of them and says how many there are; the fault
// and the place are those of the first kind. Without points those of their shape are not looked for.
// Triangles only where they are allowed. Slow: for arrays that were found to be wrong.
Failure find_defects(Coordinates points, Faces faces, std::size_t n_vertices, bool triangles);

// Whether sides of a quad cross: its corners are listed as those of VTK's pixels, say. across: see neighbours.
bool sides_cross(Coordinates points, Faces faces, const std::vector<std::int32_t> &across, std::size_t face);

} // namespace alphamst::mesh
