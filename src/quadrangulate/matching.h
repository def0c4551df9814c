// Matching in a graph whose nodes have at most three edges, such as triangles that share sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "disjoint_sets.h"

namespace alphamst::quadrangulate {

// Place 3 * node + side is one end of an edge. An edge of a stage is used only where those of
// smaller stages do not suffice.
struct TriangleDual {
    static constexpr std::int32_t none = -1, outside = -2;
    static constexpr std::uint8_t stages = 5, never = 255;

    std::vector<std::int32_t> across; // the other end; outside: a node that takes this side needs no mate
    std::vector<float> cost;          // the same at both ends
    std::vector<std::uint8_t> stage;  // likewise

    std::size_t n_nodes() const { return across.size() / 3; }
};

// Of largest cardinality: after the cheapest edges that still fit, augmenting paths by the
// algorithm of Edmonds (1965) with blossoms in disjoint sets (Gabow 1976). Searches
// are cut short at first, so that most paths are; a search that ends without a path takes its
// nodes out of all later ones, as they cannot be on any.
class Matching {
public:
    explicit Matching(const TriangleDual &dual);

    void take(int node, int side) { side_[static_cast<std::size_t>(node)] = static_cast<std::int8_t>(side); }
    void take_cheapest(std::uint8_t stage);
    void augment(std::uint8_t stage); // to the largest with edges up to this stage
    // The same for one node at a time, between begin() and end(); false if it stays without a mate.
    void begin(std::uint8_t stage) { stage_ = stage; }
    bool augment_from(int node);
    void end();
    // Exchanges the edges of short alternating cycles while that lowers the cost, after
    // Lin and Kernighan (1973): every cycle that gains can be begun where all partial sums gain.
    void improve();

    const std::vector<std::int8_t> &sides() const { return side_; }
    int side(int node) const { return side_[static_cast<std::size_t>(node)]; } // -1: not matched
    int mate(int node) const; // -1: not matched, or to the outside

private:
    enum class Label : std::uint8_t { unseen, outer, inner, removed };

    bool search(int root, std::size_t most);
    bool grow(int outer, std::uint8_t stage);
    void contract(int v, int w, int base);
    int common_base(int v, int w);
    void touch(int node, Label label);
    void forget();
    void join(int v, int w);
    void flip(int node);

    struct Cycle {
        std::array<std::int32_t, 9> added{}; // places
        std::size_t n = 0, most = 0;
        double gain = 0;
    };
    void extend(int first, int node, double gain, Cycle &cycle, Cycle &best) const;
    double cost(int node) const;

    const TriangleDual &dual_;
    std::uint8_t stage_ = 0;
    std::vector<std::int8_t> side_;
    // Of the search under way, see search().
    std::vector<Label> label_;
    std::vector<std::int32_t> before_, queue_, touched_;
    DisjointSets blossoms_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t clock_ = 0;
};

} // namespace alphamst::quadrangulate
