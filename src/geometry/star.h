// The faces around every vertex as one flat array: what a sweep over vertices reads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/embed.h"

namespace alphamst::geometry {

// A quad seen from one of its vertices, counter-clockwise.
struct Sector {
    int next, opposite, previous, quad;
};

class Stars {
public:
    Stars(Quads quads, int vertices);

    int vertices() const { return static_cast<int>(first_.size()) - 1; }
    std::span<const Sector> at(int v) const {
        const auto i = static_cast<std::size_t>(v);
        return {sectors_.data() + first_[i], sectors_.data() + first_[i + 1]};
    }

private:
    std::vector<std::size_t> first_;
    std::vector<Sector> sectors_;
};

// A disk of quads on which positions are sought.
struct Problem {
    Quads quads;
    const Stars &stars;
    std::span<const char> fixed;  // [vertex]
    std::span<const double> area; // [quad] wanted area
};

// Vertices whose star holds a vertex of the set, and the set itself; `layers` times.
// Only free ones are kept. member is the set as flags and is brought up to date.
void grow(const Stars &stars, std::span<const char> fixed, int layers, std::vector<int> &set,
          std::vector<char> &member);

} // namespace alphamst::geometry
