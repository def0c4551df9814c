// Curved meshes without poles or seams.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

// n x m faces, a vertex at place(0..1, 0..1); the last column of vertices is the first when `round`, and the
// last row when `tube`.
template <class Place>
QuadMesh grid(int n, int m, const Place &place, bool round = false, bool tube = false, int dim = 3) {
    const int columns = round ? n : n + 1, rows = tube ? m : m + 1;
    std::vector<double> points;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Eigen::Vector3d p = place(static_cast<double>(i) / n, static_cast<double>(j) / m);
            points.insert(points.end(), {p.x(), p.y(), p.z()});
        }
    std::vector<std::int32_t> faces;
    const auto id = [&](int i, int j) { return j % rows * columns + i % columns; };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            for (const int v : {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)})
                faces.push_back(v);
    return QuadMesh::build(dim, points, faces);
}

// The sides of a cube, each n by n faces, a vertex at place(Vector3d) of three numbers 0..n.
template <class Place> QuadMesh cube(int n, const Place &place) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    std::map<std::array<int, 3>, int> ids;
    const auto id = [&](std::size_t axis, int side, int i, int j) {
        std::array<int, 3> key{};
        key[axis] = side * n;
        key[(axis + 1) % 3] = i;
        key[(axis + 2) % 3] = j;
        const auto [entry, added] = ids.emplace(key, static_cast<int>(ids.size()));
        if (added) {
            const Eigen::Vector3d p = place(Eigen::Vector3d(key[0], key[1], key[2]));
            points.insert(points.end(), {p.x(), p.y(), p.z()});
        }
        return entry->second;
    };
    for (const int side : {0, 1})
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    std::array<int, 4> quad{id(axis, side, i, j), id(axis, side, i + 1, j),
                                            id(axis, side, i + 1, j + 1), id(axis, side, i, j + 1)};
                    if (side == 0)
                        std::swap(quad[1], quad[3]);
                    faces.insert(faces.end(), quad.begin(), quad.end());
                }
    return QuadMesh::build(3, points, faces);
}

// The sphere of radius 1 around the origin: the sides of a cube, each n by n faces of equal angles.
inline QuadMesh sphere(int n) {
    return cube(n, [n](const Eigen::Vector3d &i) {
        Eigen::Vector3d p;
        for (int k = 0; k < 3; ++k)
            p[k] = std::tan(std::numbers::pi / 4 * (2.0 * i[k] / n - 1));
        return Eigen::Vector3d(p.normalized());
    });
}

} // namespace alphamst::mesh
