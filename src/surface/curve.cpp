#include "surface/curve.h"

#include <algorithm>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

#include "index.h"
#include "surface/angle.h"
#include "surface/boxes.h"

namespace alphamst::surface {
namespace {

using Eigen::Vector3d;

// Degrees: curves that turn by more have a corner there. A chord that goes across takes such a vertex, too.
constexpr double least_corner = 30;
// A way along curves is no longer than so many times the way straight on.
constexpr double detour = 1.5;

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
    join();
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

template <class Look> void Curves::at_point(const Vector3d &p, Look &&look) const {
    tree_->boxes.query(spatial_index::intersects(box_corner(p)),
                       boost::make_function_output_iterator([&](const BoxEntry &entry) {
                           if (lines_[at(entry.second)].distance(p) <= tolerance_)
                               look(entry.second);
                       }));
}

int Curves::find(std::span<const Vector3d> points) const {
    int found = -1;
    const auto look = [&](int line) {
        if ((found < 0 || line < found) && std::all_of(points.begin(), points.end(), [&](auto &p) {
                return lines_[at(line)].distance(p) <= tolerance_;
            }))
            found = line;
    };
    if (!points.empty())
        at_point(points[0], look);
    return found;
}

// Two lines whose ends are the same point, and no third one's.
void Curves::join() {
    struct End {
        Vector3d point;
        Step leave; // the line, from there
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        ends.push_back({lines_[i].start, {static_cast<int>(i), false}});
        ends.push_back({lines_[i].end, {static_cast<int>(i), true}});
    }
    const auto key = [](const End &end) { return std::array{end.point.x(), end.point.y(), end.point.z()}; };
    std::ranges::stable_sort(ends, {}, key);
    joined_.resize(lines_.size());
    for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
        while (last < ends.size() && key(ends[last]) == key(ends[first]))
            ++last;
        if (last - first != 2)
            continue;
        const Step one = ends[first].leave, other = ends[first + 1].leave;
        const Line away = passed(one), on = passed(other);
        if (degrees_between(away.start - away.end, on.end - on.start) > least_corner)
            continue;
        joined_[at(one.line)][one.back ? 0 : 1] = other;
        joined_[at(other.line)][other.back ? 0 : 1] = one;
    }
}

Line Curves::passed(Step step) const {
    const Line &line = lines_[at(step.line)];
    return step.back ? line.reversed() : line;
}

Curves::Step Curves::after(Step step) const { return joined_[at(step.line)][step.back ? 1 : 0]; }

std::vector<Curves::Step> Curves::steps(const Vector3d &from, const Vector3d &to) const {
    std::vector<Step> best;
    const double most = detour * (to - from).norm();
    at_point(from, [&](int line) {
        for (const bool back : {false, true}) {
            std::vector<Step> way;
            double length = -(from - passed({line, back}).start).norm();
            for (Step step{line, back}; step.line >= 0 && length <= most; step = after(step)) {
                way.push_back(step);
                const Line &here = passed(step);
                const double place = here.place(to), start = way.size() == 1 ? here.place(from) : 0;
                if (here.distance(to) <= tolerance_ && place >= start) {
                    if (length + (to - here.start).norm() <= most &&
                        (best.empty() || way.size() < best.size()))
                        best = way;
                    break;
                }
                length += (here.end - here.start).norm();
            }
        }
    });
    return best;
}

void Curves::go_on(std::vector<Step> &steps, double length) const {
    const auto known = [&](int line) { return std::ranges::find(steps, line, &Step::line) != steps.end(); };
    for (Step next = after(steps.back()); length > 0 && next.line >= 0 && !known(next.line);
         next = after(steps.back())) {
        steps.push_back(next);
        length -= (passed(next).end - passed(next).start).norm();
    }
}

std::vector<int> Curves::lines_between(const Vector3d &from, const Vector3d &to) const {
    if (const int line = find(std::array{from, to}); line >= 0)
        return {line};
    std::vector<int> lines;
    for (const Step step : steps(from, to))
        lines.push_back(step.line);
    return lines;
}

std::vector<Line> Curves::way(const Vector3d &from, const Vector3d &to) const {
    std::vector<Line> lines;
    for (const Step step : steps(from, to))
        lines.push_back(passed(step));
    return lines;
}

std::vector<Line> Curves::way_through(const Vector3d &from, const Vector3d &between,
                                      const Vector3d &to) const {
    std::vector<Step> there = steps(between, to), back = steps(between, from);
    if (there.empty() || back.empty())
        return {};
    const auto left = [&](const std::vector<Step> &steps, const Vector3d &p) {
        return (p - between).norm() - (passed(steps.back()).end - p).norm();
    };
    go_on(there, left(there, to));
    go_on(back, left(back, from));
    std::vector<Step> all;
    for (std::size_t i = back.size(); i-- > 0;)
        all.push_back({back[i].line, !back[i].back});
    const bool same = all.back().line == there.front().line;
    if (same && all.back().back != there.front().back)
        return {};
    all.insert(all.end(), there.begin() + (same ? 1 : 0), there.end());
    std::vector<Line> lines;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            if (all[i].line == all[j].line)
                return {}; // once around a small ring
        lines.push_back(passed(all[i]));
    }
    return lines;
}

} // namespace alphamst::surface
