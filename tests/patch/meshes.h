// Meshes to decompose, and what every decomposition of them has to be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "grid.h"
#include "patch/patches.h"

namespace alphamst::patch::testing {

using Groups = std::vector<std::vector<int>>;
using Point = OpenMesh::Vec3d;

inline const Taken none;

inline std::size_t at(int id) { return static_cast<std::size_t>(id); }

inline std::vector<char> mark(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::vector<char> taken(at(mesh.n_faces()), 0);
    for (const int face : faces)
        taken[at(face)] = 1;
    return taken;
}

inline void set_feature(mesh::QuadMesh &mesh, int v, int w) {
    mesh.edge_flags[at(mesh.find_edge(v, w))] = mesh::feature;
}

inline mesh::QuadMesh ell() {
    return part(grid(40, 40), without(block(40, 0, 0, 40, 40), block(40, 15, 15, 40, 40)));
}

// Two holes in a mesh with singular vertices everywhere.
inline mesh::QuadMesh islands() {
    const mesh::QuadMesh whole = triangles(6, 5);
    std::vector<int> kept;
    for (int face = 0; face < whole.n_faces(); ++face) {
        Point p(0, 0, 0);
        for (const int v : whole.corners(face))
            p += whole.point(v) / 4.0;
        if ((p - Point(1.6, 1.7, 0)).norm() > 0.7 && (p - Point(4.3, 3.9, 0)).norm() > 1)
            kept.push_back(face);
    }
    return part(whole, kept);
}

// A grid whose faces are a hundred times as wide on the right as on the left.
inline mesh::QuadMesh graded() {
    mesh::QuadMesh mesh = grid(40, 40);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        mesh.set_point(v, {std::pow(100, mesh.point(v)[0] / 40), mesh.point(v)[1], 0});
    return mesh;
}

inline std::size_t covered(const Groups &patches) {
    std::size_t total = 0;
    for (const auto &patch : patches)
        total += patch.size();
    return total;
}

// Usable, ascending and disjoint.
inline void expect_disks(const mesh::QuadMesh &mesh, const Groups &patches) {
    std::set<int> seen;
    for (const auto &patch : patches) {
        EXPECT_EQ(defects(mesh, patch), 0);
        EXPECT_TRUE(std::is_sorted(patch.begin(), patch.end()));
        seen.insert(patch.begin(), patch.end());
    }
    EXPECT_EQ(seen.size(), covered(patches));
}

} // namespace alphamst::patch::testing
