// Small meshes for the tests of this folder.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/quad_mesh.h"

namespace alphamst::mesh {

struct Grid {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    QuadMesh build(int dim = 2) const { return QuadMesh::build(dim, points, faces); }
};

// nx * ny unit squares; vertex (i, j) is j * (nx + 1) + i, face (i, j) is j * nx + i.
inline Grid plane(int nx, int ny) {
    Grid grid;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            grid.points.insert(grid.points.end(), {double(i), double(j), 0.0});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int v = j * (nx + 1) + i;
            grid.faces.insert(grid.faces.end(), {v, v + 1, v + nx + 2, v + nx + 1});
        }
    return grid;
}

inline Grid torus(int n, int m) {
    Grid grid;
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / m;
            grid.points.insert(grid.points.end(), {(3 + std::cos(b)) * std::cos(a),
                                                   (3 + std::cos(b)) * std::sin(a), std::sin(b)});
        }
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int k, int l) { return l % m * n + k % n; };
            grid.faces.insert(grid.faces.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return grid;
}

// A ring of n squares, its last one joined to the first with a twist.
inline Grid moebius(int n) {
    Grid strip;
    for (int i = 0; i < n; ++i) {
        const double a = 6.283185307179586 * i / n;
        for (const double s : {-.3, .3})
            strip.points.insert(strip.points.end(),
                                {std::cos(a) * (1 + s * std::cos(a / 2)),
                                 std::sin(a) * (1 + s * std::cos(a / 2)), s * std::sin(a / 2)});
    }
    for (int i = 0; i + 1 < n; ++i)
        strip.faces.insert(strip.faces.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    strip.faces.insert(strip.faces.end(), {2 * n - 2, 1, 0, 2 * n - 1});
    return strip;
}

// Three unit squares around the vertex 4 at (1, 1), which is a concave corner; face 0 is
// between the other two and has no edge on the boundary there.
inline Grid ell() {
    return {{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 0, 2, 0, 1, 2, 0},
            {0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 7, 6}};
}

// What a call throws; Fault::cancelled, which the mesh never throws, if it does not.
template <class Call> Failure failure_of(Call call) {
    try {
        call();
    } catch (const Failure &failure) {
        return failure;
    }
    return {Fault::cancelled, "nothing was thrown"};
}

} // namespace alphamst::mesh
