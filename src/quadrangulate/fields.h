// Fields of polygons, for the quads that are made of them.
#pragma once

#include "mesh/field.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// Vertices that were given keep their values; a new one has those of the place next to it on the face given
// that its first quad is of, linear on triangles, and with INHERIT those of the nearest corner. A quad has
// the values of its face; one of two triangles with INHERIT those of its first, else their mean by area.
// There are no fields of edges.
mesh::Fields fields_of(const Polygons &given, const mesh::Fields &fields, const QuadArrays &quads);

} // namespace alphamst::quadrangulate
