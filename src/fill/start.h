// First multiplicities of a template type for given side lengths: all else walks from there.
#pragma once

#include <optional>
#include <vector>

#include "fill/closed_form.h"
#include "fill/layout.h"

namespace alphamst::fill {

// The order in which the chords get their copies: those of the tightest sides first.
std::vector<Layout::Turn> start_order(const Layout &type);

// Multiplicities >= 1 with these side lengths, near the middle of what is possible.
std::optional<Multiplicities> start(const Layout &type, const Sides &sides);

} // namespace alphamst::fill
