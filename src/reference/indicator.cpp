#include "reference/indicator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "geometry/quad.h"
#include "index.h"
#include "mesh/sides.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

// The number of faces is met within this part of it: an operation does not meet it better.
constexpr double close_enough = 1e-3;
// Halvings of the bracket of the factor: from 1e-60 to 1e60 to that closeness takes 18, at ten times the most
// trials that were seen.
constexpr int most_trials = 60;
// Of the factor, that the number of faces goes with: where nothing bounds sizes, and where nearly all do.
constexpr double steepest = -2, flattest = -0.1;

class Trial {
public:
    Trial(const mesh::QuadMesh &mesh, std::span<const double> indicator, const SizeRules &rules);

    // With edges so many times as long as those at which each indicator is 1.
    Sizes sizes(double factor) const;
    // Beyond these every face has the least size, or the largest.
    double least_factor() const { return least_factor_; }
    double largest_factor() const { return largest_factor_; }

private:
    struct Way {
        int to;
        double length;
    };

    void spread(std::vector<double> &size) const;
    void grade(std::vector<double> &size) const;

    const mesh::QuadMesh &mesh_;
    const SizeRules &rules_;
    std::vector<double> area_, wish_; // [face]; the wish is the size at indicator 1, infinite: none
    std::vector<std::size_t> first_;  // [vertex] of its ways
    std::vector<Way> ways_;
    double least_ = 0, largest_ = 0, least_factor_ = 1, largest_factor_ = 1;
};

Trial::Trial(const mesh::QuadMesh &mesh, std::span<const double> indicator, const SizeRules &rules)
    : mesh_(mesh), rules_(rules), first_(at(mesh.n_vertices()) + 1, 0) {
    Eigen::AlignedBox3d box;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad quad = quad_of(mesh, f);
        for (const Eigen::Vector3d &corner : quad)
            box.extend(corner);
        area_.push_back(geometry::area_vector(quad).norm());
        wish_.push_back(area_.back() > 0
                            ? std::sqrt(area_.back()) * std::pow(indicator[at(f)], -1 / rules.error_order)
                            : std::numeric_limits<double>::infinity());
    }
    const double extent = box.isEmpty() ? 1 : box.diagonal().norm();
    largest_ = std::clamp(rules.max_edge > 0 ? rules.max_edge : extent, mesh::least_extent,
                          mesh::largest_coordinate);
    least_ = std::clamp(rules.min_edge, mesh::least_extent, largest_);
    double low = largest_, high = least_; // of the wishes
    for (const double wish : wish_)
        if (wish > 0 && std::isfinite(wish)) {
            low = std::min(low, wish);
            high = std::max(high, wish);
        }
    least_factor_ = least_ / high;
    largest_factor_ = largest_ / low;
    // Edges and diagonals: along both a way is at most a twelfth longer than the straight one.
    std::vector<std::array<int, 2>> pairs;
    for (int e = 0; e < mesh.n_edges(); ++e)
        pairs.push_back(mesh.edge_vertices(e));
    for (const auto &[a, b, c, d] : mesh.faces()) {
        pairs.push_back({a, c});
        pairs.push_back({b, d});
    }
    for (const auto &[v, w] : pairs) {
        ++first_[at(v) + 1];
        ++first_[at(w) + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v)
        first_[v] += first_[v - 1];
    ways_.resize(2 * pairs.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto &[v, w] : pairs) {
        const double length = (point_of(mesh, w) - point_of(mesh, v)).norm();
        ways_[next[at(v)]++] = {w, length};
        ways_[next[at(w)]++] = {v, length};
    }
}

// To all vertices of the faces of a vertex, layer by layer.
void Trial::spread(std::vector<double> &size) const {
    std::vector<double> before;
    for (int layer = 0; layer < rules_.buffer_layers; ++layer) {
        before = size;
        for (const std::array<int, 4> &corners : mesh_.faces()) {
            double least = before[at(corners[0])];
            for (const int v : corners)
                least = std::min(least, before[at(v)]);
            for (const int v : corners)
                size[at(v)] = std::min(size[at(v)], least);
        }
        if (size == before)
            return;
    }
}

// The least over all ways of the size at the beginning and what it may grow on the way. A vertex is settled
// when it is the least that is left, so that the order does not tell.
void Trial::grade(std::vector<double> &size) const {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto grown = [&](int v, const Way &way) { return size[at(v)] + rules_.gradation * way.length; };
    const auto push_beyond = [&](int v, bool settle) {
        for (std::size_t i = first_[at(v)]; i < first_[at(v) + 1]; ++i)
            if (const double most = grown(v, ways_[i]); most < size[at(ways_[i].to)]) {
                if (!settle) {
                    queue.emplace(size[at(v)], v);
                    return;
                }
                size[at(ways_[i].to)] = most;
                queue.emplace(most, ways_[i].to);
            }
    };
    for (int v = 0; v < mesh_.n_vertices(); ++v)
        push_beyond(v, false);
    while (!queue.empty()) {
        const auto [value, v] = queue.top();
        queue.pop();
        if (value <= size[at(v)])
            push_beyond(v, true);
    }
}

Sizes Trial::sizes(double factor) const {
    Sizes sizes{std::vector<double>(at(mesh_.n_vertices()), largest_), 0};
    for (int f = 0; f < mesh_.n_faces(); ++f) {
        const double wish = std::clamp(factor * wish_[at(f)], least_, largest_);
        for (const int v : mesh_.corners(f))
            sizes.of_vertex[at(v)] = std::min(sizes.of_vertex[at(v)], wish);
    }
    spread(sizes.of_vertex);
    grade(sizes.of_vertex);
    for (int f = 0; f < mesh_.n_faces(); ++f) {
        double edge = 0;
        for (const int v : mesh_.corners(f))
            edge += sizes.of_vertex[at(v)] / 4;
        sizes.faces += area_[at(f)] / (edge * edge);
    }
    return sizes;
}

} // namespace

// The number falls as the factor grows: the next trial is where the line through the last two, in logarithms,
// comes to it, or in the middle of the bracket where that leaves it.
Sizes sizes_from_indicator(const mesh::QuadMesh &mesh, std::span<const double> indicator, double tolerance,
                           double most, const SizeRules &rules) {
    const Trial trial(mesh, indicator, rules);
    double low = trial.least_factor(), high = trial.largest_factor();
    double factor = std::clamp(tolerance > 0 ? std::pow(tolerance, 1 / rules.error_order) : 1, low, high);
    Sizes sizes = trial.sizes(factor);
    if (tolerance > 0) {
        if (!(most > 0) || sizes.faces <= most)
            return sizes;
        low = factor;
    }
    double power = steepest;
    for (int k = 0; k < most_trials && std::abs(sizes.faces / most - 1) > close_enough; ++k) {
        (sizes.faces > most ? low : high) = factor;
        if (!(high > low * (1 + close_enough * close_enough)))
            break;
        const double guess = factor * std::pow(sizes.faces / most, -1 / power);
        const double next = guess > low && guess < high ? guess : std::sqrt(low) * std::sqrt(high);
        Sizes found = trial.sizes(next);
        power = std::clamp(std::log(found.faces / sizes.faces) / std::log(next / factor), steepest, flattest);
        factor = next;
        sizes = std::move(found);
    }
    return sizes;
}

} // namespace alphamst::reference
