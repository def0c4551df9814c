#include "surface/curve.h"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

#include "index.h"
#include "surface/boxes.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// Edges in chains: from point to point through those where two edges meet and nothing bends.
class Chains {
public:
    Chains(std::span<const Vector3d> points, std::span<const std::array<int, 2>> edges, double tolerance)
        : points_(points), edges_(edges), tolerance_(tolerance), used_(edges.size(), 0) {
        for (std::size_t e = 0; e < edges.size(); ++e)
            for (const int point : edges[e])
                ends_.emplace_back(point, e);
        std::sort(ends_.begin(), ends_.end());
    }

    // The points of the chain that the edge is on; nothing if it was on one before.
    std::vector<Vector3d> take(std::size_t edge) {
        std::vector<Vector3d> way;
        if (used_[edge])
            return way;
        used_[edge] = 1;
        walk(edge, edges_[edge][0], way);
        std::reverse(way.begin(), way.end());
        walk(edge, edges_[edge][1], way);
        return way;
    }

private:
    // The points from one end of an edge on.
    void walk(std::size_t edge, int point, std::vector<Vector3d> &way) {
        for (;;) {
            way.push_back(points_[at(point)]);
            const std::size_t next = beyond(edge, point);
            if (used_[next])
                return;
            used_[next] = 1;
            edge = next;
            point = across(edge, point);
        }
    }

    int across(std::size_t edge, int point) const {
        return edges_[edge][0] == point ? edges_[edge][1] : edges_[edge][0];
    }

    // The edge that goes on straight at the point, or the same one.
    std::size_t beyond(std::size_t edge, int point) const {
        const auto first = std::lower_bound(ends_.begin(), ends_.end(), std::pair(point, std::size_t(0)));
        const auto last = std::lower_bound(first, ends_.end(), std::pair(point + 1, std::size_t(0)));
        if (last - first != 2)
            return edge;
        const std::size_t other = first->second == edge ? (first + 1)->second : first->second;
        const Line line{points_[at(across(edge, point))], points_[at(across(other, point))]};
        return line.distance(points_[at(point)]) <= tolerance_ ? other : edge;
    }

    const std::span<const Vector3d> points_;
    const std::span<const std::array<int, 2>> edges_;
    const double tolerance_;
    std::vector<std::pair<int, std::size_t>> ends_; // point and edge, ascending
    std::vector<char> used_;
};

} // namespace

double Line::place(const Vector3d &p) const {
    const Vector3d way = end - start;
    const double squared = way.squaredNorm();
    return squared > 0 ? (p - start).dot(way) / squared : 0;
}

double Line::distance(const Vector3d &p) const { return (p - at(std::clamp(place(p), 0.0, 1.0))).norm(); }

struct Curves::Tree {
    BoxTree boxes;
};

Curves::Curves(std::span<const Vector3d> points, std::span<const std::array<int, 2>> edges, double tolerance,
               std::vector<Line> given)
    : tolerance_(tolerance), lines_(std::move(given)) {
    Chains chains(points, edges, tolerance);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (const std::vector<Vector3d> way = chains.take(e); !way.empty())
            add_straight(way);
    std::vector<BoxEntry> entries;
    entries.reserve(lines_.size());
    for (const Line &line : lines_) {
        const std::array ends{line.start, line.end};
        entries.emplace_back(box_of(ends, tolerance), static_cast<int>(entries.size()));
    }
    tree_.reset(new Tree{BoxTree(entries)});
}

Curves::~Curves() = default;

// Where points are so close that no single one bends, they may still make an arc: it is cut where it is
// farthest from its chord (after Douglas and Peucker 1973).
void Curves::add_straight(std::span<const Vector3d> way) {
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, way.size() - 1}};
    while (!parts.empty()) {
        const auto [first, last] = parts.back();
        parts.pop_back();
        const Line line{way[first], way[last]};
        double farthest = tolerance_;
        std::size_t split = first;
        for (std::size_t i = first + 1; i < last; ++i)
            if (const double distance = line.distance(way[i]); distance > farthest) {
                farthest = distance;
                split = i;
            }
        if (split == first) {
            lines_.push_back(line);
        } else {
            parts.emplace_back(split, last);
            parts.emplace_back(first, split);
        }
    }
}

int Curves::find(std::span<const Vector3d> points) const {
    int found = -1;
    const auto look = [&](const BoxEntry &entry) {
        const Line &line = lines_[at(entry.second)];
        if ((found < 0 || entry.second < found) && std::all_of(points.begin(), points.end(), [&](auto &p) {
                return line.distance(p) <= tolerance_;
            }))
            found = entry.second;
    };
    if (!points.empty())
        tree_->boxes.query(spatial_index::intersects(box_corner(points[0])),
                           boost::make_function_output_iterator(look));
    return found;
}

} // namespace alphamst::surface
