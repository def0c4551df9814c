#include "patch/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "meshes.h"

namespace alphamst::patch {
namespace {

using testing::at;
using testing::block;
using testing::covered;
using testing::ell;
using testing::graded;
using testing::grid;
using testing::Groups;
using testing::islands;
using testing::mark;
using testing::none;
using testing::Point;

Point middle(const mesh::QuadMesh &mesh, int face) {
    Point sum(0, 0, 0);
    for (const int v : mesh.corners(face))
        sum += mesh.point(v);
    return sum / 4.0;
}

// Largest distance of a corner of the faces.
double reach(const mesh::QuadMesh &mesh, const std::vector<int> &faces, const Point &p) {
    double most = 0;
    for (const int face : faces)
        for (const int v : mesh.corners(face))
            most = std::max(most, (mesh.point(v) - p).norm());
    return most;
}

double distance(const mesh::QuadMesh &mesh, int edge, const Point &p) {
    const auto [v, w] = mesh.edge_vertices(edge);
    const Point along = mesh.point(w) - mesh.point(v), away = p - mesh.point(v);
    return (away - along * std::clamp((away | along) / along.sqrnorm(), 0.0, 1.0)).norm();
}

// Whether the circle around some face of the disc that holds the disc has nothing inside that
// bounds it: no edge of the mesh boundary and no face of an earlier disc.
bool in_its_circle(const mesh::QuadMesh &mesh, const std::vector<int> &disc, const std::vector<char> &taken) {
    return std::any_of(disc.begin(), disc.end(), [&](int face) {
        const Point p = middle(mesh, face);
        double radius = std::numeric_limits<double>::infinity();
        for (int edge = 0; edge < mesh.n_edges(); ++edge) {
            const auto [a, b] = mesh.edge_faces(edge);
            if (a < 0 || b < 0 || taken[at(a)] || taken[at(b)])
                radius = std::min(radius, distance(mesh, edge, p));
        }
        return reach(mesh, disc, p) <= radius + 1e-12;
    });
}

void expect_discs(const mesh::QuadMesh &mesh, std::size_t size, std::size_t least_covered) {
    const Groups discs = medial_discs(mesh, static_cast<double>(size), 1, none);
    EXPECT_GE(covered(discs), least_covered);
    std::vector<char> taken = mark(mesh, {});
    for (const auto &disc : discs) {
        EXPECT_TRUE(in_its_circle(mesh, disc, taken)) << "about face " << disc.front() << ", size " << size;
        EXPECT_GE(disc.size() + 1, size / 4);
        EXPECT_LE(disc.size(), size);
        for (const int face : disc)
            taken[at(face)] = 1;
    }
}

TEST(Medial, DiscsLieInTheirCircles) {
    for (const mesh::QuadMesh &mesh : {grid(30, 30), ell(), islands(), graded()})
        expect_discs(mesh, 60, at(mesh.n_faces() / 4));
}

// Where the nearest bound is at a face outside the disc, or at one that has a nearer bound itself.
TEST(Medial, SmallDiscsInNarrowPlacesLieInTheirCirclesToo) {
    for (const std::size_t size : {6U, 9U, 16U})
        expect_discs(islands(), size, 1000);
}

TEST(Medial, TheFirstDiscFillsTheLargestCircle) {
    const mesh::QuadMesh mesh = grid(21, 31);
    std::vector<int> wanted; // about the first of the middle faces, (10, 10)
    for (int face = 0; face < mesh.n_faces(); ++face)
        if (reach(mesh, {face}, {10.5, 10.5, 0}) <= 10.5)
            wanted.push_back(face);
    EXPECT_EQ(medial_discs(mesh, 1000, 1, none).front(), wanted);
}

TEST(Medial, LargeCirclesAreCutDownAroundTheirCentre) {
    const mesh::QuadMesh mesh = grid(41, 41);
    const auto disc = medial_discs(mesh, 100, 1, none).front();
    EXPECT_EQ(disc.size(), 100U);
    EXPECT_LT(reach(mesh, disc, {20.5, 20.5, 0}), 6.6); // 100 faces have the radius 5.6
}

TEST(Medial, NoneWhereCirclesAreSmall) {
    EXPECT_TRUE(medial_discs(grid(60, 7), 100, 1, none).empty());
    EXPECT_FALSE(medial_discs(grid(60, 7), 16, 1, none).empty());
}

TEST(Medial, FlagsMarkersAndTakenFacesBound) {
    mesh::QuadMesh mesh = grid(21, 21);
    mesh.vertex_flags[10 * 22 + 10] = mesh::corner;
    std::vector<char> taken = mark(mesh, block(21, 0, 0, 21, 3));
    mesh.face_marker.assign(441, 0);
    for (const int face : block(21, 15, 0, 21, 21))
        mesh.face_marker[at(face)] = 4;
    for (const auto &disc : medial_discs(mesh, 500, 1, taken))
        for (const int face : disc) {
            EXPECT_EQ(face % 21 < 15, disc.front() % 21 < 15);
            EXPECT_GE(face / 21, 3);
            const auto corners = mesh.corners(face);
            EXPECT_EQ(std::count(corners.begin(), corners.end(), 10 * 22 + 10), 0);
        }
}

TEST(Medial, AClosedSurfaceIsPackedFromARandomFaceOn) {
    const mesh::QuadMesh mesh = testing::cube(12);
    const Groups discs = medial_discs(mesh, 40, 1, none);
    EXPECT_GE(covered(discs), 400U);
    EXPECT_EQ(discs.front().size(), 40U);
    EXPECT_NE(discs, medial_discs(mesh, 40, 2, none));
}

} // namespace
} // namespace alphamst::patch
