// One vertex moved by one safeguarded Newton step.
#pragma once

#include "geometry/barrier.h"

namespace alphamst::geometry {

// A step may lower the worst corner of the star only down to this; see worst_corner.
using Floor = double;
constexpr Floor no_floor = -2;

// Where a step may lead: anywhere, or along the x-axis only.
enum class Freedom { plane, line };

// Lowers the barrier summed over the star. Returns the squared distance moved, 0 if the
// step was refused.
double relax(const Barrier &barrier, std::span<const Sector> star, Points &points, int vertex, Floor floor,
             Freedom freedom = Freedom::plane);

// Raises the worst corners of the star: lowers the sum of sin(angle)^-8 over its corners, all
// of which must be positive. The worst corner of the star does not fall below floor. The sum
// knows angles only and would let quads shrink to nothing, so no corner determinant falls below
// `smallest`, or below the present smallest if that is less.
double sharpen(std::span<const Sector> star, Points &points, int vertex, Floor floor, double smallest = 0,
               Freedom freedom = Freedom::plane);

} // namespace alphamst::geometry
