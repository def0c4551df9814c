// The best pairing near what is not good in one.
#pragma once

#include <cstdint>
#include <span>

#include "quadrangulate/matching.h"

namespace alphamst::quadrangulate {

// Around each node without a mate, or with one along an edge of a stage above 0, the matching becomes the one
// of largest cardinality and least cost in a window of its nodes, any number of edges of one stage counting
// for less than one of the next; windows are larger where smaller ones do not help. As many nodes lead
// outside as before. Meshes of up to some hundred triangles are one window. sides_before: of each node after
// an earlier call, or empty; around what has not changed since no window is tried again.
void match_windows(const TriangleDual &dual, Matching &matching,
                   std::span<const std::int8_t> sides_before = {});

} // namespace alphamst::quadrangulate
