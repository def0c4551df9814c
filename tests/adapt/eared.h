// A curved mesh of many singularities for the tests of this folder.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mesh/quad_mesh.h"
#include "quadrangulate/quadrangulate.h"

namespace alphamst::adapt::samples {

// A ball with two long ears, of triangles from an octahedron, paired: many singular vertices.
inline mesh::QuadMesh eared(int levels) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    std::vector<Eigen::Vector3d> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<int, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                              {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::array<int, 2>, int> middle;
        const auto half = [&](int a, int b) {
            const auto [it, fresh] =
                middle.emplace(std::array{std::min(a, b), std::max(a, b)}, int(points.size()));
            if (fresh)
                points.push_back((points[at(a)] + points[at(b)]).normalized());
            return it->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto &[a, b, c] : triangles) {
            const int ab = half(a, b), bc = half(b, c), ca = half(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        triangles = std::move(finer);
    }
    std::vector<double> coordinates;
    std::vector<std::int32_t> faces;
    for (const Eigen::Vector3d &p : points) {
        double height = 1;
        for (const double side : {-1.0, 1.0}) {
            const double away = (p - Eigen::Vector3d(0.6 * side, 0, 0.8)).squaredNorm();
            height += 0.8 * std::exp(-18 * away);
        }
        for (const double x : {p.x(), p.y(), p.z()})
            coordinates.push_back(height * x);
    }
    for (const auto &triangle : triangles)
        faces.insert(faces.end(), {triangle[0], triangle[1], triangle[2], -1});
    const auto quads =
        quadrangulate::quadrangulate({coordinates, faces, {}, {}}, quadrangulate::Quadrangulation::pair);
    return mesh::QuadMesh::build(3, quads.points, quads.faces);
}

} // namespace alphamst::adapt::samples
