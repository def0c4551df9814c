// Fewer faces where no template fits: quads of the present filling are collapsed one by
// one (Tarini et al. 2010), the best for the valences first.
#pragma once

#include "fill/plan.h"

namespace alphamst::fill {

// Candidates with exactly request.faces faces, made from request.old; empty if that is
// missing, has no more faces than wanted, or cannot be collapsed that far.
std::vector<Candidate> plan_by_collapse(const Request &request);

} // namespace alphamst::fill
