#include "quadrangulate/bars.h"

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "disjoint_sets.h"
#include "index.h"

namespace alphamst::quadrangulate {
namespace {

using Vector = OpenMesh::Vec3d;
using Edge = std::array<std::int32_t, 2>;

Edge edge_at(mesh::Faces faces, std::size_t c) {
    const std::int32_t v = faces[c], w = faces[mesh::next_corner(faces, c)];
    return {std::min(v, w), std::max(v, w)};
}

bool is_plane(mesh::Coordinates points) {
    for (std::size_t i = 2; i < points.size(); i += 3)
        if (points[i] != points[2])
            return false;
    return true;
}

// Of length 1, or 0 for a face without area.
std::vector<Vector> normals_of(mesh::Coordinates points, mesh::Faces faces) {
    std::vector<Vector> normals;
    normals.reserve(faces.size() / 4);
    const auto point = [&](std::int32_t v) {
        return Vector(points[3 * at(v)], points[3 * at(v) + 1], points[3 * at(v) + 2]);
    };
    for (std::size_t f = 0; f < faces.size() / 4; ++f) {
        const Vector a = point(faces[4 * f]), b = point(faces[4 * f + 1]), c = point(faces[4 * f + 2]);
        const Vector d = mesh::is_triangle(faces, f) ? a : point(faces[4 * f + 3]);
        const Vector normal = (c - a) % (mesh::is_triangle(faces, f) ? c - b : d - b);
        const double length = normal.norm();
        normals.push_back(length > 0 ? normal / length : Vector(0, 0, 0));
    }
    return normals;
}

// Sharp edges are between flat sides if they are on closed curves of them, or on curves between boundaries
// and borders. Trees of the others part nothing; scanned surfaces are full of them.
void mark_creases(mesh::Faces faces, const std::vector<std::int32_t> &across, std::size_t n_vertices,
                  std::vector<Bar> &bars) {
    constexpr std::int32_t many = 1000; // more than there are sharp edges at a vertex
    std::vector<std::int32_t> degree(n_vertices);
    std::vector<std::vector<std::size_t>> sides(n_vertices); // empty but at few vertices
    for (std::size_t c = 0; c < faces.size(); ++c) {
        if (faces[c] < 0)
            continue;
        const auto [v, w] = edge_at(faces, c);
        if (across[c] < 0 || bars[c] == Bar::curve) {
            degree[at(v)] = degree[at(w)] = many;
        } else if (bars[c] == Bar::sharp && across[c] > static_cast<std::int32_t>(c)) {
            for (const std::int32_t end : {v, w}) {
                ++degree[at(end)];
                sides[at(end)].push_back(c);
            }
        }
    }
    std::vector<std::int32_t> ends;
    for (std::size_t v = 0; v < n_vertices; ++v)
        if (degree[v] == 1)
            ends.push_back(static_cast<std::int32_t>(v));
    for (std::size_t head = 0; head < ends.size(); ++head)
        for (const std::size_t c : sides[at(ends[head])])
            if (bars[c] == Bar::sharp) {
                bars[c] = bars[at(across[c])] = Bar::crease;
                const auto [v, w] = edge_at(faces, c);
                const std::int32_t other = v == ends[head] ? w : v;
                if (--degree[at(other)] == 1)
                    ends.push_back(other);
            }
}

// Whether most of what sharp edges part is no more than a few triangles.
bool are_splinters(mesh::Faces faces, const std::vector<std::int32_t> &across, const std::vector<Bar> &bars) {
    constexpr std::int32_t few = 3;
    DisjointSets sides(faces.size() / 4);
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (across[c] > static_cast<std::int32_t>(c) && bars[c] < Bar::sharp)
            sides.unite(static_cast<std::int32_t>(c / 4), across[c] / 4);
    std::vector<std::int32_t> size(faces.size() / 4);
    for (std::size_t f = 0; f < size.size(); ++f)
        ++size[at(sides.find(static_cast<std::int32_t>(f)))];
    const auto all = std::ranges::count_if(size, [](std::int32_t n) { return n > 0; });
    return 2 * std::ranges::count_if(size, [](std::int32_t n) { return n > 0 && n <= few; }) > all;
}

} // namespace

std::vector<Bar> bars_of(const Polygons &polygons, mesh::Faces faces, std::span<const std::int32_t> origin,
                         const std::vector<std::int32_t> &across, double sharp_angle) {
    std::vector<Bar> bars(faces.size(), Bar::none);
    std::size_t n_sharp = 0, n_blunt = 0;
    if (sharp_angle < 180 && !is_plane(polygons.points)) {
        const std::vector<Vector> normals = normals_of(polygons.points, faces);
        const double least = std::cos(sharp_angle * std::numbers::pi / 180),
                     half = std::cos(sharp_angle * std::numbers::pi / 360);
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (across[c] >= 0) {
                const Vector &n = normals[c / 4], &m = normals[at(across[c] / 4)];
                const double cosine = n | m;
                // The direction of a face without area is not known.
                if (cosine >= half || n.sqrnorm() == 0 || m.sqrnorm() == 0)
                    continue;
                ++(cosine < least ? n_sharp : n_blunt);
                if (cosine < least)
                    bars[c] = Bar::sharp;
            }
    }
    const auto marker = [&](std::size_t corner) {
        return polygons.face_marker[origin.empty() ? corner / 4 : at(origin[corner / 4])];
    };
    if (!polygons.face_marker.empty())
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (across[c] >= 0 && marker(c) != marker(at(across[c])))
                bars[c] = Bar::curve;
    std::vector<Edge> curves;
    for (const auto &[v, w] : polygons.curves)
        curves.push_back({std::min(v, w), std::max(v, w)});
    std::sort(curves.begin(), curves.end());
    if (!curves.empty())
        for (std::size_t c = 0; c < faces.size(); ++c)
            if (faces[c] >= 0 && across[c] >= 0 &&
                std::binary_search(curves.begin(), curves.end(), edge_at(faces, c)))
                bars[c] = Bar::curve;
    if (n_sharp == 0)
        return bars;
    mark_creases(faces, across, polygons.points.size() / 3, bars);
    // A rough surface, such as a scanned one, has no flat sides: its angles go on beyond that of sharp edges.
    if (2 * n_blunt > n_sharp && are_splinters(faces, across, bars))
        for (Bar &bar : bars)
            if (bar == Bar::sharp || bar == Bar::crease)
                bar = Bar::none;
    return bars;
}

std::vector<Edge> barred_edges(mesh::Faces faces, const std::vector<Bar> &bars) {
    std::vector<Edge> edges;
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (bars[c] >= Bar::sharp)
            edges.push_back(edge_at(faces, c));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

} // namespace alphamst::quadrangulate
