#include "quadrangulate/matching.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "index.h"

namespace alphamst::quadrangulate {
namespace {

constexpr std::size_t all = std::numeric_limits<std::size_t>::max();

std::size_t place(int node, int side) { return 3 * at(node) + at(side); }

} // namespace

Matching::Matching(const TriangleDual &dual)
    : dual_(dual), side_(dual.n_nodes(), -1), label_(dual.n_nodes(), Label::unseen),
      before_(dual.n_nodes(), -1), blossoms_(dual.n_nodes()), seen_(dual.n_nodes()) {}

int Matching::mate(int node) const {
    if (side_[at(node)] < 0)
        return -1;
    const std::int32_t across = dual_.across[place(node, side_[at(node)])];
    return across < 0 ? -1 : across / 3;
}

void Matching::take_cheapest(std::uint8_t stage) {
    std::vector<std::pair<float, std::int32_t>> edges;
    for (std::size_t p = 0; p < dual_.across.size(); ++p)
        if (dual_.across[p] > static_cast<std::int32_t>(p) && dual_.stage[p] <= stage)
            edges.emplace_back(dual_.cost[p], static_cast<std::int32_t>(p));
    std::sort(edges.begin(), edges.end());
    for (const auto &[cost, p] : edges) {
        const std::int32_t q = dual_.across[at(p)];
        if (side_[at(p / 3)] < 0 && side_[at(q / 3)] < 0) {
            take(p / 3, p % 3);
            take(q / 3, q % 3);
        }
    }
}

void Matching::augment(std::uint8_t stage) {
    stage_ = stage;
    std::vector<std::int32_t> free;
    for (std::size_t node = 0; node < side_.size(); ++node)
        if (side_[node] < 0)
            free.push_back(static_cast<std::int32_t>(node));
    for (const std::size_t most : {std::size_t{16}, std::size_t{128}, std::size_t{1024}, all})
        std::erase_if(free, [&](std::int32_t node) { return side_[at(node)] >= 0 || search(node, most); });
    end();
}

bool Matching::augment_from(int node) { return side_[at(node)] >= 0 || search(node, all); }

void Matching::end() { std::fill(label_.begin(), label_.end(), Label::unseen); }

// A tree of alternating paths from the root: outer nodes are at the end of paths of even
// length, inner ones of odd length. before_ is the node before an inner one; for a contracted
// blossom stands the outer node that it counts as.
bool Matching::search(int root, std::size_t most) {
    if (label_[at(root)] == Label::removed)
        return false;
    queue_.clear();
    touch(root, Label::outer);
    queue_.push_back(root);
    // Edges of smaller stages come first, so that the path has few of the others.
    std::array<std::size_t, TriangleDual::stages> head{};
    for (;;) {
        const std::size_t end = std::min(queue_.size(), most);
        std::uint8_t stage = 0;
        while (stage <= stage_ && head[stage] >= end)
            ++stage;
        if (stage > stage_)
            break;
        if (grow(queue_[head[stage]++], stage)) {
            forget();
            return true;
        }
    }
    if (queue_.size() <= most) { // a Hungarian tree
        for (const std::int32_t node : touched_) {
            label_[at(node)] = Label::removed;
            blossoms_.separate(node);
        }
        touched_.clear();
    }
    forget();
    return false;
}

// Looks along the edges of one stage at an outer node; true if that completed a path.
bool Matching::grow(int outer, std::uint8_t stage) {
    for (int side = 0; side < 3; ++side) {
        const std::size_t p = place(outer, side);
        if (dual_.stage[p] != stage)
            continue;
        if (dual_.across[p] == TriangleDual::outside) {
            const int before = mate(outer);
            take(outer, side);
            flip(before);
            return true;
        }
        const int node = dual_.across[p] / 3;
        switch (label_[at(node)]) {
        case Label::unseen:
            touch(node, Label::inner);
            before_[at(node)] = outer;
            if (const int next = mate(node); next >= 0) {
                touch(next, Label::outer);
                queue_.push_back(next);
                break;
            }
            flip(node); // free, or no longer in need of the outside
            return true;
        case Label::outer:
            if (blossoms_.find(outer) != blossoms_.find(node)) {
                const int base = common_base(outer, node);
                contract(outer, node, base);
                contract(node, outer, base);
            }
            break;
        default:
            break;
        }
    }
    return false;
}

// Makes outer all nodes from v down to the base of the blossom that v and w close.
void Matching::contract(int v, int w, int base) {
    while (blossoms_.find(v) != base) {
        before_[at(v)] = w;
        w = mate(v);
        if (label_[at(w)] == Label::inner) {
            label_[at(w)] = Label::outer;
            queue_.push_back(w);
        }
        for (const int node : {v, w})
            if (blossoms_.find(node) == node)
                blossoms_.unite(base, node);
        v = before_[at(w)];
    }
}

int Matching::common_base(int v, int w) {
    for (++clock_;; std::swap(v, w)) {
        if (v < 0)
            continue;
        v = blossoms_.find(v);
        if (seen_[at(v)] == clock_)
            return v;
        seen_[at(v)] = clock_;
        const int inner = mate(v);
        v = inner < 0 ? -1 : before_[at(inner)];
    }
}

void Matching::touch(int node, Label label) {
    label_[at(node)] = label;
    touched_.push_back(node);
}

void Matching::forget() {
    for (const std::int32_t node : touched_) {
        label_[at(node)] = Label::unseen;
        blossoms_.separate(node);
    }
    touched_.clear();
}

// Exchanges the edges of the path from node, which is inner, back to the root.
void Matching::flip(int node) {
    while (node >= 0) {
        const int before = before_[at(node)], next = mate(before);
        join(node, before);
        node = next;
    }
}

void Matching::join(int v, int w) {
    int best = -1;
    for (int side = 0; side < 3; ++side)
        if (const std::size_t p = place(v, side);
            dual_.stage[p] <= stage_ && dual_.across[p] >= 0 && dual_.across[p] / 3 == w)
            if (best < 0 || dual_.cost[p] < dual_.cost[place(v, best)])
                best = side;
    take(v, best);
    take(w, dual_.across[place(v, best)] % 3);
}

double Matching::cost(int node) const {
    return static_cast<double>(dual_.cost[place(node, side_[at(node)])]);
}

void Matching::improve() {
    constexpr int passes = 10;
    constexpr double least = 1e-6;
    const auto n = static_cast<int>(side_.size());
    std::vector<bool> due(side_.size(), true);
    bool changed = true;
    for (int pass = 0; pass < passes && changed; ++pass) {
        changed = false;
        for (int node = 0; node < n; ++node) {
            if (!due[at(node)] || mate(node) < 0)
                continue;
            due[at(node)] = false;
            Cycle cycle, best;
            cycle.most = dual_.stage[place(node, side_[at(node)])] == 0 ? 5 : 9;
            best.gain = least;
            extend(node, mate(node), cost(node), cycle, best);
            for (std::size_t i = 0; i < best.n; ++i) {
                const std::int32_t p = best.added[i], q = dual_.across[at(p)];
                take(p / 3, p % 3);
                take(q / 3, q % 3);
                for (const std::int32_t end : {p / 3, q / 3})
                    for (int side = 0; side < 3; ++side) {
                        due[at(end)] = true;
                        if (const std::int32_t across = dual_.across[place(end, side)]; across >= 0)
                            due[at(across / 3)] = true;
                    }
                changed = true;
            }
        }
    }
}

// The cycle runs from first to node and ends in edges that are to go: gain is what these
// cost less than those that are to come.
void Matching::extend(int first, int node, double gain, Cycle &cycle, Cycle &best) const {
    for (int side = 0; side < 3; ++side) {
        const std::size_t p = place(node, side);
        const std::int32_t across = dual_.across[p];
        if (side == side_[at(node)] || across < 0 || dual_.stage[p] == TriangleDual::never)
            continue;
        const int other = across / 3, next = mate(other);
        const double left = gain - static_cast<double>(dual_.cost[p]);
        cycle.added[cycle.n] = static_cast<std::int32_t>(p);
        if (other == first) {
            if (left > best.gain) {
                best = cycle;
                best.n = cycle.n + 1;
                best.gain = left;
            }
            continue;
        }
        if (next < 0 || cycle.n + 1 == cycle.most || left <= 0)
            continue;
        const auto used = cycle.added.begin() + static_cast<std::ptrdiff_t>(cycle.n);
        if (std::any_of(cycle.added.begin(), used,
                        [&](std::int32_t q) { return q / 3 == other || dual_.across[at(q)] / 3 == other; }))
            continue;
        ++cycle.n;
        extend(first, next, left + cost(other), cycle, best);
        --cycle.n;
    }
}

} // namespace alphamst::quadrangulate
