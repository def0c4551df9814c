#include "reference/feature_line.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <numeric>

#include "adapt/run.h"
#include "mesh/curved.h"
#include "mesh/feature.h"
#include "patch/region.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/surface_of.h"
#include "smooth/relax.h"

namespace alphamst::reference {
namespace {

using namespace adapt::samples;

using Eigen::Vector3d;

constexpr int n = 8; // faces along an edge of the box

std::size_t at(int i) { return static_cast<std::size_t>(i); }

void flag_features(mesh::QuadMesh &mesh) {
    const mesh::Features features = mesh::find_features(mesh, 40);
    for (const int e : features.edges)
        mesh.edge_flags[at(e)] |= mesh::feature;
    for (const int v : features.corners)
        mesh.vertex_flags[at(v)] |= mesh::corner;
}

// A box of edges 1, 2 and 3 that is turned. Vertices are bunched at one corner, by powers of even places: on
// its edges and inside of its sides, where they are moved at random, too.
struct Box {
    Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    std::vector<Vector3d> parameters; // [vertex] 0..n
    mesh::QuadMesh mesh;

    explicit Box(double on_edges = 2, double inside = 2, double noise = 0.4, unsigned seed = 5)
        : mesh(make(on_edges, inside, noise, seed)) {
        flag_features(mesh);
    }

    int sides(int v) const { // of the box that the vertex is on
        int count = 0;
        for (const double x : parameters[at(v)])
            count += x == 0 || x == n;
        return count;
    }
    // The axis of the edge of the box that the vertex is on.
    int axis(int v) const {
        int axis = 0;
        while (parameters[at(v)][axis] == 0 || parameters[at(v)][axis] == n)
            ++axis;
        return axis;
    }
    // In the box as it was before it was turned.
    Vector3d place(int v) const { return turn.transpose() * point_of(mesh, v); }

private:
    mesh::QuadMesh make(double on_edges, double inside, double noise, unsigned seed) {
        std::mt19937 random(seed);
        return mesh::cube(n, [&](const Vector3d &given) {
            parameters.push_back(given);
            Vector3d p;
            int on = 0;
            for (const double x : given)
                on += x == 0 || x == n;
            for (int k = 0; k < 3; ++k) {
                const bool free = given[k] > 0 && given[k] < n;
                const double x = given[k] + (free && on == 1 ? noise * (2 * chance(random) - 1) : 0);
                p[k] = (k + 1) * std::pow(x / n, on == 1 ? inside : on_edges);
            }
            return Vector3d(turn * p);
        });
    }
};

// Of each edge of the mesh on an edge of the box: its length over the one that all would have.
std::vector<double> lengths(const Box &box) {
    std::vector<double> result;
    for (int e = 0; e < box.mesh.n_edges(); ++e)
        if (box.mesh.edge_flags[at(e)] != 0) {
            const auto [v, w] = box.mesh.edge_vertices(e);
            const int axis = box.axis(box.sides(v) == 3 ? w : v);
            result.push_back(std::abs(box.place(v)[axis] - box.place(w)[axis]) * n / (axis + 1));
        }
    return result;
}

double unevenness(const Box &box) {
    const std::vector<double> all = lengths(box);
    return *std::max_element(all.begin(), all.end());
}

// How far vertices are from the edge of the box that they are on; the corners are where they were.
void expect_on_edges(const Box &box, const mesh::QuadMesh &before) {
    for (int v = 0; v < box.mesh.n_vertices(); ++v)
        if (box.sides(v) == 3) {
            EXPECT_EQ(std::memcmp(&box.mesh.point(v), &before.point(v), sizeof(OpenMesh::Vec3d)), 0);
        } else if (box.sides(v) == 2) {
            const int axis = box.axis(v);
            for (int k = 0; k < 3; ++k)
                if (k != axis) {
                    EXPECT_NEAR(box.place(v)[k], (k + 1) * box.parameters[at(v)][k] / n, 2e-15);
                }
            EXPECT_GT(box.place(v)[axis], 0);
            EXPECT_LT(box.place(v)[axis], axis + 1);
        }
}

// Vertices come in the order of their parameters along each edge of the box.
void expect_in_order(const Box &box) {
    for (int e = 0; e < box.mesh.n_edges(); ++e)
        if (box.mesh.edge_flags[at(e)] != 0) {
            const auto [v, w] = box.mesh.edge_vertices(e);
            const int axis = box.axis(box.sides(v) == 3 ? w : v);
            EXPECT_GT((box.place(w)[axis] - box.place(v)[axis]) *
                          (box.parameters[at(w)][axis] - box.parameters[at(v)][axis]),
                      0);
        }
}

TEST(FeatureLines, AreTheStraightEdgesOfABox) {
    Box box;
    EXPECT_TRUE(feature_lines_of(box.mesh).empty()); // no curves yet
    box.mesh.curves = reference::curves_of(box.mesh);
    ASSERT_EQ(box.mesh.curves->lines().size(), 12u);
    const std::vector<geometry::FeatureLine> feature_lines = feature_lines_of(box.mesh);
    ASSERT_EQ(feature_lines.size(), at(box.mesh.n_vertices()));
    int found = 0;
    for (int v = 0; v < box.mesh.n_vertices(); ++v) {
        const geometry::FeatureLine &feature_line = feature_lines[at(v)];
        EXPECT_EQ(bool(feature_line), box.sides(v) == 2);
        if (!feature_line)
            continue;
        ++found;
        ASSERT_EQ(feature_line.lines.size(), 1u);
        EXPECT_NEAR((feature_line.lines[0].end - feature_line.lines[0].start).norm(), box.axis(v) + 1, 1e-14);
        for (const int w : feature_line.between)
            EXPECT_EQ(box.mesh.edge_flags[at(box.mesh.find_edge(v, w))], mesh::feature);
    }
    EXPECT_EQ(found, 12 * (n - 1));
    box.mesh.curves = nullptr;
    EXPECT_TRUE(feature_lines_of(box.mesh).empty());
}

TEST(FeatureLines, AreNotAtBends) {
    Box box;
    int bent = 0; // not the last on its edge
    while (box.sides(bent) != 2 || std::abs(box.parameters[at(bent)][box.axis(bent)] - n / 2) > 1)
        ++bent;
    const Vector3d away = box.turn * Vector3d(1e-9, 1e-9, 1e-9);
    box.mesh.set_point(bent, box.mesh.point(bent) + OpenMesh::Vec3d(away.x(), away.y(), away.z()));
    box.mesh.curves = reference::curves_of(box.mesh);
    const std::vector<geometry::FeatureLine> feature_lines = feature_lines_of(box.mesh);
    EXPECT_FALSE(feature_lines[at(bent)]);
    int missing = 0;
    for (int v = 0; v < box.mesh.n_vertices(); ++v)
        missing += box.sides(v) == 2 && !feature_lines[at(v)];
    EXPECT_EQ(missing, 3); // at its neighbours the curve bends, too
    const Vector3d before = point_of(box.mesh, bent);
    EXPECT_GE(smooth::smooth(box.mesh, nullptr, {}, silent).at(0).quality_after, 0);
    EXPECT_EQ(point_of(box.mesh, bent), before);
    EXPECT_FALSE(feature_line_of(box.mesh, bent));
}

TEST(FeatureLines, SmoothingSpreadsBunchedVertices) {
    Box box;
    const Box before = box;
    EXPECT_GT(unevenness(box), 1.8);
    double last = 0;
    std::shared_ptr<const surface::Curves> curves;
    for (int i = 0; i < 4; ++i) {
        const Outcome outcome = smooth::smooth(box.mesh, nullptr, {}, silent).at(0);
        EXPECT_GE(outcome.quality_after, std::max(outcome.quality_before, 0.2));
        EXPECT_GT(outcome.quality_after + 0.1, last);
        last = outcome.quality_after;
        expect_on_edges(box, before.mesh);
        expect_in_order(box);
        if (i > 0) {
            EXPECT_EQ(box.mesh.curves, curves); // still those of the beginning
        }
        curves = box.mesh.curves;
    }
    EXPECT_LT(unevenness(box), 1.3);
    EXPECT_EQ(box.mesh.edge_flags, before.mesh.edge_flags);
    EXPECT_NEAR(reference::surface_of(before.mesh)->area(), 22, 1e-9);
    EXPECT_NEAR(reference::surface_of(box.mesh)->area(), 22, 1e-9); // nothing is cut off
}

// Angles at a corner of a quad on a feature would gain if a side shrank to nothing.
TEST(FeatureLines, SmoothingSqueezesNoSideForItsAngles) {
    for (const unsigned seed : {5, 6, 11, 13, 14}) {
        Box box(2, 2, 0.4, seed);
        for (int i = 0; i < 4; ++i)
            smooth::smooth(box.mesh, nullptr, {}, silent);
        const std::vector<double> all = lengths(box);
        EXPECT_GT(*std::min_element(all.begin(), all.end()), 0.09) << seed;
    }
}

TEST(FeatureLines, WhatIsFixedStays) {
    Box box(1.5, 1, 0.2);
    std::vector<int> fixed;
    for (int v = 0; v < box.mesh.n_vertices(); ++v)
        if (box.sides(v) == 2 && box.parameters[at(v)][box.axis(v)] == 3) {
            box.mesh.vertex_flags[at(v)] |= mesh::fixed;
            fixed.push_back(v);
        }
    const Box before = box;
    smooth::smooth(box.mesh, nullptr, {}, silent);
    Reference reference = reference_of(box.mesh);
    smooth::relax_by_sizes(box.mesh, reference, std::nullopt, {});
    for (const int v : fixed)
        EXPECT_EQ(box.mesh.point(v), before.mesh.point(v));
    expect_on_edges(box, before.mesh);
    expect_in_order(box);
    int moved = 0;
    for (int v = 0; v < box.mesh.n_vertices(); ++v)
        moved += box.sides(v) == 2 && box.mesh.point(v) != before.mesh.point(v);
    EXPECT_GT(moved, 12 * (n - 2) * 3 / 4);
}

TEST(FeatureLines, RelaxingSpreadsBunchedVerticesTheSameOnAnyNumberOfThreads) {
    std::vector<std::uint64_t> digests;
    const Box before(1.5, 1, 0.2);
    EXPECT_GT(unevenness(before), 1.4);
    for (const int threads : {1, 2, 5}) {
        Box box = before;
        Settings settings;
        settings.threads = threads;
        Reference reference = reference_of(box.mesh);
        for (int i = 0; i < 3; ++i)
            smooth::relax_by_sizes(box.mesh, reference, std::nullopt, settings);
        EXPECT_LT(unevenness(box), 1.25);
        expect_on_edges(box, before.mesh);
        expect_in_order(box);
        digests.push_back(box.mesh.checksum());
    }
    EXPECT_EQ(digests[0], digests[1]);
    EXPECT_EQ(digests[0], digests[2]);
}

// All quads of an even box are rectangles, whatever side of it the surface's normals on its edges are of.
TEST(FeatureLines, QuadsAtFeaturesGoByTheirOwnSide) {
    Box box(1, 1, 0);
    const Reference reference = reference_of(box.mesh);
    std::vector<int> vertices(at(box.mesh.n_vertices()));
    std::iota(vertices.begin(), vertices.end(), 0);
    geometry::SurfacePositions on_surface = reference.on_surface(box.mesh);
    const auto worst = [&] {
        double least = 1;
        for (const auto &quad : box.mesh.faces())
            least = std::min(least, geometry::least_jacobian(quad, on_surface));
        return least;
    };
    EXPECT_LT(worst(), 0.8);
    forget_normals(box.mesh, vertices, box.mesh.faces(), on_surface);
    EXPECT_NEAR(worst(), 1, 1e-12);
    for (const double quality : reference.scaled_jacobians(box.mesh)) // against the quads around, too
        EXPECT_GT(quality, 0.699);
    for (const int v : vertices)
        EXPECT_EQ(on_surface.normals[at(v)].isZero(), box.sides(v) > 1);
    // The last face alone, by numbers of its own.
    const std::array<int, 4> last = box.mesh.corners(box.mesh.n_faces() - 1);
    const std::vector<std::array<int, 4>> quad{{0, 1, 2, 3}};
    on_surface = positions_on_surface(box.mesh, *reference.surface, {}, last);
    forget_normals(box.mesh, last, quad, on_surface);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(on_surface.normals[k].isZero(), box.sides(last[k]) > 1);
}

TEST(FeatureLines, BordersOfRegionsSlideAndStayStraight) {
    Box box(2, 2, 0.3);
    box.mesh.edge_flags.assign(box.mesh.edge_flags.size(), 0);
    box.mesh.vertex_flags.assign(box.mesh.vertex_flags.size(), 0);
    box.mesh.face_marker.assign(at(box.mesh.n_faces()), 0);
    for (int f = 0; f < box.mesh.n_faces(); ++f) { // one side of the box
        const auto corners = box.mesh.corners(f);
        box.mesh.face_marker[at(f)] =
            std::all_of(corners.begin(), corners.end(), [&](int v) { return box.parameters[at(v)][2] == n; });
    }
    const Box before = box;
    Reference reference = reference_of(box.mesh);
    ASSERT_TRUE(box.mesh.curves);
    EXPECT_EQ(box.mesh.curves->lines().size(), 4u);
    smooth::relax_by_sizes(box.mesh, reference, std::nullopt, {});
    int moved = 0, on_border = 0;
    for (int v = 0; v < box.mesh.n_vertices(); ++v) {
        const Vector3d &given = box.parameters[at(v)];
        if (given[2] != n || box.sides(v) != 2)
            continue;
        ++on_border;
        moved += box.mesh.point(v) != before.mesh.point(v);
        EXPECT_NEAR(box.place(v)[2], 3, 2e-15);
        const int across = 1 - box.axis(v);
        EXPECT_NEAR(box.place(v)[across], (across + 1) * given[across] / n, 2e-15);
    }
    EXPECT_EQ(on_border, 4 * (n - 1));
    EXPECT_GT(moved, 3 * (n - 1));
}

// The whole way: chords, windows, relaxing, exact number of faces.
TEST(FeatureLines, AnAdaptedBoxHasTheSameEdges) {
    for (const double alpha : {0.4, 1.5}) {
        Box box;
        const Outcome outcome = adapt::adapt_whole(box.mesh, alpha, {}, silent);
        ASSERT_NO_THROW(box.mesh.check());
        EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
        EXPECT_LE(outcome.singular_after, 8) << alpha;
        EXPECT_GT(outcome.quality_after, 0);
        EXPECT_NEAR(reference::surface_of(box.mesh)->area(), 22, 1e-9);
        double length = 0;
        int edges = 0;
        for (int e = 0; e < box.mesh.n_edges(); ++e)
            if (box.mesh.edge_flags[at(e)] == mesh::feature) {
                const auto [v, w] = box.mesh.edge_vertices(e);
                const std::array ends{point_of(box.mesh, v), point_of(box.mesh, w)};
                EXPECT_GE(box.mesh.curves->find(ends), 0);
                length += (ends[1] - ends[0]).norm();
                ++edges;
            }
        EXPECT_NEAR(length, 24, 1e-12);
        EXPECT_EQ(box.mesh.curves->lines().size(), 12u);
        if (alpha < 1) {
            EXPECT_LT(edges, 12 * n);
        } else {
            EXPECT_GE(edges, 12 * n);
        }
    }
}

// Two shallow domes that meet at a sharp circle: quads with two sides on it may have positive corners of
// their own and yet be inverted against what is beyond. None is made.
TEST(FeatureLines, NoQuadTurnsOverAcrossFeatures) {
    for (const double alpha : {0.35, 0.5}) {
        mesh::QuadMesh mesh = mesh::cube(10, [](const Vector3d &given) {
            const Vector3d p = (given / 5 - Vector3d::Ones()).normalized();
            return Vector3d(p.x(), p.y(), 0.3 * p.z() * std::abs(p.z()));
        });
        int sharp = 0;
        for (const int e : mesh::find_features(mesh, 25).edges) {
            mesh.edge_flags[at(e)] |= mesh::feature;
            ++sharp;
        }
        EXPECT_EQ(sharp, 40);
        adapt::adapt_whole(mesh, alpha, {}, silent);
        EXPECT_LE(mesh.n_faces(), 300);
        for (const double quality : reference_of(mesh).scaled_jacobians(mesh))
            EXPECT_GT(quality, 0) << alpha;
    }
}

// Two neighbours on an edge of the box in the wrong order, so that the quads at it are folded.
struct Folded : Box {
    Folded() : Box(1, 1, 0) {
        mesh.edge_flags.assign(mesh.edge_flags.size(), 0);
        mesh.vertex_flags.assign(mesh.vertex_flags.size(), 0);
        std::array<int, 2> pair{-1, -1};
        for (int v = 0; v < mesh.n_vertices(); ++v)
            for (std::size_t k = 0; k < 2; ++k)
                if (parameters[at(v)] == Vector3d(3.0 + static_cast<double>(k), 0, 0))
                    pair[k] = v;
        const OpenMesh::Vec3d step = 0.6 * (mesh.point(pair[1]) - mesh.point(pair[0]));
        mesh.set_point(pair[0], mesh.point(pair[0]) + step);
        mesh.set_point(pair[1], mesh.point(pair[1]) - step);
        flag_features(mesh);
    }
};

TEST(FeatureLines, AFoldIsNoCorner) {
    const Folded box;
    EXPECT_EQ(std::count(box.mesh.vertex_flags.begin(), box.mesh.vertex_flags.end(), mesh::corner), 8);
}

TEST(FeatureLines, FoldedVerticesComeInOrder) {
    Folded box;
    const Box before(1, 1, 0);
    straighten(box.mesh);
    expect_on_edges(box, before.mesh);
    expect_in_order(box);
    const auto once = box.mesh.checksum();
    straighten(box.mesh);
    EXPECT_EQ(box.mesh.checksum(), once);
    box = Folded();
    EXPECT_EQ(adapt::adapt_whole(box.mesh, 1, {}, silent).singular_after, 8);
    EXPECT_NEAR(reference::surface_of(box.mesh)->area(), 22, 1e-9);
    for (const double quality : reference_of(box.mesh).scaled_jacobians(box.mesh))
        EXPECT_GT(quality, 0);
}

TEST(FeatureLines, FixedVerticesStayFolded) {
    Folded box;
    for (std::uint8_t &flags : box.mesh.vertex_flags)
        flags |= mesh::fixed;
    const auto before = box.mesh.checksum();
    straighten(box.mesh);
    EXPECT_EQ(box.mesh.checksum(), before);
}

// A ring whose section is a square: its features are four circles of 48 edges, bunched at one side.
struct SquareRing {
    static constexpr int around = 48, across = 4, up = 4 * across;
    mesh::QuadMesh mesh = mesh::grid(
        around, up,
        [](double u, double v) {
            const double side = 4 * v, x = side - std::floor(side);
            // Inside of the sides, vertices are pushed about, so that smoothing has something to gain.
            const double pushed = x > 0 ? 0.006 * std::sin(1000 * u + 300 * v) : 0;
            const double angle =
                2 * std::numbers::pi * (u + pushed) + 0.6 * std::sin(2 * std::numbers::pi * (u + pushed));
            const std::array<Eigen::Vector2d, 5> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
            const auto k = static_cast<std::size_t>(std::min(3.0, std::floor(side)));
            const Eigen::Vector2d p = (1 - x) * corners[k] + x * corners[k + 1];
            return Vector3d((3 + p.x()) * std::cos(angle), (3 + p.x()) * std::sin(angle), p.y());
        },
        true, true);

    SquareRing() { flag_features(mesh); }

    std::vector<double> lengths() const {
        std::vector<double> all;
        for (int e = 0; e < mesh.n_edges(); ++e)
            if (mesh.edge_flags[at(e)] != 0) {
                const auto [v, w] = mesh.edge_vertices(e);
                all.push_back((point_of(mesh, w) - point_of(mesh, v)).norm() /
                              point_of(mesh, v).head<2>().norm());
            }
        return all;
    }
    double unevenness() const {
        const std::vector<double> all = lengths();
        return *std::ranges::max_element(all) / *std::ranges::min_element(all);
    }
};

Settings editing() {
    Settings settings;
    settings.edit_boundary = true;
    return settings;
}

TEST(FeatureLines, GoAroundBendsWhereTheBoundaryMayChange) {
    SquareRing ring;
    ring.mesh.curves = reference::curves_of(ring.mesh);
    EXPECT_TRUE(feature_lines_of(ring.mesh).empty());
    const auto lines = feature_lines_of(ring.mesh, bend_tolerance(editing()));
    EXPECT_EQ(std::ranges::count_if(lines, [](const auto &line) { return bool(line); }), 4 * ring.around);
}

TEST(FeatureLines, VerticesSlideAroundBends) {
    SquareRing ring;
    const SquareRing before = ring;
    EXPECT_GT(ring.unevenness(), 3.8);
    smooth::smooth(ring.mesh, nullptr, {}, silent);
    EXPECT_EQ(ring.lengths(), before.lengths()); // unless they may, they do not
    const auto curves = ring.mesh.curves;
    for (int i = 0; i < 4; ++i)
        smooth::smooth(ring.mesh, nullptr, editing(), silent);
    EXPECT_EQ(ring.mesh.curves, curves); // that of the beginning, not of its edges now
    EXPECT_LT(ring.unevenness(), 3);
    for (int v = 0; v < ring.mesh.n_vertices(); ++v)
        if (patch::slide(ring.mesh, v)) {
            EXPECT_GE(curves->find(std::array{point_of(ring.mesh, v)}), 0); // to rounding
        }
}

TEST(FeatureLines, TakeMiddlesOfEdgesToTheCurve) {
    SquareRing ring;
    ring.mesh.curves = reference::curves_of(ring.mesh);
    const auto find = [&](int v) { return ring.mesh.curves->find(std::array{point_of(ring.mesh, v)}); };
    int moved = 0;
    for (int v = 0; v < ring.mesh.n_vertices(); ++v)
        if (const auto others = patch::slide(ring.mesh, v);
            others && moved < 5 && find((*others)[0]) >= 0 && find((*others)[1]) >= 0) {
            ring.mesh.set_point(v, (ring.mesh.point((*others)[0]) + ring.mesh.point((*others)[1])) / 2);
            EXPECT_LT(find(v), 0);
            ++moved;
        }
    ASSERT_EQ(moved, 5);
    keep_to_curves(ring.mesh);
    for (int v = 0; v < ring.mesh.n_vertices(); ++v)
        if (patch::slide(ring.mesh, v)) {
            EXPECT_GE(find(v), 0);
        }
}

} // namespace
} // namespace alphamst::reference
