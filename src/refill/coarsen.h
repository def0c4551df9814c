// Fewer faces where no template fits: quads of the present filling are collapsed one by
// one (Tarini et al. 2010), the best for the valences first, no corner ever inverted.
#pragma once

#include <cstdint>
#include <optional>

#include "fill/plan.h"
#include "geometry/embed.h"

namespace alphamst::refill {

// A filling and, where they are known, valid positions of its vertices.
struct PlacedFilling {
    fill::Filling filling;
    geometry::Points positions; // empty: unknown
};

struct Coarse {
    PlacedFilling shape;
    int singularities = 0; // as a request counts them
};

// `old` collapsed to request.faces faces; nothing if it cannot be. Different seeds give
// different ones.
std::optional<Coarse> coarsen(const fill::Request &request, const PlacedFilling &old, std::uint64_t seed);
// The same, but with more faces where quads can collapse no further; nothing if none can.
std::optional<Coarse> coarsen_towards(const fill::Request &request, const PlacedFilling &old,
                                      std::uint64_t seed);

} // namespace alphamst::refill
