// Triangles among quads that find each other through the quads.
#pragma once

#include "quadrangulate/cut.h"
#include "quadrangulate/pairing.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// Everything that a pairing refers to. Without a cut: the triangles among the faces given.
struct Paired {
    Cut cut;
    TriangleSides sides;
    Pairing pairing;
};

// Pairs once more near poor pairs and triangles that are left over, with the quads there cut in two, in some
// ways and within parts of the mesh that grow while that helps nothing. The rest stays.
void pair_through_quads(const Polygons &polygons, bool may_leave, Paired &paired);

} // namespace alphamst::quadrangulate
