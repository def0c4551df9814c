#include "patch/bisection.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "index.h"

namespace alphamst::patch {
namespace {

constexpr int most_links = 4;

// Nodes by their gain, the links that a move of theirs would save; those that came last are told first. A
// node whose gain changes is put in again, and the old entry is passed over.
class Gains {
public:
    void put(std::size_t node, int gain) {
        stacks_[at(gain + most_links)].push_back(static_cast<std::int32_t>(node));
        best_ = std::max(best_, gain + most_links);
    }
    // Whether there is one that is still so: it is the last of best().
    template <class Valid> bool find(Valid valid) {
        for (; best_ >= 0; --best_)
            for (auto &stack = stacks_[at(best_)]; !stack.empty(); stack.pop_back())
                if (valid(static_cast<std::size_t>(stack.back()), best_ - most_links))
                    return true;
        return false;
    }
    int gain() const { return best_ - most_links; }
    std::size_t take() {
        auto &stack = stacks_[at(best_)];
        const auto node = static_cast<std::size_t>(stack.back());
        stack.pop_back();
        return node;
    }

private:
    std::array<std::vector<std::int32_t>, 2 * most_links + 1> stacks_;
    int best_ = -1;
};

class Bisection {
public:
    Bisection(const Graph &graph, std::size_t wanted, std::size_t slack, std::vector<char> side,
              const Pace &pace)
        : graph_(graph), wanted_(wanted), slack_(slack), side_(std::move(side)), pace_(pace) {
        count_ = static_cast<std::size_t>(std::ranges::count(side_, 0));
        mend();
        // What was not connected is put right and refined again; three times, as it seldom happens twice.
        for (int round = 0; round < 3; ++round) {
            refine();
            if (!mend())
                break;
        }
    }

    const std::vector<char> &side() const { return side_; }
    // The links between the sides; a node too many or too few is as bad as two of them.
    std::size_t cost() const { return cut() + 2 * excess(count_); }

private:
    std::size_t excess(std::size_t count) const {
        const std::size_t off = count > wanted_ ? count - wanted_ : wanted_ - count;
        return off > slack_ ? off - slack_ : 0;
    }
    // On the way one node beside the slack has to be allowed, or no two could change places.
    bool may_become(std::size_t count) const {
        return excess(count) <= std::max<std::size_t>(excess(count_), 1);
    }
    int gain(std::size_t node) const {
        int across = 0;
        const auto next = graph_.neighbours(node);
        for (const std::int32_t other : next)
            across += side_[at(other)] != side_[node];
        return 2 * across - static_cast<int>(next.size());
    }
    std::size_t cut() const {
        std::size_t twice = 0;
        for (std::size_t i = 0; i < graph_.size(); ++i)
            for (const std::int32_t next : graph_.neighbours(i))
                twice += side_[i] != side_[at(next)];
        return twice / 2;
    }
    void move(std::size_t node) {
        count_ += side_[node] == 0 ? std::size_t(-1) : 1;
        side_[node] ^= 1;
    }

    void refine() {
        constexpr int passes = 10; // later ones gain next to nothing
        for (int pass = 0; pass < passes; ++pass) {
            if (!improve())
                return;
        }
    }

    // Moves nodes, each at most once, the best first and also where that makes it worse, and goes back to the
    // best that there was on the way. Whether that is better than the beginning.
    bool improve() {
        constexpr std::size_t patience = 200; // moves without a new best: more are seldom made good
        std::array<Gains, 2> gains;
        pace_.step(graph_.size() / 8); // that is quick
        for (std::size_t i = 0; i < graph_.size(); ++i)
            if (const auto next = graph_.neighbours(i);
                std::ranges::any_of(next, [&](std::int32_t other) { return side_[at(other)] != side_[i]; }))
                gains[at(side_[i])].put(i, gain(i));
        std::vector<char> moved(graph_.size(), 0);
        std::vector<std::size_t> moves;
        const auto began = static_cast<long>(2 * excess(count_));
        long now = 0, best = 0; // change of cost
        std::size_t kept = 0;
        while (moves.size() < kept + patience || excess(count_) > 1) {
            const auto valid = [&](int side) {
                return gains[at(side)].find([&](std::size_t node, int told) {
                    return !moved[node] && side_[node] == side && gain(node) == told;
                });
            };
            const std::array<bool, 2> any{may_become(count_ - 1) && valid(0),
                                          may_become(count_ + 1) && valid(1)};
            if (!any[0] && !any[1])
                break;
            // Of equal ones from the side that has too many.
            const bool first = any[0] && (!any[1] || gains[0].gain() > gains[1].gain() ||
                                          (gains[0].gain() == gains[1].gain() && count_ > wanted_));
            const std::size_t node = gains[first ? 0 : 1].take();
            now -= gain(node);
            move(node);
            moved[node] = 1;
            moves.push_back(node);
            for (const std::int32_t next : graph_.neighbours(node))
                if (!moved[at(next)])
                    gains[at(side_[at(next)])].put(at(next), gain(at(next)));
            const long change = now + static_cast<long>(2 * excess(count_)) - began;
            if (change < best) {
                best = change;
                kept = moves.size();
            }
        }
        for (; moves.size() > kept; moves.pop_back())
            move(moves.back());
        return best < 0;
    }

    // All but the largest connected part of each side goes to the other; whether there was any.
    bool mend() {
        bool any = false;
        for (const char side : {char(0), char(1)}) {
            std::vector<std::int32_t> part(graph_.size(), -1), queue;
            std::vector<std::size_t> sizes;
            for (std::size_t i = 0; i < graph_.size(); ++i) {
                if (side_[i] != side || part[i] >= 0)
                    continue;
                const auto number = static_cast<std::int32_t>(sizes.size());
                part[i] = number;
                queue.assign(1, static_cast<std::int32_t>(i));
                for (std::size_t q = 0; q < queue.size(); ++q)
                    for (const std::int32_t next : graph_.neighbours(at(queue[q])))
                        if (side_[at(next)] == side && part[at(next)] < 0) {
                            part[at(next)] = number;
                            queue.push_back(next);
                        }
                sizes.push_back(queue.size());
            }
            if (sizes.size() < 2)
                continue;
            any = true;
            const auto largest = static_cast<std::int32_t>(std::ranges::max_element(sizes) - sizes.begin());
            for (std::size_t i = 0; i < graph_.size(); ++i)
                if (part[i] >= 0 && part[i] != largest)
                    move(i);
        }
        return any;
    }

    const Graph &graph_;
    std::size_t wanted_, slack_, count_ = 0; // nodes on side 0
    std::vector<char> side_;
    const Pace &pace_;
};

// The first of an order on side 0.
std::vector<char> first_of(std::span<const std::int32_t> order, std::size_t wanted) {
    std::vector<char> side(order.size(), 1);
    for (const std::int32_t node : order.first(wanted))
        side[at(node)] = 0;
    return side;
}

// Across an axis of inertia, 2 the longest.
std::vector<char> across(const Graph &graph, std::size_t wanted, int axis) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d &p : graph.places)
        mean += p / static_cast<double>(graph.size());
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d &p : graph.places)
        inertia += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
    const Eigen::Vector3d along = solver.eigenvectors().col(axis);
    std::vector<double> height(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i)
        height[i] = (graph.places[i] - mean).dot(along);
    std::vector<std::int32_t> order(graph.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, [&](std::int32_t a, std::int32_t b) {
        return std::pair(height[at(a)], a) < std::pair(height[at(b)], b);
    });
    return first_of(order, wanted);
}

// Layer by layer around a node: all of the graph.
std::vector<std::int32_t> layers(const Graph &graph, std::size_t from) {
    std::vector<char> seen(graph.size(), 0);
    std::vector<std::int32_t> order{static_cast<std::int32_t>(from)};
    seen[from] = 1;
    for (std::size_t q = 0; q < order.size(); ++q)
        for (const std::int32_t next : graph.neighbours(at(order[q])))
            if (!seen[at(next)]) {
                seen[at(next)] = 1;
                order.push_back(next);
            }
    return order;
}

// Grown from a node, always by the one that brings the fewest links to the outside (Karypis and Kumar 1998).
std::vector<char> grown(const Graph &graph, std::size_t wanted, std::size_t from) {
    std::vector<char> side(graph.size(), 1);
    std::array<std::vector<std::int32_t>, most_links + 1>
        fronts; // [links to the grown] in the order they came
    std::array<std::size_t, most_links + 1> told{};
    std::vector<char> reached(graph.size(), 0);
    fronts[0].push_back(static_cast<std::int32_t>(from));
    const auto links_inside = [&](std::size_t node) {
        const auto next = graph.neighbours(node);
        return std::ranges::count_if(next, [&](std::int32_t other) { return side[at(other)] == 0; });
    };
    // Where nodes have fewer than four links what counts is how many lead out; as if the rest were inside.
    const auto rank = [&](std::size_t node) {
        return at(most_links - static_cast<int>(graph.neighbours(node).size()) + links_inside(node));
    };
    for (std::size_t n = 0; n < wanted;) {
        std::size_t best = most_links + 1;
        while (best > 0 && told[best - 1] == fronts[best - 1].size())
            --best;
        const auto node = at(fronts[best - 1][told[best - 1]++]);
        if (side[node] == 0 || (n > 0 && rank(node) != best - 1))
            continue;
        side[node] = 0;
        ++n;
        for (const std::int32_t next : graph.neighbours(node))
            if (side[at(next)] != 0)
                fronts[rank(at(next))].push_back(next);
    }
    return side;
}

} // namespace

std::vector<char> bisect(const Graph &graph, std::size_t wanted, std::size_t slack, Random &random,
                         const Pace &pace) {
    std::vector<char> best;
    std::size_t cost = 0;
    const auto consider = [&](std::vector<char> side) {
        pace.step(graph.size());
        const Bisection refined(graph, wanted, slack, std::move(side), pace);
        if (best.empty() || refined.cost() < cost) {
            best = refined.side();
            cost = refined.cost();
        }
    };
    consider(across(graph, wanted, 2));
    consider(across(graph, wanted, 1));
    // The cuts of large graphs are few, and small ones cost little.
    const int tries = graph.size() > 2000 ? 1 : 4;
    for (int i = 0; i < tries; ++i) {
        const auto any = static_cast<std::size_t>(random() % graph.size());
        const auto far = at(layers(graph, any).back());
        consider(grown(graph, wanted, far));
        consider(grown(graph, wanted, any));
    }
    return best;
}

} // namespace alphamst::patch
