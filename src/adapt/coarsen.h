// Fewer faces where no template fits: quads of the present filling are collapsed one by
// one (Tarini et al. 2010), the best for the valences first, no corner ever turned over.
#pragma once

#include <cstdint>
#include <optional>

#include "fill/plan.h"
#include "geometry/embed.h"

namespace alphamst::adapt {

// A filling and, where they are known, valid positions of its vertices.
struct Shape {
    fill::Filling filling;
    geometry::Points positions; // empty: unknown
};

struct Coarse {
    Shape shape;
    int singularities = 0; // as a request counts them
};

// `old` collapsed to request.faces faces; nothing if it cannot be. Different seeds give
// different ones.
std::optional<Coarse> coarsen(const fill::Request &request, const Shape &old, std::uint64_t seed);

} // namespace alphamst::adapt
