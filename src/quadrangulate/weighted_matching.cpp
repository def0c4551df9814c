#include "quadrangulate/weighted_matching.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "index.h"

namespace alphamst::quadrangulate {

// Weights are doubled and duals of nodes begin at such even numbers, so that those of the outer nodes of a
// tree are all even or all odd and half of the slack between two of them is a whole number.
WeightedMatching::WeightedMatching(std::size_t n_nodes, const std::vector<Edge> &edges)
    : edges_(edges), mate_(n_nodes, -1), top_(n_nodes), first_(n_nodes + 1), in_tree_(n_nodes),
      blossoms_(2 * n_nodes) {
    for (std::size_t v = 0; v < n_nodes; ++v) {
        top_[v] = blossoms_[v].base = static_cast<std::int32_t>(v);
        blossoms_[v].in_use = true;
        blossoms_[v].dual = std::numeric_limits<std::int64_t>::min();
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        edges_[e].weight *= 2;
        for (const std::int32_t v : edges_[e].ends) {
            blossoms_[at(v)].dual = std::max(blossoms_[at(v)].dual, edges_[e].weight);
            ++first_[at(v) + 1];
        }
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    incident_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < edges_.size(); ++e)
        for (const std::int32_t v : edges_[e].ends)
            incident_[next[at(v)]++] = static_cast<std::int32_t>(e);
    for (Blossom &blossom : blossoms_) // nodes without edges
        if (blossom.dual == std::numeric_limits<std::int64_t>::min())
            blossom.dual = 0;
}

// Duals are lowered first to where an edge is tight, which leaves few nodes to be searched from.
void WeightedMatching::run() {
    for (std::size_t v = 0; v < mate_.size(); ++v) {
        const std::span<const std::int32_t> incident = edges_at(v);
        if (mate_[v] >= 0 || incident.empty())
            continue;
        std::int64_t least = slack(incident.front());
        for (const std::int32_t e : incident)
            least = std::min(least, slack(e));
        blossoms_[v].dual -= least;
        for (const std::int32_t e : incident)
            if (const std::int32_t w = other_end(e, static_cast<std::int32_t>(v));
                mate_[v] < 0 && mate_[at(w)] < 0 && slack(e) == 0)
                mate_[v] = mate_[at(w)] = e;
    }
    for (std::size_t v = 0; v < mate_.size(); ++v)
        if (mate_[v] < 0)
            search(static_cast<std::int32_t>(v));
}

// Grows a tree until it meets another free node.
void WeightedMatching::search(std::int32_t root) {
    now_ = 0;
    events_.clear();
    label(top_[at(root)], Label::outer);
    for (;;) {
        const Event event = next_event();
        if (event.edge < 0 && event.blossom < 0)
            break;
        if (event.blossom >= 0) {
            expand(event.blossom);
            continue;
        }
        const std::int32_t v = top(event.edge, 0), w = top(event.edge, 1);
        const bool is_outer = blossoms_[at(v)].label == Label::outer;
        if (is_outer && blossoms_[at(w)].label == Label::outer) {
            shrink(event.edge, path_to_root(v), path_to_root(w));
            continue;
        }
        const std::int32_t outside = is_outer ? w : v;
        if (mate_[at(blossoms_[at(outside)].base)] < 0) {
            augment(event.edge);
            break;
        }
        grow(outside, event.edge);
    }
    forget();
}

// Those that something else came before are still in the queue; what they are about comes again later.
WeightedMatching::Event WeightedMatching::next_event() {
    while (!events_.empty()) {
        std::ranges::pop_heap(events_, std::greater<>());
        const Event event = events_.back();
        events_.pop_back();
        now_ = event.when;
        if (event.blossom >= 0) {
            const Blossom &b = blossoms_[at(event.blossom)];
            if (b.in_use && b.parent < 0 && b.label == Label::inner && dual(event.blossom) == 0)
                return event;
        } else if (const std::int64_t left = time_left(event.edge); left == 0) {
            return event;
        }
    }
    return {};
}

void WeightedMatching::push(const Event &event) {
    events_.push_back(event);
    std::ranges::push_heap(events_, std::greater<>());
}

// Until the edge is tight, below 0 for one that does not become so.
std::int64_t WeightedMatching::time_left(std::int32_t edge) const {
    const std::int32_t v = top(edge, 0), w = top(edge, 1);
    const Label first = blossoms_[at(v)].label, second = blossoms_[at(w)].label;
    if (v == w || first == Label::inner || second == Label::inner ||
        (first == second && first != Label::outer))
        return -1;
    return first == second ? slack(edge) / 2 : slack(edge);
}

// What will come of a blossom whose label, or surroundings, have changed.
void WeightedMatching::announce(std::int32_t blossom) {
    if (blossoms_[at(top_[at(blossoms_[at(blossom)].base)])].label == Label::inner) {
        if (!is_node(blossom))
            push({now_ + dual(blossom) / 2, -1, blossom});
    } else if (is_node(blossom)) {
        for (const std::int32_t edge : edges_at(at(blossom)))
            if (const std::int64_t left = time_left(edge); left >= 0)
                push({now_ + left, edge, -1});
    } else {
        for (const std::int32_t part : blossoms_[at(blossom)].parts)
            announce(part);
    }
}

// Of a node or an outermost blossom at this time: duals in a tree change with it, at the rate of the label.
std::int64_t WeightedMatching::dual(std::int32_t blossom) const {
    const Blossom &b = blossoms_[at(blossom)];
    const Label label = is_node(blossom) ? blossoms_[at(top_[at(blossom)])].label : b.label;
    const std::int64_t change = label == Label::none    ? 0
                                : label == Label::outer ? now_ - b.since
                                                        : b.since - now_;
    return is_node(blossom) ? b.dual - change : b.dual + 2 * change;
}

// Before the label of an outermost blossom changes, or another comes around it.
void WeightedMatching::settle(std::int32_t blossom) {
    const auto settle_one = [&](std::int32_t b) {
        blossoms_[at(b)].dual = dual(b);
        blossoms_[at(b)].since = now_;
    };
    const auto settle_nodes = [&](std::int32_t b, const auto &self) -> void {
        if (is_node(b))
            return settle_one(b);
        for (const std::int32_t part : blossoms_[at(b)].parts)
            self(part, self);
    };
    settle_nodes(blossom, settle_nodes);
    if (!is_node(blossom))
        settle_one(blossom);
}

void WeightedMatching::label(std::int32_t blossom, Label label) {
    settle(blossom);
    blossoms_[at(blossom)].label = label;
    add_to_tree(blossom);
    announce(blossom);
}

void WeightedMatching::add_to_tree(std::int32_t blossom) {
    if (!is_node(blossom)) {
        for (const std::int32_t part : blossoms_[at(blossom)].parts)
            add_to_tree(part);
    } else if (!in_tree_[at(blossom)]) {
        in_tree_[at(blossom)] = true;
        tree_.push_back(blossom);
    }
}

void WeightedMatching::forget() {
    for (const std::int32_t node : tree_) {
        const std::int32_t b = top_[at(node)];
        in_tree_[at(node)] = false;
        if (blossoms_[at(b)].label == Label::none)
            continue;
        settle(b);
        blossoms_[at(b)].label = Label::none;
    }
    tree_.clear();
}

// A blossom joins the tree by the edge, together with its mate.
void WeightedMatching::grow(std::int32_t outside, std::int32_t edge) {
    label(outside, Label::inner);
    blossoms_[at(outside)].enter = edge;
    const std::int32_t base = blossoms_[at(outside)].base;
    label(top_[at(other_end(mate_[at(base)], base))], Label::outer);
}

// The paths from the ends of the edge, which are outer, to their first common blossom are one blossom now.
void WeightedMatching::shrink(std::int32_t edge, const std::vector<std::int32_t> &first,
                              const std::vector<std::int32_t> &second) {
    std::size_t n = first.size(), m = second.size();
    while (n > 1 && m > 1 && first[n - 2] == second[m - 2])
        --n, --m;
    const auto found = std::find_if(blossoms_.begin() + static_cast<std::ptrdiff_t>(mate_.size()),
                                    blossoms_.end(), [](const Blossom &blossom) { return !blossom.in_use; });
    const auto index = static_cast<std::int32_t>(found - blossoms_.begin());
    Blossom blossom;
    blossom.in_use = true;
    blossom.label = Label::outer;
    blossom.base = blossoms_[at(first[n - 1])].base;
    const auto link_up = [&](std::int32_t b) {
        return blossoms_[at(b)].label == Label::inner ? blossoms_[at(b)].enter
                                                      : mate_[at(blossoms_[at(b)].base)];
    };
    for (std::size_t i = n; i-- > 0;) {
        blossom.parts.push_back(first[i]);
        blossom.links.push_back(i > 0 ? link_up(first[i - 1]) : edge);
    }
    for (std::size_t i = 0; i + 1 < m; ++i) {
        blossom.parts.push_back(second[i]);
        blossom.links.push_back(link_up(second[i]));
    }
    blossom.since = now_;
    for (const std::int32_t part : blossom.parts) {
        settle(part);
        blossoms_[at(part)].parent = index;
    }
    *found = std::move(blossom);
    set_top(index, index);
    for (const std::int32_t part : found->parts)
        if (blossoms_[at(part)].label == Label::inner)
            announce(part);
}

// Of an inner blossom: its parts on the path of even length from where the tree enters to the base stay in
// the tree.
void WeightedMatching::expand(std::int32_t blossom) {
    settle(blossom);
    Blossom old = std::move(blossoms_[at(blossom)]);
    const std::int32_t enter = old.enter;
    const std::int32_t first = part_with(blossom, end_in(enter, blossom));
    blossoms_[at(blossom)] = {};
    for (const std::int32_t part : old.parts) {
        blossoms_[at(part)].parent = -1;
        blossoms_[at(part)].label = Label::none;
        blossoms_[at(part)].since = now_;
        set_top(part, part);
    }
    const std::size_t n = old.parts.size();
    std::size_t i =
        static_cast<std::size_t>(std::find(old.parts.begin(), old.parts.end(), first) - old.parts.begin());
    const bool forward = i % 2 == 1;
    std::int32_t edge = enter;
    for (;;) {
        Blossom &inner = blossoms_[at(old.parts[i])];
        inner.label = Label::inner;
        inner.enter = edge;
        if (i == 0)
            break;
        const std::size_t next = forward ? i + 1 : i - 1;
        blossoms_[at(old.parts[next])].label = Label::outer;
        edge = old.links[forward ? next : next - 1];
        i = forward ? (next + 1) % n : next - 1;
    }
    for (const std::int32_t part : old.parts)
        announce(part);
}

// The edge leads from the tree to a free node.
void WeightedMatching::augment(std::int32_t edge) {
    for (std::size_t end = 0; end < 2; ++end) {
        const std::int32_t node = edges_[at(edge)].ends[end], b = top_[at(node)];
        if (blossoms_[at(b)].label == Label::outer) {
            alternate(node, edge);
        } else {
            rotate(b, node);
            mate_[at(node)] = edge;
        }
    }
}

// Exchanges the edges of the path from the node to the root of the tree.
void WeightedMatching::alternate(std::int32_t node, std::int32_t added) {
    for (;;) {
        const std::int32_t outer = top_[at(node)], base = blossoms_[at(outer)].base;
        const std::int32_t removed = mate_[at(base)];
        rotate(outer, node);
        mate_[at(node)] = added;
        if (removed < 0)
            return;
        const std::int32_t inner = top_[at(other_end(removed, base))];
        added = blossoms_[at(inner)].enter;
        const std::int32_t inside = end_in(added, inner);
        rotate(inner, inside);
        mate_[at(inside)] = added;
        node = other_end(added, inside);
    }
}

// Makes the node the base of the blossom around it.
void WeightedMatching::rotate(std::int32_t blossom, std::int32_t node) {
    if (is_node(blossom))
        return;
    const std::int32_t part = part_with(blossom, node);
    rotate(part, node);
    Blossom &b = blossoms_[at(blossom)];
    const std::size_t n = b.parts.size();
    const auto first =
        static_cast<std::size_t>(std::find(b.parts.begin(), b.parts.end(), part) - b.parts.begin());
    const bool forward = first % 2 == 1;
    for (std::size_t i = first; i != 0;) {
        const std::size_t near = forward ? i + 1 : i - 1, far = forward ? (near + 1) % n : near - 1;
        const std::int32_t link = b.links[forward ? near : far];
        for (const std::size_t k : {near, far}) {
            const std::int32_t end = part_with(blossom, edges_[at(link)].ends[0]) == b.parts[k]
                                         ? edges_[at(link)].ends[0]
                                         : edges_[at(link)].ends[1];
            rotate(b.parts[k], end);
            mate_[at(end)] = link;
        }
        i = far;
    }
    std::rotate(b.parts.begin(), b.parts.begin() + static_cast<std::ptrdiff_t>(first), b.parts.end());
    std::rotate(b.links.begin(), b.links.begin() + static_cast<std::ptrdiff_t>(first), b.links.end());
    b.base = node;
}

std::int32_t WeightedMatching::other_end(std::int32_t edge, std::int32_t node) const {
    const auto [v, w] = edges_[at(edge)].ends;
    return v == node ? w : v;
}

std::int32_t WeightedMatching::top(std::int32_t edge, std::size_t end) const {
    return top_[at(edges_[at(edge)].ends[end])];
}

// The end of the edge in a blossom that no other one is around.
std::int32_t WeightedMatching::end_in(std::int32_t edge, std::int32_t blossom) const {
    return edges_[at(edge)].ends[top(edge, 0) == blossom ? 0 : 1];
}

std::int32_t WeightedMatching::part_with(std::int32_t blossom, std::int32_t node) const {
    std::int32_t part = node;
    while (blossoms_[at(part)].parent != blossom)
        part = blossoms_[at(part)].parent;
    return part;
}

// The next blossom towards the root of the tree, -1 at the root.
std::int32_t WeightedMatching::above(std::int32_t blossom) const {
    const Blossom &b = blossoms_[at(blossom)];
    if (b.label == Label::inner)
        return top_[at(other_end(b.enter, end_in(b.enter, blossom)))];
    const std::int32_t edge = mate_[at(b.base)];
    return edge < 0 ? -1 : top_[at(other_end(edge, b.base))];
}

std::vector<std::int32_t> WeightedMatching::path_to_root(std::int32_t blossom) const {
    std::vector<std::int32_t> path;
    for (; blossom >= 0; blossom = above(blossom))
        path.push_back(blossom);
    return path;
}

void WeightedMatching::set_top(std::int32_t blossom, std::int32_t top) {
    if (is_node(blossom)) {
        top_[at(blossom)] = top;
        return;
    }
    for (const std::int32_t part : blossoms_[at(blossom)].parts)
        set_top(part, top);
}

std::int64_t WeightedMatching::slack(std::int32_t edge) const {
    const auto [v, w] = edges_[at(edge)].ends;
    return dual(v) + dual(w) - 2 * edges_[at(edge)].weight;
}

} // namespace alphamst::quadrangulate
