// Fewer faces where no template fits: quads of the present filling are collapsed one by
// one (Tarini et al. 2010), the best for the valences first.
#pragma once

#include "fill/plan.h"

namespace alphamst::fill {

// Candidates with exactly request.faces faces, made from a filling of the same word; empty
// if that has no more faces than wanted or cannot be collapsed so far.
std::vector<Candidate> plan_by_collapse(const Request &request, const Filling &old);

} // namespace alphamst::fill
