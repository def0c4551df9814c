#include "adapt/chord_prepass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "chord/meshes.h"
#include "eared.h"
#include "mesh/curved.h"
#include "mesh/grids.h"
#include "reference/locate.h"
#include "reference/surface_of.h"
#include "run.h"
#include "surface/curve.h"

namespace alphamst::adapt {
namespace {

using samples::silent;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

mesh::QuadMesh on_itself(mesh::QuadMesh mesh) {
    mesh.surface = reference::surface_of(mesh);
    return mesh;
}

mesh::QuadMesh torus() { return on_itself(mesh::torus(36, 12).build(3)); }

int count(const std::vector<std::uint8_t> &flags) {
    return static_cast<int>(flags.size() - at(static_cast<int>(std::count(flags.begin(), flags.end(), 0))));
}

void expect_on_surface(const mesh::QuadMesh &mesh) {
    for (int v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_LT(mesh.surface->nearest(reference::point_of(mesh, v)).distance, 1e-12);
}

TEST(Begin, ARegularTorusComesNearerByChordsAlone) {
    for (const double alpha : {1.5, 2.0, 3.0}) {
        mesh::QuadMesh mesh = torus();
        const auto surface = mesh.surface;
        const int before = mesh.n_faces();
        const auto wanted = std::llround(alpha * before);
        chord_prepass(mesh, wanted, {}, silent);
        EXPECT_GT(mesh.n_faces(), before + 0.8 * static_cast<double>(wanted - before)) << alpha;
        EXPECT_LE(mesh.n_faces(), wanted) << alpha;
        EXPECT_TRUE(mesh.singularities().empty()) << alpha;
        EXPECT_EQ(mesh.n_vertices(), mesh.n_faces()); // still a torus
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.surface, surface);
        expect_on_surface(mesh);
        EXPECT_EQ(count(mesh.edge_flags) + count(mesh.vertex_flags) + count(mesh.face_flags), 0);
    }
}

TEST(Begin, ARegularTorusIsCoarsenedByChordsAlone) {
    for (const double alpha : {0.4, 0.6, 0.8}) {
        mesh::QuadMesh mesh = torus();
        const auto surface = mesh.surface;
        const int before = mesh.n_faces();
        const auto wanted = std::llround(alpha * before);
        chord_prepass(mesh, wanted, {}, silent);
        EXPECT_LT(mesh.n_faces(), before - 0.7 * static_cast<double>(before - wanted)) << alpha;
        EXPECT_GE(mesh.n_faces(), wanted) << alpha;
        EXPECT_TRUE(mesh.singularities().empty()) << alpha;
        EXPECT_EQ(mesh.n_vertices(), mesh.n_faces()); // still a torus
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(mesh.surface, surface);
        expect_on_surface(mesh);
        EXPECT_GT(reference::surface_of(mesh)->area(), 0.85 * surface->area());
    }
}

TEST(Begin, CurvedFeaturesStayVertexByVertex) {
    mesh::QuadMesh mesh = torus();
    std::vector<OpenMesh::Vec3d> before; // on the inner equator
    const auto inside = [](const OpenMesh::Vec3d &p) {
        return std::abs(std::hypot(p[0], p[1]) - 2) < 1e-6 && std::abs(p[2]) < 1e-6;
    };
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (inside(mesh.point(v)) && inside(mesh.point(w)))
            mesh.edge_flags[at(e)] |= mesh::feature;
    }
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (inside(mesh.point(v)))
            before.push_back(mesh.point(v));
    chord_prepass(mesh, mesh.n_faces() / 2, {}, silent);
    EXPECT_LT(mesh.n_faces(), 36 * 12); // of the chords beside it some went
    EXPECT_EQ(count(mesh.edge_flags), 36);
    for (const OpenMesh::Vec3d &p : before) {
        int found = 0;
        for (int v = 0; v < mesh.n_vertices(); ++v)
            found += mesh.point(v) == p;
        EXPECT_EQ(found, 1);
    }
}

TEST(Begin, FeaturesAndBoundaryLoseVerticesIfTheyMay) {
    mesh::QuadMesh mesh = mesh::grid(40, 12, [](double s, double t) { // three quarters of a tube
        const double angle = 1.5 * std::numbers::pi * s;
        return Eigen::Vector3d(std::cos(angle), std::sin(angle), 1.5 * t);
    });
    mesh = on_itself(std::move(mesh));
    const auto amid = [&](int v) { return std::abs(mesh.point(v)[2] - 0.75) < 1e-9; };
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (amid(v) && amid(w))
            mesh.edge_flags[at(e)] |= mesh::feature;
    }
    mesh.curves = reference::curves_of(mesh); // as when an operation begins
    const mesh::QuadMesh before = mesh;
    Settings settings;
    for (const bool edit : {false, true}) {
        mesh = before;
        settings.edit_boundary = edit;
        chord_prepass(mesh, mesh.n_faces() / 2, settings, silent);
        EXPECT_TRUE(mesh.singularities().empty());
        EXPECT_NO_THROW(mesh.check());
        EXPECT_EQ(count(mesh.edge_flags) < 40, edit);
        EXPECT_EQ(mesh.n_faces() < 300, edit);
        int kept = 0;
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            if (!mesh.on_boundary(v) && !amid(v))
                continue;
            // Those that stay are where they were, but for the feature: there they may slide along the curve.
            bool there = false;
            for (int w = 0; w < before.n_vertices(); ++w)
                there |= before.point(w) == mesh.point(v);
            for (int e = 0; edit && amid(v) && e < before.n_edges(); ++e)
                if (before.edge_flags[at(e)] != 0) {
                    const auto [a, b] = before.edge_vertices(e);
                    const surface::Line line{reference::point_of(before, a), reference::point_of(before, b)};
                    there |= line.distance(reference::point_of(mesh, v)) < 1e-12;
                }
            EXPECT_TRUE(there);
            ++kept;
        }
        EXPECT_EQ(kept == 3 * 41 + 20, !edit);
    }
}

TEST(Begin, StopsWhereCoarseningWouldUncoverTheSurface) {
    mesh::QuadMesh mesh = torus();
    const auto before = mesh.checksum();
    Settings strict;
    strict.tolerance = 0.02;
    chord_prepass(mesh, mesh.n_faces() / 2, strict, silent);
    EXPECT_EQ(mesh.checksum(), before);
}

TEST(Begin, CanBeStopped) {
    for (const double alpha : {0.5, 2.0}) {
        mesh::QuadMesh mesh = torus();
        EXPECT_THROW(chord_prepass(mesh, std::llround(alpha * mesh.n_faces()), {},
                                   [](double, const char *) { throw Failure(Fault::cancelled, ""); }),
                     Failure);
    }
}

TEST(Begin, SplitsPutVerticesOnTheSurfaceNotOnTheEdges) {
    // The surface is finer than the mesh.
    mesh::QuadMesh mesh = mesh::torus(36, 12).build(3);
    mesh.surface = reference::surface_of(mesh::torus(144, 48).build(3));
    chord_prepass(mesh, 2 * mesh.n_faces(), {}, silent);
    EXPECT_GT(mesh.n_faces(), 700);
    expect_on_surface(mesh);
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const auto p = reference::point_of(mesh, v);
        EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 3, p.z()), 1, 0.01);
    }
}

TEST(Begin, FeaturesOfTheCallerStay) {
    mesh::QuadMesh mesh = torus();
    // The inner equator.
    const auto inside = [](const mesh::QuadMesh &of, int v) {
        const auto p = reference::point_of(of, v);
        return std::abs(std::hypot(p.x(), p.y()) - 2) < 1e-6 && std::abs(p.z()) < 1e-6;
    };
    int named = 0;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [v, w] = mesh.edge_vertices(e);
        if (inside(mesh, v) && inside(mesh, w)) {
            mesh.edge_flags[at(e)] |= mesh::feature;
            ++named;
        }
    }
    mesh.vertex_flags[0] |= mesh::corner;
    ASSERT_EQ(named, 36);
    const OpenMesh::Vec3d corner = mesh.point(0);
    chord_prepass(mesh, 2 * mesh.n_faces(), {}, silent);
    EXPECT_GT(mesh.n_faces(), 700);
    EXPECT_TRUE(mesh.singularities().empty());
    double length = 0;
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (mesh.edge_flags[at(e)] != 0) {
            const auto [v, w] = mesh.edge_vertices(e);
            EXPECT_EQ(mesh.edge_flags[at(e)], mesh::feature);
            length += (mesh.point(v) - mesh.point(w)).norm();
        }
    EXPECT_NEAR(length, 36 * 4 * std::sin(std::numbers::pi / 36), 1e-9);
    EXPECT_EQ(count(mesh.vertex_flags), 1);
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (mesh.vertex_flags[at(v)] != 0) {
            EXPECT_EQ(mesh.vertex_flags[at(v)], mesh::corner);
            EXPECT_EQ(mesh.point(v), corner);
        }
}

TEST(Begin, OtherFlagsStayAndNoneAreLeftBehind) {
    // A cube: its edges are sharp, and nobody named them.
    mesh::QuadMesh mesh = on_itself(chord::samples::sphere(10));
    mesh.face_flags[5] |= mesh::fixed;
    const OpenMesh::Vec3d first = mesh.point(mesh.corners(5)[0]);
    chord_prepass(mesh, 2 * mesh.n_faces(), {}, silent);
    EXPECT_GT(mesh.n_faces(), 900);
    EXPECT_EQ(mesh.singularities().size(), 8u);
    EXPECT_EQ(count(mesh.edge_flags) + count(mesh.vertex_flags), 0);
    ASSERT_EQ(count(mesh.face_flags), 1);
    const auto held = std::find(mesh.face_flags.begin(), mesh.face_flags.end(), mesh::fixed);
    EXPECT_EQ(mesh.point(mesh.corners(static_cast<int>(held - mesh.face_flags.begin()))[0]), first);
    double area = 0; // and it is still a cube
    for (int f = 0; f < mesh.n_faces(); ++f)
        area += geometry::area_vector(reference::quad_of(mesh, f)).norm();
    EXPECT_NEAR(area, 600, 1e-9);
}

void expect_untouched(mesh::QuadMesh mesh, std::int64_t wanted) {
    const mesh::QuadMesh before = mesh;
    chord_prepass(mesh, wanted, {}, silent);
    EXPECT_EQ(mesh.checksum(), before.checksum());
    EXPECT_EQ(mesh.surface, before.surface);
    EXPECT_EQ(mesh.vertex_origin, before.vertex_origin);
}

TEST(Begin, LeavesWhatIsNotForChords) {
    const mesh::QuadMesh regular = torus();
    const auto faces = static_cast<std::int64_t>(regular.n_faces());
    expect_untouched(regular, faces);
    for (const auto change : {-faces / 11, faces / 11}) // near enough
        expect_untouched(regular, faces + change);
    const mesh::QuadMesh many = on_itself(samples::eared(3));
    ASSERT_GT(25 * static_cast<int>(many.singularities().size()), many.n_faces());
    expect_untouched(many, 2 * many.n_faces());
    expect_untouched(many, many.n_faces() / 2);
    expect_untouched(mesh::torus(36, 12).build(3), 2 * faces); // without a surface
}

TEST(Begin, LeavesAMeshWithSizes) {
    mesh::QuadMesh mesh = torus();
    auto size = std::make_shared<mesh::Field>();
    size->name = "size";
    size->values.assign(at(mesh.n_vertices()), 0.1);
    mesh.fields.set(size);
    const auto before = mesh.checksum();
    chord_prepass(mesh, 2 * mesh.n_faces(), {}, silent);
    EXPECT_EQ(mesh.checksum(), before);
    // The sizes are those of the vertices as they were: none may be asked for that there is not.
    Settings settings;
    const Outcome outcome = adapt_whole(mesh, 2, settings, silent);
    EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
}

TEST(Begin, LeavesThePlane) {
    for (const int dim : {2, 3}) {
        mesh::QuadMesh ring = mesh::grid(
            24, 5,
            [](double s, double t) {
                const double angle = 2 * std::numbers::pi * s;
                return Eigen::Vector3d((2 - t) * std::cos(angle), (2 - t) * std::sin(angle), 0);
            },
            true, false, dim);
        expect_untouched(ring, 240);
        ring = on_itself(ring);
        if (dim == 2)
            expect_untouched(ring, 240);
        else
            chord_prepass(ring, 240, {}, silent); // a surface that happens to be flat
        EXPECT_EQ(ring.n_faces(), dim == 2 ? 120 : 240);
    }
}

// Eight singular vertices in 96 faces are many, but no cube has fewer.
TEST(Begin, ASmallCubeComesToFourTimesItsFacesByChordsAlone) {
    mesh::QuadMesh mesh = on_itself(mesh::cube(4, [](const Eigen::Vector3d &p) { return p; }));
    ASSERT_EQ(mesh.n_faces(), 96);
    chord_prepass(mesh, 384, {}, silent);
    EXPECT_EQ(mesh.n_faces(), 384);
    EXPECT_EQ(mesh.singularities().size(), 8u);
    EXPECT_NO_THROW(mesh.check());
}

TEST(Begin, LeavesWhatWouldUncoverTheSurface) {
    // Twelve vertices around the tube, and a surface with a spike between them.
    mesh::QuadMesh spiked = mesh::torus(144, 48).build(3);
    for (int v = 0; v < spiked.n_vertices(); ++v) {
        const auto p = reference::point_of(spiked, v);
        const double away = (p - Eigen::Vector3d(4, 0.2, 0.2)).norm();
        spiked.set_point(v, spiked.point(v) * (1 + 0.8 * std::exp(-30 * away * away)));
    }
    mesh::QuadMesh mesh = mesh::torus(36, 12).build(3);
    mesh.surface = reference::surface_of(spiked);
    expect_untouched(mesh, 2 * mesh.n_faces());
    Settings lenient;
    lenient.tolerance = 100;
    chord_prepass(mesh, 2 * mesh.n_faces(), lenient, silent);
    EXPECT_GT(mesh.n_faces(), 700);
}

} // namespace
} // namespace alphamst::adapt
