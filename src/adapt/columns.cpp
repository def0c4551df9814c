#include "adapt/columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "adapt/layers.h"
#include "chord/judge.h"
#include "chord/trace.h"
#include "index.h"
#include "mesh/renumbered.h"
#include "reference/boundary.h"
#include "reference/locate.h"
#include "reference/statistics.h"

namespace alphamst::adapt {
namespace {

using chord::Chord;
using Eigen::Vector3d;

// Of the faces, that are in layers where this is the way to go.
constexpr double least_part = 0.05;

// Of the height of a row by that of the one before.
constexpr double least_growth = 1.02;
// Of a number of columns, that rounding changes.
constexpr double rounding = 1e-9;
// Smallest scaled Jacobian, or the old one where that is less: else another way is better.
constexpr double least_quality = 0.3;

double length_of(const mesh::QuadMesh &mesh, int edge) {
    const auto [v, w] = mesh.edge_vertices(edge);
    return (reference::point_of(mesh, w) - reference::point_of(mesh, v)).norm();
}

// Chords by what they are: columns begin at layers on the boundary and cross rows; what crosses no column
// but rows is one, too.
class Columns {
public:
    explicit Columns(const mesh::QuadMesh &mesh)
        : mesh_(mesh), labels_(chord::label(mesh)), is_column_(labels_.first.size(), 0),
          is_row_(labels_.first.size(), 0) {}

    // [column] one edge each, in the order of the boundary; empty if not all faces are between one row and
    // one column.
    std::vector<int> find(const reference::Boundary &boundary) {
        begin_at_layers();
        for (int f = 0; f < mesh_.n_faces(); ++f)
            for (const bool turned : {false, true})
                if (is_column_[chord_of(f, turned)])
                    is_row_[chord_of(f, !turned)] = 1;
        for (int f = 0; f < mesh_.n_faces(); ++f)
            for (const bool turned : {false, true})
                if (is_row_[chord_of(f, turned)])
                    is_column_[chord_of(f, !turned)] = 1;
        for (int f = 0; f < mesh_.n_faces(); ++f)
            for (const bool turned : {false, true})
                if (is_column_[chord_of(f, turned)] == is_row_[chord_of(f, turned)] ||
                    is_column_[chord_of(f, turned)] == is_column_[chord_of(f, !turned)])
                    return {};
        return in_order(boundary);
    }

private:
    // Of the two chords of a face, by the edges from its first corner, or from its second.
    std::size_t chord_of(int face, bool turned) const {
        const auto corners = mesh_.corners(face);
        const std::size_t k = turned ? 1 : 0;
        return at(labels_.of_edge[at(mesh_.find_edge(corners[k], corners[k + 1]))]);
    }

    // Rows that become higher away from the boundary tell where the wall is: far from it faces may be as
    // stretched the other way, along other parts of the boundary. Without such rows all count.
    void begin_at_layers() {
        const std::vector<int> faces = layers_of(mesh_);
        if (static_cast<double>(faces.size()) < least_part * mesh_.n_faces())
            return;
        for (const double growth : {least_growth, 0.0}) {
            for (const int f : faces)
                begin_at(f, growth);
            if (std::ranges::any_of(is_column_, [](char column) { return column != 0; }))
                return;
        }
    }

    void begin_at(int face, double growth) {
        const auto corners = mesh_.corners(face), across = mesh_.neighbours(face);
        for (std::size_t k = 0; k < 4; ++k) {
            const int edge = mesh_.find_edge(corners[k], corners[(k + 1) % 4]),
                      rail = mesh_.find_edge(corners[(k + 1) % 4], corners[(k + 2) % 4]);
            if (across[k] >= 0 || length_of(mesh_, edge) <= length_of(mesh_, rail))
                continue;
            const int next = across[(k + 2) % 4];
            if (growth == 0 ||
                (next >= 0 && height_of(next, corners[(k + 2) % 4]) > growth * length_of(mesh_, rail)))
                is_column_[at(labels_.of_edge[at(edge)])] = 1;
        }
    }

    // Of a face above another, by the edge from a corner of both that is not between them.
    double height_of(int face, int corner) const {
        const auto corners = mesh_.corners(face);
        const auto k = static_cast<std::size_t>(std::ranges::find(corners, corner) - corners.begin());
        return length_of(mesh_, mesh_.find_edge(corner, corners[(k + 1) % 4]));
    }

    std::vector<int> in_order(const reference::Boundary &boundary) const {
        std::vector<std::tuple<int, double, int>> order; // curve, place on it, edge
        for (std::size_t c = 0; c < is_column_.size(); ++c) {
            const Chord chord = chord::trace(mesh_, labels_.first[c]);
            if (!is_column_[c] || chord.closed || chord.crossings > 0)
                continue;
            std::tuple<int, double, int> first{boundary.curves->count(), 0, 0};
            for (const int side : {chord.sides.front(), chord.sides.back()}) {
                const surface::CurvePlace place = boundary.places[at(mesh_.edge_vertices(side / 2)[0])];
                first = std::min(first, {place.curve, place.along, side / 2});
            }
            order.push_back(first);
        }
        std::sort(order.begin(), order.end());
        std::vector<int> edges;
        for (const auto &[curve, along, edge] : order)
            edges.push_back(edge);
        return edges;
    }

    const mesh::QuadMesh &mesh_;
    const chord::Labels labels_;
    std::vector<char> is_column_, is_row_; // [chord]
};

std::vector<int> find_columns(const mesh::QuadMesh &mesh) {
    return Columns(mesh).find(reference::boundary_of(mesh, 1));
}

// Puts the vertices of a new line between two columns so that its ends are on the boundary and the others
// keep their distances from them: they follow the ends the less the farther they are.
void bend(mesh::QuadMesh &mesh, const std::vector<int> &line, const Vector3d &start, const Vector3d &end) {
    std::vector<double> along{0};
    for (std::size_t i = 1; i < line.size(); ++i)
        along.push_back(along.back() +
                        (reference::point_of(mesh, line[i]) - reference::point_of(mesh, line[i - 1])).norm());
    const Vector3d first = start - reference::point_of(mesh, line.front()),
                   last = end - reference::point_of(mesh, line.back());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double t = along[i] / along.back();
        const Vector3d p = reference::point_of(mesh, line[i]) + (1 - t) * first + t * last;
        mesh.set_point(line[i], {p.x(), p.y(), p.z()});
    }
    mesh.set_point(line.front(), {start.x(), start.y(), start.z()});
    mesh.set_point(line.back(), {end.x(), end.y(), end.z()});
}

// Part of the way from one vertex of the boundary to the next, in whichever direction that is shorter.
Vector3d between(const reference::Boundary &boundary, int v, int w, double part) {
    const surface::BoundaryCurves &curves = *boundary.curves;
    const surface::CurvePlace from = boundary.places[at(v)], to = boundary.places[at(w)];
    const double ahead = curves.way(from, to), back = curves.way(to, from);
    return ahead <= back ? curves.at(curves.advance(from, part * ahead))
                         : curves.at(curves.advance(to, (1 - part) * back));
}

void split_column(mesh::QuadMesh &mesh, int edge, int copies, const reference::Boundary &boundary) {
    const Chord chord = chord::trace(mesh, edge);
    std::vector<std::array<int, 2>> ends; // of its first and last edge
    for (const int side : {chord.sides.front(), chord.sides.back()}) {
        const auto h = mesh::Kernel::HalfedgeHandle(side);
        ends.push_back({mesh.kernel().from_vertex_handle(h).idx(), mesh.kernel().to_vertex_handle(h).idx()});
    }
    const std::vector<int> vertices = mesh.split_chord(chord.sides, copies).vertices;
    for (int k = 0; k < copies; ++k) {
        std::vector<int> line;
        for (std::size_t i = 0; i < chord.sides.size(); ++i)
            line.push_back(vertices[i * at(copies) + at(k)]);
        const double part = static_cast<double>(k + 1) / (copies + 1);
        const auto near = [&](const std::array<int, 2> &end) { // the piece may be numbered from either end
            const Vector3d a = reference::point_of(mesh, end[0]), b = reference::point_of(mesh, end[1]);
            const int v = end == ends[0] ? line.front() : line.back();
            const double there = (reference::point_of(mesh, v) - a).norm() / (b - a).norm();
            return between(boundary, end[0], end[1],
                           std::abs(there - part) < 0.5 / (copies + 1) ? part : 1 - part);
        };
        bend(mesh, line, near(ends[0]), near(ends[1]));
    }
}

// Whether a vertex of the boundary may go, and the edge that comes keeps to the curve.
bool may_go(const mesh::QuadMesh &mesh, const reference::Boundary &boundary, int vertex, double tolerance) {
    if (!boundary.may_go(vertex))
        return false;
    const std::vector<int> around = mesh.vertices_around(vertex);
    const surface::BoundaryCurves &curves = *boundary.curves;
    surface::CurvePlace from = boundary.places[at(around.front())], to = boundary.places[at(around.back())];
    if (from.curve < 0 || to.curve != from.curve)
        return false;
    if (curves.way(from, boundary.places[at(vertex)]) > curves.way(from, to))
        std::swap(from, to);
    const double length = (curves.at(to) - curves.at(from)).norm();
    return boundary.keeps_curve(from, curves.way(from, to), tolerance * length);
}

// Columns of one mesh that go, one after the other.
class Merging {
public:
    Merging(mesh::QuadMesh &mesh, const Settings &settings)
        : mesh_(mesh), settings_(settings), judge_(mesh, rules()), boundary_(reference::boundary_of(mesh, 1)),
          vertices_(mesh.n_vertices()) {}

    // Takes away one of the two lines of the column between two vertices, by what these were at first, where
    // both its ends may go; the vertices of the other stay where they are, and so do the heights of the rows.
    bool merge(const std::array<int, 2> &names) {
        const int v = vertices_.now(names[0]), w = vertices_.now(names[1]);
        const int edge = v >= 0 && w >= 0 ? mesh_.find_edge(v, w) : -1;
        if (edge < 0)
            return false;
        const Chord chord = chord::trace(mesh_, edge);
        if (chord.closed || chord.touches > 0 || judge_(chord).reasons != 0)
            return false;
        for (const std::size_t gone : {0, 1})
            if (ends_may_go(chord, gone)) {
                remove(chord, gone);
                return true;
            }
        return false;
    }

private:
    static chord::Rules rules() {
        chord::Rules rules;
        rules.boundary = true;
        rules.straight = 180; // may_go looks at the curve itself
        return rules;
    }

    std::array<int, 2> ends(int side) const {
        const auto h = mesh::Kernel::HalfedgeHandle(side);
        return {mesh_.kernel().from_vertex_handle(h).idx(), mesh_.kernel().to_vertex_handle(h).idx()};
    }

    bool ends_may_go(const Chord &chord, std::size_t gone) const {
        return may_go(mesh_, boundary_, ends(chord.sides.front())[gone], settings_.tolerance) &&
               may_go(mesh_, boundary_, ends(chord.sides.back())[gone], settings_.tolerance);
    }

    void remove(const Chord &chord, std::size_t gone) {
        std::vector<std::array<int, 2>> merged;
        for (const int side : chord.sides)
            merged.push_back({ends(side)[gone], ends(side)[1 - gone]});
        for (const auto &pair : merged)
            vertices_.remove(pair[0]);
        const auto moved = mesh_.collapse_chord(chord.sides, merged).moved_vertices;
        for (const auto &[from, to] : moved)
            vertices_.move(from, to);
        boundary_.follow(moved, mesh_.n_vertices());
    }

    mesh::QuadMesh &mesh_;
    const Settings &settings_;
    chord::Judge judge_;
    reference::Boundary boundary_;
    mesh::Renumbered vertices_; // since the first column went
};

// Every so many of n, evenly: whether the i-th is one.
bool takes(std::size_t i, std::size_t of, std::size_t n) { return (i + 1) * of / n > i * of / n; }

} // namespace

namespace {

void refine(mesh::QuadMesh &mesh, const std::vector<int> &columns, std::size_t target,
            const reference::Boundary &boundary) {
    const std::size_t n = columns.size(), more = target - n;
    for (std::size_t i = 0; i < n; ++i)
        if (const std::size_t copies = more / n + (takes(i, more % n, n) ? 1 : 0); copies > 0)
            split_column(mesh, columns[i], static_cast<int>(copies), boundary);
}

// Each column once, at most; whether any went.
bool coarsen(mesh::QuadMesh &mesh, const std::vector<int> &columns, std::size_t target,
             const Settings &settings) {
    std::vector<std::array<int, 2>> ends; // edges are renumbered
    for (const int edge : columns)
        ends.push_back(mesh.edge_vertices(edge));
    const std::size_t n = columns.size(), less = std::min(n - target, n / 2);
    Merging merging(mesh, settings);
    bool any = false;
    for (std::size_t i = 0; i < n; ++i)
        if (takes(i, less, n))
            any = merging.merge(ends[i]) || any;
    return any;
}

} // namespace

bool adapt_columns(mesh::QuadMesh &mesh, std::int64_t wanted, const Settings &settings) {
    mesh::QuadMesh changed = mesh;
    const std::int64_t faces = mesh.n_faces();
    std::vector<int> columns = find_columns(mesh);
    if (columns.empty() || wanted == faces)
        return false;
    // A column more or less is left to windows.
    const double exact =
        static_cast<double>(columns.size()) * static_cast<double>(wanted) / static_cast<double>(faces);
    if (wanted > faces) {
        refine(changed, columns, at(static_cast<int>(exact + rounding)), reference::boundary_of(mesh, 1));
    } else {
        const auto target = static_cast<std::size_t>(std::max(1.0, std::ceil(exact - rounding)));
        while (columns.size() > target && coarsen(changed, columns, target, settings))
            columns = find_columns(changed);
    }
    if (changed.n_faces() == faces ||
        reference::least_quality(changed) < std::min(least_quality, reference::least_quality(mesh)))
        return false;
    mesh = std::move(changed);
    return true;
}

} // namespace alphamst::adapt
