// Fields at the boundary: edges inside and on it, vertices that slide along it or beyond it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "chord/table.h"
#include "chords/edit.h"
#include "reference/locate.h"
#include "reference/projection.h"
#include "transfer/carry.h"

namespace alphamst::transfer {
namespace {

using adapt::samples::silent;
using mesh::Carry;
using mesh::QuadMesh;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double linear(const OpenMesh::Vec3d &p) { return 3 - 2 * p[0] + 0.5 * p[1]; }

void set(QuadMesh &mesh, Entity entity, const char *name, Carry carry, std::vector<double> values) {
    mesh.fields.set(
        std::make_shared<const mesh::Field>(mesh::Field{entity, name, 1, carry, std::move(values)}));
}

bool on_boundary(const QuadMesh &mesh, int edge) {
    const auto faces = mesh.edge_faces(edge);
    return faces[0] < 0 || faces[1] < 0;
}

// 1 on the boundary, 0 inside.
void mark_boundary(QuadMesh &mesh) {
    std::vector<double> values;
    for (int e = 0; e < mesh.n_edges(); ++e)
        values.push_back(on_boundary(mesh, e) ? 1 : 0);
    set(mesh, Entity::edge, "boundary", Carry::inherit, values);
}

void set_linear(QuadMesh &mesh) {
    std::vector<double> values;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        values.push_back(linear(mesh.point(v)));
    set(mesh, Entity::vertex, "linear", Carry::linear, values);
}

void expect_linear(const QuadMesh &mesh) {
    for (int v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_NEAR((*mesh.field(Entity::vertex, "linear"))[at(v)], linear(mesh.point(v)), 1e-12);
}

// What an operation makes of the mesh, with its fields.
template <class Operation> QuadMesh after(const QuadMesh &before, const Operation &operation) {
    QuadMesh mesh = before;
    mesh.reset_origins();
    mesh.begun = std::make_shared<const QuadMesh>(before);
    operation(mesh);
    mesh.begun.reset();
    carry(before, mesh, silent);
    return mesh;
}

Settings with_boundary() {
    Settings settings;
    settings.edit_boundary = true;
    return settings;
}

QuadMesh adapted(const QuadMesh &before, double alpha, const Settings &settings) {
    return after(before, [&](QuadMesh &mesh) {
        if (settings.edit_boundary)
            reference::keep_boundary(mesh, {}, settings.tolerance);
        adapt::adapt_whole(mesh, alpha, settings, silent);
    });
}

void expect_no_leak(const QuadMesh &mesh) {
    for (int e = 0; e < mesh.n_edges(); ++e)
        EXPECT_EQ((*mesh.field(Entity::edge, "boundary"))[at(e)], on_boundary(mesh, e) ? 1 : 0);
}

TEST(CarryOfEdges, PatchesAtTheBoundaryLeakNothing) {
    QuadMesh mesh = adapt::samples::grid(10, 10);
    mark_boundary(mesh);
    for (const double alpha : {0.4, 2.5}) {
        const QuadMesh refilled = after(mesh, [&](QuadMesh &changed) {
            std::vector<Patch> patches{{adapt::samples::block(10, 0, 0, 6, 6), {}, 0}};
            adapt::adapt(changed, patches, alpha, {}, silent);
        });
        EXPECT_NE(refilled.n_faces(), 100);
        expect_no_leak(refilled);
    }
}

TEST(CarryOfEdges, WholeMeshesLeakNothing) {
    QuadMesh mesh = adapt::samples::grid(8, 8);
    mark_boundary(mesh);
    for (const double alpha : {0.5, 2.0})
        for (const Settings &settings : {Settings(), with_boundary()})
            expect_no_leak(adapted(mesh, alpha, settings));
}

TEST(CarryOfEdges, ChordsLeakNothing) {
    QuadMesh mesh = adapt::samples::grid(6, 4);
    mark_boundary(mesh);
    int collapsed = 0;
    for (const chord::Row &row : chord::table(mesh, {true})) {
        expect_no_leak(after(mesh, [&](QuadMesh &changed) {
            chords::split_chord(changed, row.edge, 2, 1 << 20, {true}, {}, silent);
        }));
        if (row.reasons != 0)
            continue;
        ++collapsed; // also the outermost, the edges of which come to the boundary
        expect_no_leak(after(
            mesh, [&](QuadMesh &changed) { chords::collapse_chord(changed, row.edge, {true}, {}, silent); }));
    }
    EXPECT_GT(collapsed, 0);
}

// Edges of one number take from such edges, wherever others are nearer.
TEST(CarryOfEdges, NumbersAreKindsOfTheirOwn) {
    QuadMesh mesh = adapt::samples::grid(8, 8);
    mesh.edge_marker.assign(at(mesh.n_edges()), 0);
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (on_boundary(mesh, e)) {
            const auto [v, w] = mesh.edge_vertices(e);
            mesh.edge_marker[at(e)] = mesh.point(v)[0] + mesh.point(w)[0] < 8 ? 1 : 2;
        }
    set(mesh, Entity::edge, "number", Carry::inherit,
        std::vector<double>(mesh.edge_marker.begin(), mesh.edge_marker.end()));
    const QuadMesh finer = adapted(mesh, 3, with_boundary());
    EXPECT_GT(finer.n_edges(), mesh.n_edges());
    for (int e = 0; e < finer.n_edges(); ++e)
        EXPECT_EQ((*finer.field(Entity::edge, "number"))[at(e)], finer.edge_marker[at(e)]);
}

// A single face has no edge inside: what is unknown is 0.
TEST(CarryOfEdges, WhereThereWasNoneOfTheKindIsZero) {
    QuadMesh mesh = adapt::samples::grid(1, 1);
    set(mesh, Entity::edge, "boundary", Carry::inherit, std::vector<double>(4, 1));
    const QuadMesh cut = after(mesh, [](QuadMesh &changed) {
        changed.replace_disk(
            std::vector{0}, std::vector{0, 1, 3, 2},
            std::vector<std::array<int, 4>>{
                {0, 1, 4, 5}, {1, 2, 7, 4}, {2, 3, 6, 7}, {3, 0, 5, 6}, {4, 7, 6, 5}},
            std::vector<OpenMesh::Vec3d>{{0.7, 0.3, 0}, {0.3, 0.3, 0}, {0.3, 0.7, 0}, {0.7, 0.7, 0}});
    });
    expect_no_leak(cut);
}

// A ring between circles of radius 1 and 2, n faces round and m across.
QuadMesh ring(int n, int m) {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n, radius = 1 + 1.0 * j / m;
            points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
        }
    const auto vertex = [&](int i, int j) { return j * n + i % n; };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            faces.insert(faces.end(),
                         {vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j)});
    return QuadMesh::build(2, points, faces);
}

// On the circle as it was first seen new vertices are outside the polygon of those before.
TEST(CarryOfVertices, LinearFunctionsGoOnBeyondACurvedBoundary) {
    QuadMesh mesh = ring(24, 4);
    set_linear(mesh);
    for (const double alpha : {2.0, 0.6, 1.7, 0.5, 2.5}) {
        mesh = adapted(mesh, alpha, with_boundary());
        expect_linear(mesh);
    }
}

TEST(CarryOfVertices, LinearFunctionsSurviveTenCalls) {
    QuadMesh mesh = adapt::samples::unstructured(12, 5);
    set_linear(mesh);
    Settings settings = with_boundary();
    for (const double alpha : {1.0, 2.0, 0.5, 1.0, 1.5, 0.7, 1.0, 2.5, 0.5, 0.8}) {
        ++settings.seed;
        mesh = adapted(mesh, alpha, settings);
    }
    expect_linear(mesh);
}

// "size" has to stay above 0: it is not continued to the other side of it.
TEST(CarryOfVertices, SizesStayAboveZero) {
    QuadMesh mesh = ring(12, 3);
    std::vector<double> sizes;
    for (int v = 0; v < mesh.n_vertices(); ++v)
        sizes.push_back(v >= 36 ? 1e-9 : 0.5);
    set(mesh, Entity::vertex, "size", Carry::linear, sizes);
    set(mesh, Entity::vertex, "other", Carry::linear, sizes);
    const QuadMesh moved = after(mesh, [](QuadMesh &changed) {
        for (int v = 36; v < 48; ++v)
            changed.set_point(v, 1.02 * changed.point(v));
    });
    for (int v = 36; v < 48; ++v) {
        EXPECT_GE((*moved.field(Entity::vertex, "size"))[at(v)], 1e-9);
        EXPECT_LT((*moved.field(Entity::vertex, "other"))[at(v)], 0);
    }
}

// On a surface the value is that at the nearest point, so a coordinate is missed by the distance at most.
TEST(CarryOfVertices, OnASurfaceTheNearestPointCounts) {
    QuadMesh mesh = adapt::samples::grid(12, 12, 3);
    std::mt19937 random(4);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        OpenMesh::Vec3d p = mesh.point(v);
        if (!mesh.on_boundary(v))
            p += OpenMesh::Vec3d(0.4 * adapt::samples::chance(random) - 0.2,
                                 0.4 * adapt::samples::chance(random) - 0.2, 0);
        mesh.set_point(v, {p[0], p[1], 3 * std::sin(p[0] / 4) * std::cos(p[1] / 5)});
    }
    set_linear(mesh);
    const QuadMesh moved =
        after(mesh, [](QuadMesh &changed) { smooth::smooth(changed, nullptr, {}, silent); });
    const reference::FaceTree tree(mesh, adapt::samples::all_faces(mesh));
    const double steepness = std::hypot(2.0, 0.5);
    int count = 0;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const double value = (*moved.field(Entity::vertex, "linear"))[at(v)],
                     distance = std::sqrt(tree.nearest(reference::point_of(moved, v)).spot.distance);
        count += moved.point(v) != mesh.point(v);
        EXPECT_LE(std::abs(value - linear(moved.point(v))), steepness * distance + 1e-12);
    }
    EXPECT_GT(count, 60);
}

} // namespace
} // namespace alphamst::transfer
