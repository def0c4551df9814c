#include "refill/respacing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "index.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::refill {
namespace {

using Eigen::Vector3d;
using surface::CurvePlace;

constexpr int samples_per_edge = 4; // of wanted lengths along a run
// Of log2(length / wanted length) of edges, squared: as much may stay where all goes by sizes; and as much
// may come for fewer singular vertices. With .09, a lake whose boundary may change keeps 36 of them instead
// of 29, with .5 it has 24, but in others one face in seven more is longer than wide.
constexpr double small_error = 0.09, tolerable_error = 0.25;
// Part of the error that is to be left where vertices go elsewhere for the sake of sizes alone.
constexpr double worthwhile = 0.6;
// Of the way to the wanted numbers of edges, where all of it would miss the curve or leave no room.
constexpr double parts_of_way[] = {1, 0.5, 0.25};

// Degrees by which the curve turns at a point at which an edge rather ends, and part of an edge by which that
// may be moved for it.
constexpr double least_bend = 10, most_moved = 0.3;

double squared_log(double ratio) {
    const double log = std::log2(ratio);
    return log * log;
}

// Degrees, 0 .. 360, from the next vertex to the one before, the window at the left.
double angle_between(const Vector3d &before, const Vector3d &p, const Vector3d &next,
                     const Vector3d &normal) {
    const Vector3d u = next - p, v = before - p;
    const double angle = std::atan2(u.cross(v).dot(normal), u.dot(v)) * 180 / std::numbers::pi;
    return angle < 0 ? angle + 360 : angle;
}

} // namespace

Respacing::Respacing(const mesh::QuadMesh &mesh, const patch::Window &window,
                     const reference::Boundary &boundary, const reference::EdgeLength &edge_length,
                     double tolerance, std::span<const int> held)
    : mesh_(mesh), window_(window), boundary_(boundary), edge_length_(edge_length), tolerance_(tolerance) {
    find_runs(held);
}

void Respacing::find_runs(std::span<const int> held) {
    const std::size_t n = window_.loop.size();
    const auto vertex = [&](std::size_t i) { return window_.loop[i % n]; };
    std::vector<char> edge(n), through(n); // [loop] the edge from there is in a run; it goes on at the vertex
    for (std::size_t i = 0; i < n; ++i)
        edge[i] = boundary_.may_change(mesh_, vertex(i), vertex(i + 1));
    for (std::size_t i = 0; i < n; ++i)
        through[i] = edge[(i + n - 1) % n] && edge[i] && boundary_.may_go(vertex(i)) &&
                     std::ranges::find(held, vertex(i)) == held.end();
    // The loop of a whole closed boundary keeps its first vertex.
    const auto start =
        static_cast<std::size_t>(std::find(through.begin(), through.end(), 0) - through.begin()) % n;
    for (std::size_t k = 0; k < n;) {
        const std::size_t i = start + k;
        if (!edge[i % n]) {
            ++k;
            continue;
        }
        Run run;
        run.first = i % n;
        do {
            ++run.edges;
            ++k;
        } while (k < n && through[(start + k) % n] && edge[(start + k) % n]);
        run.from = boundary_.places[at(vertex(i))];
        run.length = boundary_.curves->way(run.from, boundary_.places[at(vertex(i + at(run.edges)))]);
        measure(run);
        runs_.push_back(std::move(run));
    }
}

void Respacing::measure(Run &run) const {
    const int samples = samples_per_edge * std::max(2, run.edges);
    run.wanted_till.push_back(0);
    for (int k = 0; k < samples; ++k) {
        const CurvePlace middle = boundary_.curves->advance(run.from, run.length * (k + 0.5) / samples);
        run.wanted += run.length / samples / edge_length_(middle);
        run.wanted_till.push_back(run.wanted);
    }
    const std::size_t n = window_.loop.size();
    for (std::size_t i = run.first; i < run.first + at(run.edges); ++i) {
        const Vector3d a = reference::point_of(mesh_, window_.loop[i % n]),
                       b = reference::point_of(mesh_, window_.loop[(i + 1) % n]);
        const double error =
            squared_log((b - a).norm() / edge_length_(boundary_.places[at(window_.loop[i % n])]));
        run.error += error;
        run.worst = std::max(run.worst, error);
    }
    run.fine = run.error <= small_error * run.edges && run.worst <= tolerable_error;
}

double Respacing::present_error() const {
    double sum = 0;
    int edges = 0;
    for (const Run &run : runs_) {
        sum += run.error;
        edges += run.edges;
    }
    return edges == 0 ? 0 : std::sqrt(sum / edges);
}

double Respacing::error(const Run &run, int edges) const { return edges * squared_log(run.wanted / edges); }

double Respacing::error(const Counts &counts) const {
    double sum = 0;
    for (std::size_t r = 0; r < runs_.size(); ++r)
        sum += counts[r] == runs_[r].edges ? runs_[r].error : error(runs_[r], counts[r]);
    return sum;
}

// Of the loop with such runs.
int Respacing::parity(const Counts &counts) const {
    int length = static_cast<int>(window_.loop.size());
    for (std::size_t r = 0; r < runs_.size(); ++r)
        length += counts[r] - runs_[r].edges;
    return length % 2;
}

std::vector<Respacing::Counts> Respacing::near(bool wished) const {
    Counts now;
    int edges = 0;
    for (const Run &run : runs_) {
        now.push_back(run.edges);
        edges += run.edges;
    }
    const double most = std::max(error(now), (wished ? small_error : tolerable_error) * edges);
    std::vector<std::pair<double, Counts>> rated;
    const auto rate = [&](const Counts &counts) {
        if (std::all_of(counts.begin(), counts.end(), [](int n) { return n > 0; }) && parity(counts) == 0)
            if (const double e = error(counts); e <= most)
                rated.emplace_back(e, counts);
    };
    for (std::size_t r = 0; r < runs_.size(); ++r)
        for (const int more : {-2, -1, 1, 2}) {
            Counts counts = now;
            counts[r] += more;
            rate(counts);
            for (std::size_t other = r + 1; other < runs_.size(); ++other)
                for (const int also : {-1, 1}) {
                    Counts both = counts;
                    both[other] += also;
                    rate(both);
                }
        }
    std::stable_sort(rated.begin(), rated.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<Counts> list;
    for (auto &[e, counts] : rated)
        list.push_back(std::move(counts));
    return list;
}

std::vector<Respacing::Counts> Respacing::towards() const {
    std::vector<Counts> list;
    if (std::ranges::all_of(runs_, &Run::fine))
        return list;
    double before = 0;
    for (const Run &run : runs_)
        before += run.error;
    for (const double part : parts_of_way) {
        Counts counts;
        for (const Run &run : runs_)
            counts.push_back(run.fine ? run.edges
                                      : std::max(1, static_cast<int>(std::lround(
                                                        run.edges + part * (run.wanted - run.edges)))));
        make_even(counts);
        double after = 0;
        for (std::size_t r = 0; r < runs_.size(); ++r)
            after += changes(r, counts, true) ? error(runs_[r], counts[r]) : runs_[r].error;
        if (after <= worthwhile * before && (list.empty() || list.back() != counts))
            list.push_back(std::move(counts));
    }
    return list;
}

// By one edge in the run where that costs least.
void Respacing::make_even(Counts &counts) const {
    if (parity(counts) == 0)
        return;
    double least = std::numeric_limits<double>::infinity();
    std::size_t changed = 0;
    int by = 0;
    for (std::size_t r = 0; r < runs_.size(); ++r)
        for (const int more : {-1, 1})
            if (counts[r] + more > 0)
                if (const double cost = error(runs_[r], counts[r] + more) - error(runs_[r], counts[r]);
                    cost < least) {
                    least = cost;
                    changed = r;
                    by = more;
                }
    counts[changed] += by;
}

// As wanted lengths have it, but at bends that are near.
std::vector<double> Respacing::lengths(const Run &run, int edges) const {
    std::vector<double> lengths{0};
    const auto samples = static_cast<double>(run.wanted_till.size() - 1);
    std::size_t k = 0;
    for (int i = 1; i < edges; ++i) {
        const double wanted = run.wanted * i / edges;
        while (k + 2 < run.wanted_till.size() && run.wanted_till[k + 1] < wanted)
            ++k;
        const double part = (wanted - run.wanted_till[k]) / (run.wanted_till[k + 1] - run.wanted_till[k]);
        lengths.push_back(run.length * (static_cast<double>(k) + part) / samples);
    }
    lengths.push_back(run.length);
    std::vector<double> turns(lengths.size(), least_bend);
    const std::vector<double> even = lengths;
    for (const auto &bend : boundary_.curves->between(run.from, run.length)) {
        const auto after =
            static_cast<std::size_t>(std::upper_bound(even.begin(), even.end(), bend.along) - even.begin());
        const double width = even[after] - even[after - 1];
        const std::size_t i = bend.along < even[after - 1] + width / 2 ? after - 1 : after;
        if (i > 0 && i + 1 < even.size() && bend.turn > turns[i] &&
            std::abs(bend.along - even[i]) < most_moved * width) {
            turns[i] = bend.turn;
            lengths[i] = bend.along;
        }
    }
    return lengths;
}

std::optional<Respacing::Places> Respacing::places(const Run &run, int edges) const {
    Places places;
    const std::vector<double> ends = lengths(run, edges);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const CurvePlace from = boundary_.curves->advance(run.from, ends[i - 1]);
        const double length = ends[i] - ends[i - 1];
        const double wanted = edge_length_(boundary_.curves->advance(from, length / 2));
        if (!boundary_.keeps_curve(from, length, tolerance_ * wanted))
            return std::nullopt;
        if (i > 1)
            places.push_back(from);
    }
    return places;
}

std::optional<patch::Window> Respacing::window(const Counts &counts, bool everywhere) const {
    const std::size_t n = window_.loop.size();
    patch::Window changed = window_;
    changed.loop.clear();
    changed.outside.clear();
    changed.inside.clear();
    std::vector<int> starts(n, -1); // [loop] run
    std::size_t first = 0;          // a vertex that stays
    for (std::size_t r = 0; r < runs_.size(); ++r)
        if (changes(r, counts, everywhere)) {
            starts[runs_[r].first] = static_cast<int>(r);
            if (runs_[r].first + at(runs_[r].edges) > n)
                first = runs_[r].first;
        }
    for (std::size_t k = 0; k < n;) {
        const std::size_t i = (first + k) % n;
        if (starts[i] < 0) {
            keep(i, -1, changed);
            ++k;
        } else if (const Run &run = runs_[at(starts[i])]; add(run, counts[at(starts[i])], changed)) {
            k += at(run.edges);
        } else {
            return std::nullopt;
        }
    }
    std::sort(changed.interior.begin(), changed.interior.end());
    set_angles(changed);
    return changed;
}

void Respacing::keep(std::size_t i, int parent, patch::Window &changed) const {
    changed.loop.push_back(window_.loop[i]);
    changed.inside.push_back(window_.inside[i]);
    changed.outside.push_back(window_.outside[i]);
    changed.parents.push_back(parent);
}

// All edges of a run are alike but for their origin: that of the old edge at the middle.
int Respacing::parent(const Run &run, double along) const {
    const std::size_t n = window_.loop.size();
    int e = 1;
    while (e < run.edges &&
           boundary_.curves->way(run.from, boundary_.places[at(window_.loop[(run.first + at(e)) % n])]) <
               along)
        ++e;
    return window_.loop[(run.first + at(e) - 1) % n];
}

// The first vertex of the run and new ones up to its end; false where the curve would be missed.
bool Respacing::add(const Run &run, int edges, patch::Window &changed) const {
    const std::optional<Places> found = places(run, edges);
    if (!found)
        return false;
    double before = 0;
    for (std::size_t j = 0; j <= found->size(); ++j) {
        const double after = j < found->size() ? boundary_.curves->way(run.from, (*found)[j]) : run.length;
        const int old = parent(run, (before + after) / 2);
        if (j == 0) {
            keep(run.first, old, changed);
        } else {
            const Vector3d p = boundary_.curves->at((*found)[j - 1]);
            changed.loop.push_back(-1 - static_cast<int>(changed.added.size()));
            changed.inside.push_back(0);
            changed.outside.push_back(0);
            changed.parents.push_back(old);
            changed.added.emplace_back(p.x(), p.y(), p.z());
            changed.added_places.push_back((*found)[j - 1]);
        }
        before = after;
    }
    for (int e = 1; e < run.edges; ++e)
        changed.interior.push_back(window_.loop[(run.first + at(e)) % window_.loop.size()]);
    return true;
}

void Respacing::set_angles(patch::Window &window) const {
    const std::vector<Vector3d> points = loop_points(mesh_, window);
    Vector3d normal = Vector3d::Zero();
    for (const int f : window_.faces)
        normal += geometry::area_vector(reference::quad_of(mesh_, f));
    normal.normalize();
    const std::size_t n = points.size();
    const auto is_new = [&](std::size_t i) { return window.parents[i % n] >= 0; };
    std::vector<double> angles(n);
    std::vector<int> wanted(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int v = window.loop[i];
        if (!is_new(i) && !is_new(i + n - 1)) {
            const auto old = static_cast<std::size_t>(std::find(window_.loop.begin(), window_.loop.end(), v) -
                                                      window_.loop.begin());
            angles[i] = window_.angles[old];
            wanted[i] = window_.wanted[old];
            continue;
        }
        angles[i] = angle_between(points[(i + n - 1) % n], points[i], points[(i + 1) % n], normal);
        double all = angles[i];
        if (v >= 0)
            for (const int f : mesh_.faces_around(v))
                if (!patch::contains(window_.faces, f))
                    for (const patch::Halfedge h : patch::halfedges_of(mesh_, f))
                        if (patch::from(mesh_, h) == v)
                            all += patch::corner_angle(mesh_, h) * 180 / std::numbers::pi;
        wanted[i] = patch::wanted_at(patch::regular_at_boundary(all), window.outside[i], angles[i]);
    }
    window.angles = std::move(angles);
    window.wanted = std::move(wanted);
}

std::vector<Vector3d> loop_points(const mesh::QuadMesh &mesh, const patch::Window &window) {
    std::vector<Vector3d> points;
    auto added = window.added.begin();
    for (const int v : window.loop)
        if (v >= 0) {
            points.push_back(reference::point_of(mesh, v));
        } else {
            points.emplace_back((*added)[0], (*added)[1], (*added)[2]);
            ++added;
        }
    return points;
}

} // namespace alphamst::refill
