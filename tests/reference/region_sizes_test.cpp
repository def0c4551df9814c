#include "reference/region_sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adapt/meshes.h"
#include "mesh/curved.h"

namespace alphamst::reference {
namespace {

// n x n unit squares; their loop first, as a filling numbers its vertices. height: of all points.
struct Sheet {
    fill::Filling filling;
    std::vector<Eigen::Vector3d> points;
    std::vector<geometry::Quad> quads;

    explicit Sheet(int n, double height = 0) {
        std::vector<int> number(static_cast<std::size_t>((n + 1) * (n + 1)), -1);
        const auto add = [&](int i, int j) {
            number[static_cast<std::size_t>(j * (n + 1) + i)] = static_cast<int>(points.size());
            points.emplace_back(i, j, height);
        };
        for (int k = 0; k < n; ++k)
            add(k, 0);
        for (int k = 0; k < n; ++k)
            add(n, k);
        for (int k = n; k > 0; --k)
            add(k, n);
        for (int k = n; k > 0; --k)
            add(0, k);
        filling.boundary = static_cast<int>(points.size());
        for (int j = 1; j < n; ++j)
            for (int i = 1; i < n; ++i)
                add(i, j);
        filling.vertices = static_cast<int>(points.size());
        const auto at = [&](int i, int j) { return number[static_cast<std::size_t>(j * (n + 1) + i)]; };
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                filling.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                quads.push_back({});
                for (std::size_t k = 0; k < 4; ++k)
                    quads.back()[k] = points[static_cast<std::size_t>(filling.quads.back()[k])];
            }
    }
    RegionSizes sizes(double alpha, double transition = 0.5) const {
        return {filling, points, alpha * static_cast<double>(filling.quads.size()), transition};
    }
};

TEST(RegionSizes, AreThoseThatAreThereWhereTheCountStays) {
    const Sheet sheet(12);
    const RegionSizes sizes = sheet.sizes(1);
    for (const geometry::Quad &q : sheet.quads)
        EXPECT_NEAR(sizes.at((q[0] + q[2]) / 2), 1, 1e-6);
    EXPECT_NEAR(sizes.error(sheet.quads).rms, 0, 1e-6);
}

TEST(RegionSizes, ChangeFromTheBorderInwardsAndComeToTheCount) {
    const Sheet sheet(20);
    for (const double alpha : {0.5, 2.0, 4.0}) {
        const RegionSizes sizes = sheet.sizes(alpha);
        double faces = 0;
        for (const geometry::Quad &q : sheet.quads)
            faces += 1 / sizes.at((q[0] + q[2]) / 2);
        EXPECT_NEAR(faces, 400 * alpha, 8 * alpha);
        EXPECT_NEAR(sizes.at({0, 7, 0}), 1, 0.01); // edges there stay
        const double core = sizes.at({10, 10, 0});
        EXPECT_NEAR(std::log(sizes.at({10, 7, 0}) / core), 0,
                    0.01); // farther than half the depth from the border
        EXPECT_TRUE(alpha > 1 ? core < 1 / alpha : core > 1 / alpha);
    }
}

TEST(RegionSizes, AreTheSameInSpaceWithoutALattice) {
    const Sheet flat(10), high(10, 3);
    const RegionSizes a = flat.sizes(3), b = high.sizes(3);
    for (const geometry::Quad &q : flat.quads) {
        const Eigen::Vector3d x = (q[0] + q[1] + q[2] + q[3]) / 4;
        EXPECT_NEAR(std::log(a.at(x) / b.at(x + Eigen::Vector3d(0, 0, 3))), 0, 0.15);
    }
}

TEST(RegionSizes, OfALineAreNumbersToo) {
    Sheet sheet(4);
    for (Eigen::Vector3d &p : sheet.points)
        p.y() = 0;
    EXPECT_TRUE(std::isfinite(sheet.sizes(2).at({2, 0, 0})));
}

TEST(RegionSizes, MayBeGiven) {
    const Sheet sheet(20);
    std::vector<double> areas; // from 1/4 on the left to 4 on the right
    for (const geometry::Quad &q : sheet.quads)
        areas.push_back(std::exp2((q[0].x() + 0.5 - 10) / 5));
    double faces = 0;
    for (const double area : areas)
        faces += 1 / area;
    const RegionSizes sizes(sheet.filling, sheet.points, faces, 0.5, areas);
    EXPECT_NEAR(std::log2(sizes.at({5, 10, 0})), -1, 0.1);
    EXPECT_NEAR(std::log2(sizes.at({15, 10, 0})), 1, 0.1);
}

// A short transition leaves more room for a core, whose faces need not be so small.
TEST(RegionSizes, ChangeOverTheTransition) {
    const Sheet sheet(20);
    const RegionSizes slow = sheet.sizes(4, 1), fast = sheet.sizes(4, 0.1);
    EXPECT_LT(slow.at({10, 10, 0}), 0.5 * fast.at({10, 10, 0}));
    EXPECT_GT(slow.at({2.5, 10, 0}), 1.5 * fast.at({2.5, 10, 0}));
    EXPECT_NEAR(fast.at({5, 10, 0}) / fast.at({10, 10, 0}), 1, 0.01);
}

TEST(RegionSizes, ErrorIsInPowersOfTwo) {
    const Sheet sheet(8);
    const RegionSizes sizes = sheet.sizes(1);
    geometry::Quad half = sheet.quads[27], twice = half;
    half[2].y() = half[3].y() = half[0].y() + 0.5;
    twice[2].y() = twice[3].y() = twice[0].y() + 2;
    const std::vector<geometry::Quad> quads{half, twice, sheet.quads[0], sheet.quads[1]};
    const SizeError error = sizes.error(quads);
    EXPECT_NEAR(error.rms, std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(error.least, -1, 1e-6);
    EXPECT_NEAR(error.shortest_edge, 0.5, 1e-6);
}

TEST(RegionSizes, OfARegionWithAHoleKeepBothBorders) {
    const mesh::QuadMesh mesh = adapt::samples::grid(20, 20);
    std::vector<int> ring;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const OpenMesh::Vec3d c = adapt::samples::centre(mesh, f);
        if (std::max(std::abs(c[0] - 10), std::abs(c[1] - 10)) > 3)
            ring.push_back(f);
    }
    const RegionSizes sizes(mesh, ring, 4.0 * static_cast<double>(ring.size()), 0.5);
    // Between points of the lattice they are a little off.
    EXPECT_NEAR(sizes.at({0, 10, 0}), 1, 0.3);
    EXPECT_NEAR(sizes.at({7, 10, 0}), 1, 0.3);
    EXPECT_LT(sizes.at({3.5, 10, 0}), 0.25);
    double faces = 0;
    for (const int f : ring) {
        const OpenMesh::Vec3d c = adapt::samples::centre(mesh, f);
        faces += 1 / sizes.at({c[0], c[1], c[2]});
    }
    EXPECT_NEAR(faces, 4.0 * static_cast<double>(ring.size()), 0.05 * faces);
}

TEST(RegionSizes, OfAClosedMeshAreTheSameFactorEverywhere) {
    const mesh::QuadMesh mesh = mesh::sphere(3);
    const RegionSizes once(mesh, adapt::samples::all_faces(mesh), mesh.n_faces(), 0.5);
    const RegionSizes twice(mesh, adapt::samples::all_faces(mesh), 2.0 * mesh.n_faces(), 0.5);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const OpenMesh::Vec3d c = adapt::samples::centre(mesh, f);
        EXPECT_NEAR(once.at({c[0], c[1], c[2]}) / twice.at({c[0], c[1], c[2]}), 2, 1e-6);
    }
}

} // namespace
} // namespace alphamst::reference
