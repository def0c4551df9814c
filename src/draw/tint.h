// Colours of faces that are smaller or larger than they shall be.
#pragma once

#include <array>
#include <string>

namespace alphamst::draw {

using Colour = std::array<double, 3>; // red, green and blue, each in 0 .. 255

// `part` of the way from one to the other.
Colour mix(const Colour &from, const Colour &to, double part);
std::string text_of(const Colour &colour); // "#rrggbb"

// Of log2(area / wanted area): blue below 0, red above, nearly white at 0. What is farther than
// `strongest_error` from 0 has the colour of that.
inline constexpr double strongest_error = 2;
Colour tint(double error);

} // namespace alphamst::draw
