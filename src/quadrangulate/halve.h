// New vertices while a mesh is made all-quad.
#pragma once

#include <algorithm>
#include <initializer_list>

#include "quadrangulate/quadrangulate.h"

namespace alphamst::quadrangulate {

// At the mean of vertices.
inline std::int32_t append_vertex(QuadArrays &quads, std::initializer_list<std::int32_t> of) {
    const auto n = static_cast<double>(of.size());
    for (std::size_t k = 0; k < 3; ++k) {
        double mean = 0;
        for (const std::int32_t v : of)
            mean += quads.points[3 * static_cast<std::size_t>(v) + k] / n;
        quads.points.push_back(mean);
    }
    return static_cast<std::int32_t>(quads.points.size() / 3) - 1;
}

// At the midpoint of an edge that has none yet.
inline std::int32_t halve(QuadArrays &quads, std::int32_t v, std::int32_t w) {
    const auto [smaller, larger] = std::minmax(v, w);
    const std::int32_t vertex = append_vertex(quads, {smaller, larger});
    quads.midpoints.push_back({{smaller, larger}, vertex});
    return vertex;
}

inline void add_face(QuadArrays &quads, std::int32_t origin, const std::array<std::int32_t, 4> &corners) {
    quads.faces.insert(quads.faces.end(), corners.begin(), corners.end());
    quads.origin.push_back(origin);
}

// Three quads of a triangle, four of a quad; midpoint(c) is that of the side at corner c.
template <class Midpoint>
void split_face(QuadArrays &quads, mesh::Faces faces, std::size_t face, std::int32_t origin,
                Midpoint midpoint) {
    const std::size_t n = mesh::is_triangle(faces, face) ? 3 : 4, first = 4 * face;
    const std::int32_t centre =
        n == 3 ? append_vertex(quads, {faces[first], faces[first + 1], faces[first + 2]})
               : append_vertex(quads, {faces[first], faces[first + 1], faces[first + 2], faces[first + 3]});
    for (std::size_t k = 0; k < n; ++k)
        add_face(quads, origin,
                 {faces[first + k], midpoint(first + k), centre, midpoint(first + (k + n - 1) % n)});
}

// The corner across the edge of each corner of the faces, -1 at the boundary.
inline std::vector<std::int32_t> across_edges(mesh::Faces faces, const mesh::Halfedges &halfedges) {
    std::vector<std::array<std::int32_t, 2>> sides(halfedges.n_edges, {-1, -1});
    for (std::size_t c = 0; c < faces.size(); ++c)
        if (const std::int32_t h = halfedges.of_corner[c]; h >= 0)
            sides[static_cast<std::size_t>(h / 2)][static_cast<std::size_t>(h % 2)] =
                static_cast<std::int32_t>(c);
    std::vector<std::int32_t> across(faces.size(), -1);
    for (const auto &[c, d] : sides)
        if (c >= 0 && d >= 0) {
            across[static_cast<std::size_t>(c)] = d;
            across[static_cast<std::size_t>(d)] = c;
        }
    return across;
}

} // namespace alphamst::quadrangulate
