// Why arrays are no mesh: all that is wrong with them, for the user to mend at once.
#pragma once

#include <optional>

#include "failure.h"
#include "mesh/sides.h"

namespace alphamst::mesh {

// A sentence for each kind of defect, which names the first of them and says how many there are; the fault
// and the place are those of the first kind. Without points those of their shape are not looked for.
// Triangles only where they are allowed. Slow: for arrays that were found to be wrong.
Failure find_defects(Coordinates points, Faces faces, std::size_t n_vertices, bool triangles);

// The same of all that turning faces over does not mend; nothing if that is all.
std::optional<Failure> find_lasting_defects(Coordinates points, Faces faces);

} // namespace alphamst::mesh
