// How much is given up, step by step, for faces that are missing.
#pragma once

#include <array>

namespace alphamst::adapt {

// What faces that are missing may cost, little by little: part of the shape that windows keep, singularities
// added, tolerance of the distance to the surface.
struct Level {
    double shape;
    int added;
    double tolerance;
};
constexpr std::array<Level, 3> on_way = {{{1, 2, 1}, {0.6, 4, 1.4}, {0.4, 8, 2}}}; // far from the count
constexpr std::array<Level, 3> mending = {{{1, 0, 1}, {0.3, 2, 1}, {0.1, 8, 3}}};
constexpr std::array<Level, 6> levels = {
    {{1, 0, 1}, {0.6, 0, 1.4}, {0.6, 2, 1.4}, {0.6, 4, 2}, {0.4, 8, 2}, {0.2, 16, 3}}};

} // namespace alphamst::adapt
