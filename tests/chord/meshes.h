// Meshes of many kinds for the tests of this folder: all of dim 3, so that shapes do not matter.
#pragma once

#include <array>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "adapt/meshes.h"
#include "chord/trace.h"
#include "mesh/grids.h"

namespace alphamst::chord::samples {

using adapt::samples::grid;
using adapt::samples::star;

// The surface of a cube of n by n by n unit cubes.
inline mesh::QuadMesh sphere(int n) {
    std::map<std::array<int, 3>, int> vertices;
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    const auto vertex = [&](std::array<int, 3> p) {
        const auto [it, fresh] = vertices.try_emplace(p, static_cast<int>(points.size() / 3));
        if (fresh)
            points.insert(points.end(), {double(p[0]), double(p[1]), double(p[2])});
        return it->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int level : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    std::array<std::array<int, 2>, 4> corners{
                        {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
                    if (level == 0)
                        std::swap(corners[1], corners[3]);
                    for (const auto &[a, b] : corners) {
                        std::array<int, 3> p{};
                        p[axis] = level;
                        p[(axis + 1) % 3] = a;
                        p[(axis + 2) % 3] = b;
                        faces.push_back(vertex(p));
                    }
                }
    return mesh::QuadMesh::build(3, points, faces);
}

// The faces of a mesh without some, in three dimensions; the vertices stay.
inline mesh::QuadMesh without(const mesh::QuadMesh &mesh, const std::set<int> &left_out) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const double x : mesh.point(v))
            points.push_back(x);
    for (int f = 0; f < mesh.n_faces(); ++f)
        if (!left_out.contains(f))
            for (const int v : mesh.corners(f))
                faces.push_back(v);
    return mesh::QuadMesh::build(3, points, faces);
}

// With so many edges turned at random.
inline mesh::QuadMesh scrambled(mesh::QuadMesh mesh, int turns, unsigned seed) {
    std::mt19937 random(seed);
    adapt::samples::turn_edges(mesh, adapt::samples::all_faces(mesh), turns, random);
    mesh.reset_origins();
    return mesh;
}

inline std::vector<std::pair<std::string, mesh::QuadMesh>> kinds() {
    std::vector<std::pair<std::string, mesh::QuadMesh>> result;
    const auto add = [&](const char *name, const mesh::QuadMesh &mesh) { result.emplace_back(name, mesh); };
    add("face", grid(1, 1, 3));
    add("row", grid(5, 1, 3));
    add("grid", grid(7, 5, 3));
    add("torus", mesh::torus(7, 5).build(3));
    add("thin torus", mesh::torus(3, 3).build(3));
    add("cube", sphere(1));
    add("sphere", sphere(6));
    for (const int n : {3, 5, 6})
        add("star", without(star(n, 4), {}));
    std::set<int> hole;
    for (const int f : adapt::samples::block(9, 3, 3, 6, 5))
        hole.insert(f);
    add("plate with a hole", without(grid(9, 8), hole));
    hole.insert({0, 1, 9, 10, 70});
    add("plate with two holes and a notch", without(grid(9, 8), hole));
    add("plate with two holes corner to corner", without(grid(9, 8), {20, 31}));
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        add("random filling", scrambled(grid(10, 10, 3), 40, seed));
        add("random sphere", scrambled(sphere(5), 50, seed));
        add("random torus", scrambled(mesh::torus(9, 8).build(3), 25, seed));
    }
    return result;
}

} // namespace alphamst::chord::samples
