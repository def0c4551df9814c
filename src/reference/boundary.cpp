#include "reference/boundary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "index.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

using Eigen::Vector3d;
using surface::BoundaryCurves;
using surface::CurvePlace;
using surface::degrees_between;

constexpr double corner_turn = 60; // degrees
// Away from the corner by so many edges that are wanted, that part of the turn is left, or it is none.
constexpr double reach_of_corner = 2, left_of_turn = 0.75;

// [curve][vertex], the mesh at their left.
std::vector<std::vector<int>> cycles(const mesh::QuadMesh &mesh) {
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

bool is_corner(const BoundaryCurves &curves, CurvePlace place, const Vector3d &before, const Vector3d &after,
               double edge_length) {
    const Vector3d point = curves.at(place);
    if (degrees_between(point - before, after - point) <= corner_turn)
        return false;
    const double reach = std::min(reach_of_corner * edge_length, curves.length(place.curve) / 4);
    const Vector3d far_before = curves.at(curves.advance(place, curves.length(place.curve) - reach)),
                   far_after = curves.at(curves.advance(place, reach));
    return degrees_between(point - far_before, far_after - point) > left_of_turn * corner_turn;
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

bool Boundary::may_change(const mesh::QuadMesh &mesh, int v, int w) const {
    const int edge = mesh.find_edge(v, w);
    const auto [left, right] = mesh.edge_faces(edge);
    return (left < 0 || right < 0) && (mesh.edge_flags[at(edge)] & ~mesh::feature) == 0 &&
           places[at(v)].curve >= 0 && places[at(w)].curve >= 0;
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

Boundary boundary_of(const mesh::QuadMesh &mesh, double longer) {
    Boundary boundary;
    boundary.places.resize(at(mesh.n_vertices()));
    boundary.stays.assign(at(mesh.n_vertices()), 1);
    const std::vector<std::vector<int>> vertices = cycles(mesh);
    std::vector<std::vector<Vector3d>> points;
    for (std::size_t c = 0; c < vertices.size(); ++c) {
        points.emplace_back();
        for (const int v : vertices[c])
            points.back().push_back(point_of(mesh, v));
        std::vector<Boundary::Length> &lengths = boundary.lengths.emplace_back();
        double along = 0;
        for (std::size_t i = 0; i < points.back().size(); ++i) {
            boundary.places[at(vertices[c][i])] = {static_cast<int>(c), along};
            const double length = (points.back()[(i + 1) % points.back().size()] - points.back()[i]).norm();
            lengths.push_back({along + length / 2, std::log(std::max(length, 1e-300))});
            along += length;
        }
        smooth(lengths);
    }
    boundary.curves = std::make_shared<const BoundaryCurves>(std::move(points));
    for (const std::vector<int> &cycle : vertices)
        for (std::size_t i = 0; i < cycle.size(); ++i) {
            const CurvePlace place = boundary.places[at(cycle[i])];
            const Vector3d after = point_of(mesh, cycle[(i + 1) % cycle.size()]),
                           before = point_of(mesh, cycle[(i + cycle.size() - 1) % cycle.size()]);
            boundary.stays[at(cycle[i])] =
                is_held(mesh, cycle[i]) ||
                is_corner(*boundary.curves, place, before, after, longer * boundary.present_length(place));
        }
    return boundary;
}

} // namespace alphamst::reference
