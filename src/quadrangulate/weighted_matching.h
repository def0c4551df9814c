// Matching of largest weight in small graphs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace alphamst::quadrangulate {

// Of largest cardinality, and if that leaves no node over, of largest weight: the primal-dual
// algorithm of Edmonds (1965) with an alternating tree from one free node after the other. What comes next,
// an edge that becomes tight or a blossom whose dual comes to 0, is in a queue (Galil, Micali and Gabow
// 1986); but blossoms are walked through, which takes time in proportion to nodes^2 for each tree at worst.
class WeightedMatching {
public:
    struct Edge {
        std::array<std::int32_t, 2> ends;
        std::int64_t weight;
    };

    WeightedMatching(std::size_t n_nodes, const std::vector<Edge> &edges);

    void run();
    std::int32_t edge_of(std::int32_t node) const {
        return mate_[static_cast<std::size_t>(node)];
    } // -1: free

private:
    enum class Label : std::uint8_t { none, outer, inner };

    // A node is a blossom without parts.
    struct Blossom {
        std::int32_t parent = -1, base = -1;
        std::int32_t enter = -1; // of an inner one: the edge from its tree
        Label label = Label::none;
        bool in_use = false;
        std::int64_t dual = 0, since = 0; // as it was at that time of the search under way
        std::vector<std::int32_t> parts,
            links; // links[i] leads from parts[i] to the next; the first part has the base
    };
    struct Event {
        std::int64_t when = 0;
        std::int32_t edge = -1, blossom = -1; // one of them, or none
        // By time; edge and blossom only make the order one.
        bool operator>(const Event &other) const {
            return std::tie(when, edge, blossom) > std::tie(other.when, other.edge, other.blossom);
        }
    };

    void search(std::int32_t root);
    Event next_event();
    void push(const Event &event);
    std::int64_t time_left(std::int32_t edge) const;
    void announce(std::int32_t blossom);
    std::int64_t dual(std::int32_t blossom) const;
    void settle(std::int32_t blossom);
    void label(std::int32_t blossom, Label label);
    void add_to_tree(std::int32_t blossom);
    void forget();
    void grow(std::int32_t outside, std::int32_t edge);
    void shrink(std::int32_t edge, const std::vector<std::int32_t> &first,
                const std::vector<std::int32_t> &second);
    void expand(std::int32_t blossom);
    void augment(std::int32_t edge);
    void alternate(std::int32_t node, std::int32_t added);
    void rotate(std::int32_t blossom, std::int32_t node);

    std::span<const std::int32_t> edges_at(std::size_t node) const {
        return {incident_.data() + first_[node], first_[node + 1] - first_[node]};
    }
    bool is_node(std::int32_t blossom) const { return static_cast<std::size_t>(blossom) < mate_.size(); }
    std::int32_t other_end(std::int32_t edge, std::int32_t node) const;
    std::int32_t top(std::int32_t edge, std::size_t end) const;
    std::int32_t end_in(std::int32_t edge, std::int32_t blossom) const;
    std::int32_t part_with(std::int32_t blossom, std::int32_t node) const;
    std::int32_t above(std::int32_t blossom) const;
    std::vector<std::int32_t> path_to_root(std::int32_t blossom) const;
    void set_top(std::int32_t blossom, std::int32_t top);
    std::int64_t slack(std::int32_t edge) const;

    std::vector<Edge> edges_;
    std::vector<std::int32_t> mate_; // the edge of each node
    std::vector<std::int32_t> top_;  // the outermost blossom around each node
    std::vector<std::size_t> first_; // of the edges at each node, in the next list
    std::vector<std::int32_t> incident_;
    std::vector<std::int32_t> tree_; // nodes that are in it or were
    std::vector<bool> in_tree_;
    std::vector<Blossom> blossoms_; // the nodes first
    std::int64_t now_ = 0;          // what the dual of the root has lost since the search began
    std::vector<Event> events_;     // a heap, the next one first
};

} // namespace alphamst::quadrangulate
