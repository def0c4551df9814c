#include "reference/boundary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "index.h"
#include "patch/region.h"
#include "reference/locate.h"
#include "surface/angle.h"
#include "surface/curve.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;
using surface::BoundaryCurves;
using surface::CurvePlace;
using surface::degrees_between;

constexpr double corner_turn = 60; // degrees
constexpr double at_corner = 0.03; // of an edge, where a curve may bend slowly within it
// Of the length of a curve, how far off vertices are that lie on it.
constexpr double rounding_of_curves = 1e-9;
// Away from the corner by so many edges that are wanted, that part of the turn is left, or it is none.
constexpr double reach_of_corner = 2, left_of_turn = 0.75;

// Something ends at the vertex, changes there along the boundary, or holds it.
bool is_held(const mesh::QuadMesh &mesh, int v) {
    if (mesh.vertex_flags[at(v)] != 0)
        return true;
    const std::vector<int> around = mesh.vertices_around(v);
    const auto value = [](const auto &values, int i) { return values.empty() ? 0 : int(values[at(i)]); };
    const auto first = mesh.find_edge(v, around.front()), last = mesh.find_edge(v, around.back());
    if ((mesh.edge_flags[at(first)] & ~mesh::feature) != 0 ||
        mesh.edge_flags[at(first)] != mesh.edge_flags[at(last)] ||
        (!mesh.curve_numbers && value(mesh.edge_marker, first) != value(mesh.edge_marker, last)))
        return true;
    for (std::size_t i = 1; i + 1 < around.size(); ++i) {
        const int edge = mesh.find_edge(v, around[i]);
        const auto [left, right] = mesh.edge_faces(edge);
        if (mesh.edge_flags[at(edge)] != 0 || value(mesh.edge_marker, edge) != 0 ||
            value(mesh.face_marker, left) != value(mesh.face_marker, right))
            return true;
    }
    const std::vector<int> faces = mesh.faces_around(v);
    return std::any_of(faces.begin(), faces.end(), [&](int f) { return mesh.face_flags[at(f)] != 0; });
}

bool is_corner(const BoundaryCurves &curves, CurvePlace place, double edge_length) {
    const Vector3d point = curves.at(place);
    const double round = curves.length(place.curve);
    const auto turn = [&](double reach) {
        const Vector3d before = curves.at(curves.advance(place, round - reach)),
                       after = curves.at(curves.advance(place, reach));
        return degrees_between(point - before, after - point);
    };
    return turn(std::min(at_corner * edge_length, round / 4)) > corner_turn &&
           turn(std::min(reach_of_corner * edge_length, round / 4)) > left_of_turn * corner_turn;
}

// Over neighbours, as present sizes of faces are.
void smooth(std::vector<Boundary::Length> &edges) {
    constexpr int smoothings = 6;
    const std::size_t n = edges.size();
    std::vector<double> logs(n);
    for (int k = 0; k < smoothings; ++k) {
        for (std::size_t i = 0; i < n; ++i)
            logs[i] = (edges[(i + n - 1) % n].log + 2 * edges[i].log + edges[(i + 1) % n].log) / 4;
        for (std::size_t i = 0; i < n; ++i)
            edges[i].log = logs[i];
    }
}

} // namespace

std::vector<std::vector<int>> boundary_cycles(const mesh::QuadMesh &mesh) {
    const mesh::Kernel &kernel = mesh.kernel();
    std::vector<char> seen(kernel.n_halfedges(), 0);
    std::vector<std::vector<int>> all;
    for (std::size_t i = 0; i < kernel.n_halfedges(); ++i) {
        patch::Halfedge h(static_cast<int>(i));
        if (seen[i] || !kernel.is_boundary(h))
            continue;
        std::vector<int> &cycle = all.emplace_back();
        for (; !seen[at(h.idx())]; h = kernel.next_halfedge_handle(h)) {
            seen[at(h.idx())] = 1;
            cycle.push_back(patch::from(mesh, h));
        }
        std::reverse(cycle.begin(), cycle.end());
    }
    return all;
}

bool Boundary::may_change(const mesh::QuadMesh &mesh, int v, int w) const {
    const int edge = mesh.find_edge(v, w);
    const auto [left, right] = mesh.edge_faces(edge);
    return (left < 0 || right < 0) && (mesh.edge_flags[at(edge)] & ~mesh::feature) == 0 &&
           places[at(v)].curve >= 0 && places[at(w)].curve >= 0;
}

bool Boundary::keeps_curve(CurvePlace from, double length, double most) const {
    const surface::Line line{curves->at(from), curves->at(curves->advance(from, length))};
    double missed = 0;
    for (const auto &bend : curves->between(from, length))
        missed = std::max(missed, line.distance(bend.point));
    if (missed == 0)
        return true;
    // Two edges that come nearer to each other by less than half of what is between them do not meet.
    return missed <= most && !curves->others_near(from, length, 2 * missed);
}

void Boundary::follow(std::span<const std::array<int, 2>> moved, int n_vertices) {
    for (const auto &[from, to] : moved) {
        places[at(to)] = places[at(from)];
        stays[at(to)] = stays[at(from)];
    }
    places.resize(at(n_vertices));
    stays.resize(at(n_vertices));
}

double Boundary::present_length(CurvePlace place) const {
    const std::vector<Length> &edges = lengths[at(place.curve)];
    const auto after = std::lower_bound(edges.begin(), edges.end(), place.along,
                                        [](const Length &edge, double along) { return edge.along < along; });
    const double round = curves->length(place.curve);
    const bool first = after == edges.begin(), last = after == edges.end();
    const Length &before = first ? edges.back() : *(after - 1), &next = last ? edges.front() : *after;
    const double start = first ? before.along - round : before.along,
                 end = last ? next.along + round : next.along;
    const double part = end > start ? (place.along - start) / (end - start) : 0;
    return std::exp(before.log + part * (next.log - before.log));
}

namespace {

// The places of the vertices of a cycle on curves that are there; false if they are not all on one, in order.
bool find_places(const mesh::QuadMesh &mesh, const BoundaryCurves &curves, const std::vector<int> &cycle,
                 std::vector<CurvePlace> &places) {
    double way = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const Vector3d point = point_of(mesh, cycle[i]);
        CurvePlace &place = places[at(cycle[i])];
        place = curves.find(point, rounding_of_curves * curves.extent());
        if (place.curve < 0)
            return false;
        if (i == 0)
            continue;
        const CurvePlace before = places[at(cycle[i - 1])];
        if (before.curve != place.curve)
            return false;
        way += curves.way(before, place);
    }
    const double round = curves.length(places[at(cycle[0])].curve);
    return way + curves.way(places[at(cycle.back())], places[at(cycle[0])]) < 1.5 * round;
}

std::vector<Boundary::Length> lengths_of(const mesh::QuadMesh &mesh, const BoundaryCurves &curves,
                                         const std::vector<int> &cycle,
                                         const std::vector<CurvePlace> &places) {
    std::vector<Boundary::Length> lengths;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const int v = cycle[i], w = cycle[(i + 1) % cycle.size()];
        const CurvePlace place = places[at(v)];
        const double length = (point_of(mesh, w) - point_of(mesh, v)).norm();
        lengths.push_back({curves.advance(place, curves.way(place, places[at(w)]) / 2).along,
                           std::log(std::max(length, 1e-300))});
    }
    smooth(lengths);
    std::rotate(lengths.begin(), std::ranges::min_element(lengths, {}, &Boundary::Length::along),
                lengths.end());
    return lengths;
}

// Of a part of a mesh, in which each vertex is looked for by itself: where the mesh goes on beyond, the
// boundary of the part is on no curve. Lengths are those of edges whose faces may change.
void find_in_part(const mesh::QuadMesh &mesh, Boundary &boundary) {
    const BoundaryCurves &curves = *boundary.curves;
    for (const std::vector<int> &cycle : boundary_cycles(mesh)) {
        for (const int v : cycle)
            boundary.places[at(v)] = curves.find(point_of(mesh, v), rounding_of_curves * curves.extent());
        for (std::size_t i = 0; i < cycle.size(); ++i) {
            const int v = cycle[i], w = cycle[(i + 1) % cycle.size()];
            const CurvePlace start = boundary.places[at(v)], end = boundary.places[at(w)];
            const auto [left, right] = mesh.edge_faces(mesh.find_edge(v, w));
            if (start.curve < 0 || end.curve < 0 || mesh.face_flags[at(std::max(left, right))] != 0)
                continue;
            boundary.lengths[at(start.curve)].push_back(
                {curves.advance(start, curves.way(start, end) / 2).along,
                 std::log(std::max((point_of(mesh, w) - point_of(mesh, v)).norm(), 1e-300))});
        }
    }
    for (std::vector<Boundary::Length> &lengths : boundary.lengths)
        std::ranges::sort(lengths, {}, &Boundary::Length::along);
}

} // namespace

std::shared_ptr<const BoundaryCurves> curves_of_boundary(const mesh::QuadMesh &mesh) {
    std::vector<std::vector<Vector3d>> points;
    for (const std::vector<int> &cycle : boundary_cycles(mesh)) {
        points.emplace_back();
        for (const int v : cycle)
            points.back().push_back(point_of(mesh, v));
    }
    return std::make_shared<const BoundaryCurves>(std::move(points));
}

Boundary boundary_of(const mesh::QuadMesh &mesh, double longer) {
    Boundary boundary;
    boundary.curves = mesh.boundary ? mesh.boundary : curves_of_boundary(mesh);
    const BoundaryCurves &curves = *boundary.curves;
    boundary.places.resize(at(mesh.n_vertices()));
    boundary.stays.assign(at(mesh.n_vertices()), 1);
    boundary.lengths.resize(at(curves.count()));
    const std::vector<std::vector<int>> cycles = boundary_cycles(mesh);
    if (mesh.is_part())
        find_in_part(mesh, boundary);
    else
        for (const std::vector<int> &cycle : cycles) {
            if (find_places(mesh, curves, cycle, boundary.places))
                boundary.lengths[at(boundary.places[at(cycle[0])].curve)] =
                    lengths_of(mesh, curves, cycle, boundary.places);
            else
                for (const int v : cycle)
                    boundary.places[at(v)] = {};
        }
    for (const std::vector<int> &cycle : cycles)
        for (const int v : cycle)
            if (const CurvePlace place = boundary.places[at(v)]; place.curve >= 0)
                boundary.stays[at(v)] =
                    is_held(mesh, v) || is_corner(curves, place, longer * boundary.present_length(place));
    return boundary;
}

bool is_on(const mesh::QuadMesh &mesh, const BoundaryCurves &curves) {
    std::vector<CurvePlace> places(at(mesh.n_vertices()));
    return std::ranges::all_of(boundary_cycles(mesh), [&](const std::vector<int> &cycle) {
        return find_places(mesh, curves, cycle, places);
    });
}

} // namespace alphamst::reference
