// One number for a sequence of others, the same on every platform.
#pragma once

#include <bit>
#include <cstdint>

namespace alphamst {

// 64-bit words, each stirred with the finalizer of splitmix64 (Steele, Lea and Flood 2014).
class Digest {
public:
    void add(std::uint64_t word) {
        state_ += word + 0x9e3779b97f4a7c15u;
        state_ = (state_ ^ (state_ >> 30)) * 0xbf58476d1ce4e5b9u;
        state_ = (state_ ^ (state_ >> 27)) * 0x94d049bb133111ebu;
        state_ ^= state_ >> 31;
    }
    void add(std::int32_t high, std::int32_t low) {
        add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 |
            static_cast<std::uint32_t>(low));
    }
    void add_real(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

} // namespace alphamst
