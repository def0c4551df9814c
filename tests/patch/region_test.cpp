#include "patch/region.h"

#include <gtest/gtest.h>

#include <functional>

#include "grid.h"

namespace alphamst::patch {
namespace {

using testing::grid;

constexpr int n = 6, row = n + 1, middle = 3 * row + 3;

std::uint8_t &edge_flags(mesh::QuadMesh &mesh, int v, int w) {
    return mesh.edge_flags[static_cast<std::size_t>(mesh.find_edge(v, w))];
}

std::int32_t &marker(mesh::QuadMesh &mesh, int v, int w) {
    mesh.edge_marker.resize(static_cast<std::size_t>(mesh.n_edges()));
    return mesh.edge_marker[static_cast<std::size_t>(mesh.find_edge(v, w))];
}

std::uint8_t &flags(mesh::QuadMesh &mesh, int v) { return mesh.vertex_flags[static_cast<std::size_t>(v)]; }

// A grid with a feature along row 3, from boundary to boundary.
mesh::QuadMesh with_feature() {
    mesh::QuadMesh mesh = grid(n, n);
    for (int i = 0; i < n; ++i)
        edge_flags(mesh, 3 * row + i, 3 * row + i + 1) = mesh::feature;
    return mesh;
}

std::array<int, 2> neighbours(const mesh::QuadMesh &mesh, int v) {
    auto found = slide(mesh, v).value_or(std::array{-1, -1});
    std::sort(found.begin(), found.end());
    return found;
}

const std::array<int, 2> none{-1, -1}, beside{middle - 1, middle + 1};

TEST(Slide, AlongAFeatureInside) {
    mesh::QuadMesh mesh = with_feature();
    EXPECT_EQ(neighbours(mesh, middle), beside);
    EXPECT_TRUE(constrained(mesh, middle)); // to all who do not know of sliding
    EXPECT_EQ(neighbours(mesh, 3 * row), none);
    EXPECT_EQ(neighbours(mesh, 2 * row + 3), none);
    flags(mesh, middle) = mesh::feature;
    EXPECT_EQ(neighbours(mesh, middle), beside);
    flags(mesh, 2 * row + 3) = mesh::feature; // without an edge
    EXPECT_EQ(neighbours(mesh, 2 * row + 3), none);
}

TEST(Slide, AlongNumberedEdgesAndBordersOfRegions) {
    mesh::QuadMesh mesh = grid(n, n);
    marker(mesh, middle - 1, middle) = 4;
    marker(mesh, middle, middle + 1) = 4;
    EXPECT_EQ(neighbours(mesh, middle), beside);
    marker(mesh, middle, middle + 1) = 5;
    EXPECT_EQ(neighbours(mesh, middle), none);
    mesh.edge_marker.clear();
    mesh.face_marker.assign(n * n, 1);
    for (int f = 3 * n; f < n * n; ++f)
        mesh.face_marker[static_cast<std::size_t>(f)] = 2;
    EXPECT_EQ(neighbours(mesh, middle), beside);
    edge_flags(mesh, middle, middle + 1) = mesh::feature; // the other edge is a border only
    EXPECT_EQ(neighbours(mesh, middle), none);
}

TEST(Slide, NotWhereSomethingElseHoldsTheVertex) {
    using Change = std::function<void(mesh::QuadMesh &)>;
    const Change changes[] = {
        [](mesh::QuadMesh &mesh) { flags(mesh, middle) = mesh::fixed; },
        [](mesh::QuadMesh &mesh) { flags(mesh, middle) = mesh::corner | mesh::feature; },
        [](mesh::QuadMesh &mesh) { edge_flags(mesh, middle, middle + 1) |= mesh::fixed; },
        [](mesh::QuadMesh &mesh) {
            edge_flags(mesh, middle - 1, middle) = edge_flags(mesh, middle, middle + 1) = mesh::fixed;
        },
        [](mesh::QuadMesh &mesh) {
            edge_flags(mesh, middle - 1, middle) = edge_flags(mesh, middle, middle + 1) = mesh::corner;
        },
        [](mesh::QuadMesh &mesh) { edge_flags(mesh, middle, middle + 1) = 0; },
        [](mesh::QuadMesh &mesh) { edge_flags(mesh, middle, middle + row) = mesh::feature; },
        [](mesh::QuadMesh &mesh) { marker(mesh, middle, middle + row) = 1; },
        [](mesh::QuadMesh &mesh) { mesh.face_flags[2 * n + 2] = mesh::fixed; },
        [](mesh::QuadMesh &mesh) {
            mesh.face_marker.assign(n * n, 0);
            mesh.face_marker[2 * n + 2] = 1;
        },
    };
    for (const Change &change : changes) {
        mesh::QuadMesh mesh = with_feature();
        change(mesh);
        EXPECT_EQ(neighbours(mesh, middle), none) << &change - changes;
        EXPECT_EQ(neighbours(mesh, 3 * row + 1), (std::array{3 * row, 3 * row + 2})); // far from that
    }
}

} // namespace
} // namespace alphamst::patch
