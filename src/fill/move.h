// A small step between multiplicities of equal side lengths. All chords stand in arrays of one
// fixed length, so that eight can be taken at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace alphamst::fill {

constexpr std::size_t most_chords = 16;
using Eight = std::int16_t __attribute__((vector_size(16))); // of gcc and clang, for any processor

// By chord.
struct Lanes {
    Eight low{}, high{};
    std::int16_t operator[](std::size_t j) const { return j < 8 ? low[j] : high[j - 8]; }
    void set(std::size_t j, int value) {
        if (j < 8)
            low[j] = static_cast<std::int16_t>(value);
        else
            high[j - 8] = static_cast<std::int16_t>(value);
    }
};

// A change z, entries -2 to 2, of the multiplicities x:
// faces(x + t z) = faces(x) + t (slope . x) + t^2 curvature.
struct Move {
    // `product` as in Layout.
    Move(const std::vector<int> &change, const std::vector<std::vector<int>> &product);

    Lanes z{}, slope{};
    std::int64_t curvature = 0;
    // Masks: no bit set where z is 1, 2, -1, -2; all but the sign elsewhere.
    Lanes adds_one{}, adds_two{}, takes_one{}, takes_two{};
};

} // namespace alphamst::fill
