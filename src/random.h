// A small random sequence that is the same on every platform (splitmix64, Steele et al. 2014).
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace alphamst {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t operator()() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }

    // Fisher and Yates (1938). The one of the standard library differs between platforms.
    template <class Range> void shuffle(Range &range) {
        for (std::size_t i = std::size(range); i > 1; --i)
            std::swap(range[i - 1], range[(*this)() % i]);
    }
    // So much of a shuffle that so many places at the front have what a whole one could have there.
    template <class Range> void shuffle_front(Range &range, std::size_t places) {
        for (std::size_t i = 0; i < places; ++i)
            std::swap(range[i], range[i + (*this)() % (std::size(range) - i)]);
    }

private:
    std::uint64_t state_;
};

} // namespace alphamst
