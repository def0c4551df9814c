#include "draw/tint.h"

#include <algorithm>
#include <cmath>

namespace alphamst::draw {
namespace {

// The ends of ColorBrewer's "RdBu", which eyes that confuse red and green tell apart.
constexpr Colour small{33, 102, 172}, right{247, 247, 247}, large{178, 24, 43};
constexpr double steps = 8; // from 0 to the strongest error; more are not told apart

} // namespace

Colour mix(const Colour &from, const Colour &to, double part) {
    Colour colour;
    for (std::size_t k = 0; k < 3; ++k)
        colour[k] = from[k] + part * (to[k] - from[k]);
    return colour;
}

std::string text_of(const Colour &colour) {
    std::string text = "#";
    for (const double value : colour) {
        const auto part = static_cast<unsigned>(std::lround(value));
        text += "0123456789abcdef"[part / 16];
        text += "0123456789abcdef"[part % 16];
    }
    return text;
}

Colour tint(double error) {
    const double part = std::isnan(error) ? 0 : std::clamp(error / strongest_error, -1.0, 1.0);
    return mix(right, part < 0 ? small : large, std::round(std::abs(part) * steps) / steps);
}

} // namespace alphamst::draw
