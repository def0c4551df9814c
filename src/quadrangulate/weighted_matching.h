// Matching of largest weight in small graphs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace alphamst::quadrangulate {

// Of largest cardinality, and if that leaves no node over, of largest weight: the primal-dual
// algorithm of Edmonds (1965) with an alternating tree from one free node after the other. Each event, be it
// an edge that becomes tight or a blossom whose dual comes to 0, looks at all edges of the tree, so that it
// takes time in proportion to nodes^2 * edges at worst: for some hundred nodes.
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
        std::int64_t dual = 0;
        std::vector<std::int32_t> parts,
            links; // links[i] leads from parts[i] to the next; the first part has the base
    };
    struct Event {
        std::int64_t delta = -1; // below 0: none
        std::int32_t edge = -1, blossom = -1;
    };

    void search(std::int32_t root);
    Event next_event() const;
    void change_duals(std::int64_t delta);
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
    std::vector<std::int32_t> mate_;                  // the edge of each node
    std::vector<std::int32_t> top_;                   // the outermost blossom around each node
    std::vector<std::vector<std::int32_t>> edges_at_; // of each node
    std::vector<std::int32_t> tree_;                  // nodes that are in it or were
    std::vector<bool> in_tree_;
    std::vector<Blossom> blossoms_; // the nodes first
};

} // namespace alphamst::quadrangulate
