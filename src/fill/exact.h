// The exact filler: every face count that fillings of a boundary word with given
// numbers of valence-3 and valence-5 vertices can have, and the fillings themselves.
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>

#include "fill/filling.h"

namespace alphamst::fill {

constexpr int most_faces = 255; // largest face count the exact filler looks at
constexpr int longest_word = 64;

using FaceSet = std::bitset<most_faces + 1>; // bit f: a filling with f faces exists

// A search that grew past its limit; the answer is unknown.
struct TooHard {};

// Advancing front with memory: a quad is laid on a fixed front edge in every possible
// way, and equal fronts are solved once. Complete for every word with letters 1 to 4 and
// interior valences 3, 4 and 5, so a missing face count is a proof.
class ExactFiller {
public:
    // node_limit bounds the quads laid by all searches of this object.
    explicit ExactFiller(std::int64_t node_limit);
    ~ExactFiller();
    ExactFiller(const ExactFiller &) = delete;
    ExactFiller &operator=(const ExactFiller &) = delete;

    // Face counts up to `most` of fillings with exactly v3 and v5 singularities.
    // Throws TooHard, also for words longer than longest_word and for v3 > 8.
    FaceSet faces(const Word &word, int v3, int v5, int most);

    // One filling with exactly these numbers; different seeds may give different ones.
    // Throws TooHard; nothing if there is none.
    std::optional<Filling> fill(const Word &word, int v3, int v5, int faces, std::uint64_t seed);

    std::int64_t nodes() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

// 4 - sum of (2 - letter): valence-3 minus valence-5 vertices of every filling.
int index(const Word &word);

} // namespace alphamst::fill
