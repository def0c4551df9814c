#include "patch/patches.h"

#include "grid.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>
#include <string>

namespace alphamst::patch {
namespace {

using testing::block;
using testing::grid;
using testing::part;
using testing::without;
using Groups = std::vector<std::vector<int>>;
using Point = OpenMesh::Vec3d;

const Taken none;

std::size_t at(int id) { return static_cast<std::size_t>(id); }

std::vector<char> mark(const mesh::QuadMesh &mesh, const std::vector<int> &faces) {
    std::vector<char> taken(at(mesh.n_faces()), 0);
    for (const int face : faces)
        taken[at(face)] = 1;
    return taken;
}

void set_feature(mesh::QuadMesh &mesh, int v, int w) {
    mesh.edge_flags[at(mesh.find_edge(v, w))] = mesh::feature;
}

mesh::QuadMesh ell() {
    return part(grid(40, 40), without(block(40, 0, 0, 40, 40), block(40, 15, 15, 40, 40)));
}

// Two holes in a mesh with singular vertices everywhere.
mesh::QuadMesh islands() {
    const mesh::QuadMesh whole = testing::triangles(6, 5);
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
mesh::QuadMesh graded() {
    mesh::QuadMesh mesh = grid(40, 40);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        mesh.set_point(v, {std::pow(100, mesh.point(v)[0] / 40), mesh.point(v)[1], 0});
    return mesh;
}

using Decompose = Groups (*)(const mesh::QuadMesh &, double, std::uint64_t, Taken);
struct Method {
    std::string name;
    Decompose decompose;
};
const Method methods[] = {{"clusters", &clusters},
                          {"partition", &partition},
                          {"voronoi", &voronoi_cells},
                          {"medial", &medial_discs},
                          {"singularities", &singularity_clusters}};
std::string name_of(const ::testing::TestParamInfo<Method> &info) { return info.param.name; }

std::size_t covered(const Groups &patches) {
    std::size_t total = 0;
    for (const auto &patch : patches)
        total += patch.size();
    return total;
}

// Usable, ascending and disjoint.
void expect_disks(const mesh::QuadMesh &mesh, const Groups &patches) {
    std::set<int> seen;
    for (const auto &patch : patches) {
        EXPECT_EQ(defects(mesh, patch), 0);
        EXPECT_TRUE(std::is_sorted(patch.begin(), patch.end()));
        seen.insert(patch.begin(), patch.end());
    }
    EXPECT_EQ(seen.size(), covered(patches));
}

class Decomposition : public ::testing::TestWithParam<Method> {
protected:
    Groups run(const mesh::QuadMesh &mesh, double size, std::uint64_t seed = 1, Taken taken = none) const {
        return GetParam().decompose(mesh, size, seed, taken);
    }
};
class Cover : public Decomposition {};

TEST_P(Decomposition, DisjointDisksOnEveryMesh) {
    for (const mesh::QuadMesh &mesh : {grid(30, 30), ell(), islands(), graded(), testing::cube(12)})
        for (const double size : {1.0, 7.0, 60.0, 5000.0}) {
            const Groups patches = run(mesh, size);
            expect_disks(mesh, patches);
            EXPECT_EQ(patches, run(mesh, size));
        }
}

TEST_P(Decomposition, RespectsTakenAndFeatures) {
    mesh::QuadMesh mesh = testing::triangles(4, 5);
    // The middle line x = 2, but for the last edges: the feature ends inside.
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (const int w : mesh.vertices_around(v))
            if (std::abs(mesh.point(v)[0] - 2) < 1e-9 && std::abs(mesh.point(w)[0] - 2) < 1e-9 &&
                mesh.point(v)[1] < mesh.point(w)[1] && mesh.point(w)[1] < 3.7)
                set_feature(mesh, v, w);
    mesh.face_marker.assign(at(mesh.n_faces()), 1);
    for (int face = 0; face < 300; ++face)
        mesh.face_marker[at(face)] = 2;
    std::vector<int> corner(150);
    std::iota(corner.begin(), corner.end(), 900);
    const std::vector<char> taken = mark(mesh, corner);
    for (const double size : {1.0, 2.5, 12.0, 50.0, 1000.0}) {
        const Groups patches = run(mesh, size, 1, taken);
        EXPECT_FALSE(patches.empty());
        expect_disks(mesh, patches);
        for (const auto &patch : patches)
            for (const int face : patch)
                EXPECT_FALSE(taken[at(face)]);
    }
}

TEST_P(Decomposition, SilentOnSmallParts) {
    ::testing::internal::CaptureStdout();
    const mesh::QuadMesh mesh = testing::triangles(3, 4);
    for (const double size : {0.0, 1.0, 3.0, 8.0, 9.0})
        EXPECT_FALSE(run(mesh, size).empty());
    EXPECT_TRUE(run(mesh, 10, 1, std::vector<char>(at(mesh.n_faces()), 1)).empty());
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST_P(Cover, DisksOfAboutTheSize) {
    const mesh::QuadMesh mesh = grid(40, 40);
    const Groups patches = run(mesh, 64, 3);
    EXPECT_GE(patches.size(), 20U);
    EXPECT_LE(patches.size(), 30U);
    for (const auto &patch : patches) {
        EXPECT_GE(patch.size(), 16U);
        EXPECT_LE(patch.size(), 192U);
        EXPECT_GT(convexity(mesh, make_window(mesh, patch)), 0.6);
    }
    EXPECT_GE(covered(patches), 1500U);
}

TEST_P(Cover, LeavesLittle) {
    for (const mesh::QuadMesh &mesh : {ell(), islands(), graded(), testing::cube(12)})
        EXPECT_GE(covered(run(mesh, 60)), at(mesh.n_faces() * 97 / 100));
}

INSTANTIATE_TEST_SUITE_P(All, Decomposition, ::testing::ValuesIn(methods), name_of);
INSTANTIATE_TEST_SUITE_P(All, Cover, ::testing::ValuesIn(methods, methods + 3), name_of);

// ---------------------------------------------------------------- Voronoi cells

TEST(Voronoi, AsManyFacesWhereTheMeshIsFineAsWhereItIsCoarse) {
    const mesh::QuadMesh mesh = graded();
    const Groups cells = voronoi_cells(mesh, 64, 5, none);
    EXPECT_EQ(cells.size(), 25U);
    for (const auto &cell : cells) {
        EXPECT_GE(cell.size(), 13U);
        EXPECT_LE(cell.size(), 192U);
    }
}

TEST(Voronoi, TheSeedMovesTheCells) {
    const mesh::QuadMesh mesh = grid(30, 30);
    EXPECT_NE(voronoi_cells(mesh, 60, 1, none), voronoi_cells(mesh, 60, 2, none));
}

// Two centres in a strip: the second is at the end that is farther from the first, and the
// border in the middle between them.
TEST(Voronoi, FarthestPointsAndTheirBisector) {
    const mesh::QuadMesh mesh = grid(30, 1);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Groups cells = voronoi_cells(mesh, 15, seed, none);
        ASSERT_EQ(cells.size(), 2U);
        const int first = static_cast<int>(std::mt19937_64(seed)() % 30), second = first < 15 ? 29 : 0;
        const int border = std::abs(first - second) % 2 ? (first + second - 1) / 2 : -1;
        if (border < 0) // a face in the middle, as near to one as to the other
            continue;
        const auto &low = cells[0].front() == 0 ? cells[0] : cells[1];
        EXPECT_EQ(low, block(30, 0, 0, border + 1, 1)) << "seed " << seed;
    }
}

// ----------------------------------------------------------------- medial discs

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

// --------------------------------------------------------- clusters of singularities

bool in_some(const mesh::QuadMesh &mesh, const Groups &patches, int vertex) {
    const std::vector<int> faces = mesh.faces_around(vertex);
    return std::any_of(patches.begin(), patches.end(), [&](const auto &patch) {
        return std::any_of(faces.begin(), faces.end(),
                           [&](int face) { return std::binary_search(patch.begin(), patch.end(), face); });
    });
}

TEST(Singularities, EachIsInAPatch) {
    for (const mesh::QuadMesh &mesh :
         {islands(), testing::triangles(8, 1), testing::triangles(6, 3), testing::cube(12)}) {
        ASSERT_FALSE(mesh.singularities().empty());
        for (const double size : {4.0, 20.0, 100.0, 700.0}) {
            const Groups patches = singularity_clusters(mesh, size, 1, none);
            for (const int v : mesh.singularities())
                EXPECT_TRUE(in_some(mesh, patches, v)) << "vertex " << v << ", size " << size;
        }
    }
}

// Features that end inside cut clusters open; what falls off has singular vertices, too.
TEST(Singularities, EachIsInAPatchAmongFeatures) {
    for (const int percent : {4, 15})
        for (const double size : {40.0, 60.0, 200.0}) {
            mesh::QuadMesh mesh = testing::triangles(3, 3);
            std::mt19937 random(7);
            for (auto &flags : mesh.edge_flags)
                flags = static_cast<int>(random() % 100) < percent ? mesh::feature : 0;
            const Groups patches = singularity_clusters(mesh, size, 1, none);
            expect_disks(mesh, patches);
            for (const int v : mesh.singularities()) {
                const std::vector<int> around = mesh.vertices_around(v);
                const bool on_feature = std::any_of(around.begin(), around.end(), [&](int w) {
                    return mesh.edge_flags[at(mesh.find_edge(v, w))] != 0;
                });
                EXPECT_TRUE(on_feature || in_some(mesh, patches, v)) << "vertex " << v << ", size " << size;
            }
        }
}

TEST(Singularities, ARegularMeshHasNone) {
    EXPECT_TRUE(singularity_clusters(grid(20, 20), 50, 1, none).empty());
    EXPECT_TRUE(singularity_clusters(testing::star(4, 6), 50, 1, none).empty());
}

TEST(Singularities, TheFacesAroundOneInWholeLayers) {
    const mesh::QuadMesh mesh = testing::star(5, 8);
    for (const auto &[size, layers] : {std::pair(5.0, 1), {20.0, 2}, {50.0, 3}, {80.0, 4}})
        EXPECT_EQ(singularity_clusters(mesh, size, 1, none), Groups{rings(mesh, 0, layers, none)});
}

// The corners of a cube: alone, or with others if there is room.
TEST(Singularities, NearOnesShareAPatch) {
    const mesh::QuadMesh mesh = testing::cube(4);
    EXPECT_EQ(singularity_clusters(mesh, 12, 1, none).size(), 8U);
    const Groups shared = singularity_clusters(mesh, 24, 1, none);
    EXPECT_LE(shared.size(), 4U);
    EXPECT_EQ(singularity_clusters(testing::cube(12), 24, 1, none).size(), 8U);
}

TEST(Singularities, RoughlyTheSize) {
    const mesh::QuadMesh mesh = islands();
    for (const double size : {20.0, 60.0}) {
        const Groups patches = singularity_clusters(mesh, size, 1, none);
        for (const auto &patch : patches)
            EXPECT_LE(static_cast<double>(patch.size()), 2 * size);
        EXPECT_GE(static_cast<double>(covered(patches)) / static_cast<double>(patches.size()), size / 2);
    }
}

TEST(Singularities, NoFreeFaceHasTwoSidesOnAPatch) {
    const mesh::QuadMesh mesh = testing::triangles(4, 3);
    const Groups patches = singularity_clusters(mesh, 60, 1, none);
    std::vector<int> patch_of(at(mesh.n_faces()), -1);
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (const int face : patches[p])
            patch_of[at(face)] = static_cast<int>(p);
    ASSERT_LT(covered(patches), at(mesh.n_faces()));
    for (int face = 0; face < mesh.n_faces(); ++face) {
        std::multiset<int> across;
        for (const int next : mesh.neighbours(face))
            if (patch_of[at(face)] < 0 && next >= 0 && patch_of[at(next)] >= 0)
                across.insert(patch_of[at(next)]);
        for (const int patch : across)
            EXPECT_EQ(across.count(patch), 1U) << "face " << face;
    }
}

TEST(Singularities, NoPatchForOneThatCannotBeInside) {
    mesh::QuadMesh mesh = testing::star(5, 8);
    mesh.vertex_flags[0] = mesh::fixed;
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, none).empty());
    mesh.vertex_flags[0] = 0;
    EXPECT_FALSE(singularity_clusters(mesh, 50, 1, none).empty());
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, mark(mesh, {0})).empty());
    set_feature(mesh, 0, 1);
    EXPECT_TRUE(singularity_clusters(mesh, 50, 1, none).empty());
}

} // namespace
} // namespace alphamst::patch
