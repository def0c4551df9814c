#include "refill/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "adapt/meshes.h"
#include "geometry/parametrise.h"
#include "mesh/curved.h"
#include "reference/locate.h"
#include "reference/reference.h"
#include "reference/surface_of.h"

namespace alphamst::refill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Faces of a mesh as a filling of their boundary, laid on a surface.
struct Piece {
    fill::Filling filling;
    geometry::SurfacePositions on_surface;

    Piece(const mesh::QuadMesh &mesh, const surface::Surface &surface, const std::vector<int> &faces,
          std::vector<int> loop) {
        filling.boundary = static_cast<int>(loop.size());
        std::vector<int> vertices = std::move(loop);
        for (const int v : patch::make_window(mesh, faces).interior)
            vertices.push_back(v);
        std::map<int, int> local;
        for (const int v : vertices)
            local.emplace(v, static_cast<int>(local.size()));
        for (const int f : faces) {
            filling.quads.push_back(mesh.corners(f));
            for (int &v : filling.quads.back())
                v = local.at(v);
        }
        filling.vertices = static_cast<int>(vertices.size());
        on_surface = reference::positions_on_surface(mesh, surface, {}, vertices);
    }
};

// The part of a sphere of radius 1 above a height: flat enough for a plane above 0.6.
struct Cap {
    mesh::QuadMesh sphere = mesh::sphere(12);
    std::shared_ptr<const surface::Surface> surface = reference::surface_of(sphere);
    std::vector<int> faces, loop;

    explicit Cap(double height) {
        for (int f = 0; f < sphere.n_faces(); ++f) {
            const auto corners = sphere.corners(f);
            if (std::all_of(corners.begin(), corners.end(),
                            [&](int v) { return sphere.point(v)[2] > height; }))
                faces.push_back(f);
        }
        EXPECT_EQ(patch::defects(sphere, faces), 0);
        loop = patch::make_window(sphere, faces).loop;
    }
    Piece piece() const { return {sphere, *surface, faces, loop}; }
    // The same boundary, other quads inside.
    Piece other(int turns) const {
        mesh::QuadMesh turned = sphere;
        std::mt19937 random(3);
        adapt::samples::turn_edges(turned, faces, turns, random);
        EXPECT_GE(turned.singularities().size(), sphere.singularities().size() + 8);
        return {turned, *surface, faces, loop};
    }
};

constexpr double low = 0.6, high = -0.4;

TEST(Chart, OfAPlaneIsThePlane) {
    const Vector3d along = Vector3d(1, 2, 2) / 3, across = Vector3d(2, -2, 1) / 3;
    const mesh::QuadMesh mesh = mesh::grid(6, 4, [&](double s, double t) {
        return Vector3d(Vector3d(5, 6, 7) + (6 * s + 0.3 * std::sin(5 * t)) * along + 4 * t * across);
    });
    const auto surface = reference::surface_of(mesh);
    const std::vector<int> faces = adapt::samples::all_faces(mesh);
    const Piece piece(mesh, *surface, faces, patch::make_window(mesh, faces).loop);
    const Chart chart(piece.filling, piece.on_surface);
    const geometry::Points &flat = chart.positions();
    ASSERT_EQ(flat.size(), at(mesh.n_vertices()));
    for (std::size_t i = 0; i < flat.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NEAR((flat[i] - flat[j]).norm(),
                        (piece.on_surface.points[i] - piece.on_surface.points[j]).norm(), 1e-12);
    EXPECT_TRUE(geometry::shapes_of(piece.filling.quads, flat).valid); // not seen from behind
    // What is between the vertices is as far from them in space.
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        const Vector2d &p = flat[random() % flat.size()], &q = flat[random() % flat.size()];
        const Vector2d x = p + adapt::samples::chance(random) * (q - p);
        const Vector3d lifted = chart.lift(*surface, x).point;
        double nearest = HUGE_VAL; // at a side that is bent inwards, x may be outside
        for (std::size_t v = 0; v < flat.size(); ++v)
            nearest = std::min(nearest, (flat[v] - x).norm());
        if (nearest < 0.4)
            continue;
        for (std::size_t v = 0; v < flat.size(); ++v)
            EXPECT_NEAR((piece.on_surface.points[v] - lifted).norm(), (flat[v] - x).norm(), 1e-12);
    }
}

TEST(Chart, OfALowCapIsItsProjection) {
    const Piece piece = Cap(low).piece();
    const Chart chart(piece.filling, piece.on_surface);
    for (std::size_t i = 0; i < chart.positions().size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vector3d way = piece.on_surface.points[i] - piece.on_surface.points[j];
            EXPECT_NEAR((chart.positions()[i] - chart.positions()[j]).norm(), std::hypot(way.x(), way.y()),
                        1e-9);
        }
    EXPECT_TRUE(geometry::shapes_of(piece.filling.quads, chart.positions()).valid);
}

// And of what could still be projected, but would be seen from the side.
TEST(Chart, OfAHighCapIsACircleSpacedByLength) {
    for (const double height : {0.25, high}) {
        const Piece piece = Cap(height).piece();
        const Chart chart(piece.filling, piece.on_surface);
        const std::size_t n = at(piece.filling.boundary);
        std::vector<double> edges;
        for (std::size_t i = 0; i < n; ++i)
            edges.push_back((piece.on_surface.points[(i + 1) % n] - piece.on_surface.points[i]).norm());
        const double radius = std::accumulate(edges.begin(), edges.end(), 0.0) / (2 * std::numbers::pi);
        for (std::size_t i = 0; i < n; ++i) {
            const Vector2d &p = chart.positions()[i], &next = chart.positions()[(i + 1) % n];
            EXPECT_NEAR(p.norm(), radius, 1e-12);
            const double angle = std::atan2(p.x() * next.y() - p.y() * next.x(), p.dot(next));
            EXPECT_NEAR(angle * radius, edges[i], 1e-9);
        }
        for (std::size_t i = n; i < chart.positions().size(); ++i)
            EXPECT_LT(chart.positions()[i].norm(), 0.999 * radius);
        EXPECT_TRUE(geometry::shapes_of(piece.filling.quads, chart.positions()).valid);
    }
}

TEST(Chart, LiftGivesTheVerticesBack) {
    for (const double height : {low, high}) {
        const Cap cap(height);
        const Piece piece = cap.piece();
        const Chart chart(piece.filling, piece.on_surface);
        for (std::size_t v = 0; v < chart.positions().size(); ++v) {
            const surface::Spot spot = chart.lift(*cap.surface, chart.positions()[v]);
            EXPECT_LT((spot.point - piece.on_surface.points[v]).norm(), 1e-12) << height;
            EXPECT_GT(spot.normal.dot(piece.on_surface.normals[v]), 0.99);
        }
    }
}

TEST(Chart, LiftOfAPlaceInAQuadIsThePlaceOfTheSurfaceThere) {
    for (const double height : {low, high}) {
        const Cap cap(height);
        const Piece piece = cap.piece();
        const Chart chart(piece.filling, piece.on_surface);
        std::mt19937 random(5);
        for (const auto &q : piece.filling.quads) {
            const double a = adapt::samples::chance(random), b = (1 - a) * adapt::samples::chance(random),
                         c = 1 - a - b;
            const auto &flat = chart.positions();
            const auto &points = piece.on_surface.points;
            const Vector2d x = a * flat[at(q[0])] + b * flat[at(q[1])] + c * flat[at(q[2])];
            const Vector3d wanted = a * points[at(q[0])] + b * points[at(q[1])] + c * points[at(q[2])];
            const surface::Spot spot = chart.lift(*cap.surface, x);
            EXPECT_LT((spot.point - cap.surface->nearest(wanted).point).norm(), 1e-9);
            EXPECT_LT(cap.surface->nearest(spot.point).distance, 1e-12);
        }
    }
}

TEST(Chart, LiftOfAPlaceBesideTheChartIsOnTheSurfaceAndNotFarBeside) {
    for (const double height : {low, high}) {
        const Cap cap(height);
        const Piece piece = cap.piece();
        const Chart chart(piece.filling, piece.on_surface);
        double lowest = 1;
        for (int i = 0; i < piece.filling.boundary; ++i)
            lowest = std::min(lowest, piece.on_surface.points[at(i)].z());
        for (int i = 0; i < piece.filling.boundary; ++i)
            for (const double beside : {1e-12, 1e-6, 1e-3, 0.3}) {
                const surface::Spot spot = chart.lift(*cap.surface, (1 + beside) * chart.positions()[at(i)]);
                EXPECT_LT(cap.surface->nearest(spot.point).distance, 1e-12);
                EXPECT_LT((spot.point - piece.on_surface.points[at(i)]).norm(), 1e-11 + 3 * beside);
                EXPECT_GT(spot.point.z(), lowest - 0.03);
            }
    }
}

TEST(Chart, PlacesFillingsOfTheBoundary) {
    for (const double height : {low, high}) {
        const Cap cap(height);
        const Piece piece = cap.piece();
        const Chart chart(piece.filling, piece.on_surface);
        for (const Piece &filled : {piece, cap.other(6)}) {
            const geometry::Embedding placed = chart.place(filled.filling, {});
            EXPECT_TRUE(placed.valid) << height;
            ASSERT_EQ(placed.positions.size(), at(filled.filling.vertices));
            EXPECT_TRUE(geometry::shapes_of(filled.filling.quads, placed.positions).valid) << height;
            for (std::size_t i = 0; i < at(piece.filling.boundary); ++i)
                EXPECT_LT((placed.positions[i] - chart.positions()[i]).norm(), 1e-12);
        }
        if (height == high) { // where the old filling lies already
            const geometry::Points again = chart.place(piece.filling, {}).positions;
            EXPECT_EQ(again, chart.positions());
        }
    }
}

constexpr ChartKind kinds[] = {ChartKind::plane_or_circle, ChartKind::mean_value, ChartKind::conformal,
                               ChartKind::low_stretch};

geometry::Disk disk_of(const Piece &piece) {
    return {piece.filling.quads, piece.filling.boundary, piece.on_surface.points};
}

geometry::Points tutte_of(const Piece &piece) {
    std::vector<double> lengths;
    for (int i = 0; i < piece.filling.boundary; ++i)
        lengths.push_back(
            (piece.on_surface.points[at((i + 1) % piece.filling.boundary)] - piece.on_surface.points[at(i)])
                .norm());
    return geometry::embed_on_circle(piece.filling.quads, piece.filling.boundary, piece.filling.vertices,
                                     lengths);
}

TEST(Chart, IsTheMapThatIsAskedFor) {
    for (const double height : {low, high}) {
        const Piece piece = Cap(height).piece();
        const auto positions = [&](ChartKind kind) {
            return Chart(piece.filling, piece.on_surface, kind).positions();
        };
        EXPECT_EQ(positions(ChartKind::mean_value), geometry::mean_value_on_circle(disk_of(piece)));
        EXPECT_EQ(positions(ChartKind::conformal), geometry::conformal(disk_of(piece)));
        EXPECT_EQ(positions(ChartKind::low_stretch), geometry::low_stretch_on_circle(disk_of(piece)));
        for (const ChartKind kind : kinds)
            for (const ChartKind other : kinds)
                EXPECT_EQ(positions(kind) == positions(other), kind == other);
    }
}

TEST(Chart, OfEveryKindLiftsItsVerticesToWhereTheyWere) {
    for (const ChartKind kind : kinds)
        for (const double height : {low, high}) {
            const Cap cap(height);
            const Piece piece = cap.piece();
            const Chart chart(piece.filling, piece.on_surface, kind);
            EXPECT_TRUE(
                geometry::is_bijective(piece.filling.quads, piece.filling.boundary, chart.positions()));
            for (std::size_t v = 0; v < chart.positions().size(); ++v) {
                const surface::Spot spot = chart.lift(*cap.surface, chart.positions()[v]);
                EXPECT_LT((spot.point - piece.on_surface.points[v]).norm(), 1e-12) << height;
            }
        }
}

TEST(Chart, OfEveryKindPlacesOtherFillings) {
    for (const ChartKind kind : kinds)
        for (const double height : {low, high}) {
            const Cap cap(height);
            const Chart chart(cap.piece().filling, cap.piece().on_surface, kind);
            const fill::Filling other = cap.other(6).filling;
            const geometry::Embedding placed = chart.place(other, {});
            EXPECT_TRUE(placed.valid);
            EXPECT_TRUE(geometry::shapes_of(other.quads, placed.positions).valid);
            for (std::size_t i = 0; i < at(other.boundary); ++i)
                EXPECT_LT((placed.positions[i] - chart.positions()[i]).norm(), 1e-12);
        }
}

// A strip of a spiral ramp: laid in the plane without a circle, its second turn would lie on the first.
Piece ramp() {
    const mesh::QuadMesh mesh = mesh::grid(60, 3, [](double s, double t) {
        const double angle = -3 * std::numbers::pi * s;
        return Vector3d((2 + t) * std::cos(angle), (2 + t) * std::sin(angle), 0.9 * s);
    });
    const auto surface = reference::surface_of(mesh);
    const std::vector<int> faces = adapt::samples::all_faces(mesh);
    return {mesh, *surface, faces, patch::make_window(mesh, faces).loop};
}

TEST(Chart, GivesWayWhereAMapFolds) {
    const Piece piece = ramp();
    EXPECT_EQ(Chart(piece.filling, piece.on_surface, ChartKind::conformal).positions(),
              geometry::mean_value_on_circle(disk_of(piece)));
    EXPECT_EQ(Chart(piece.filling, piece.on_surface).positions(), tutte_of(piece));
    // Where two vertices are at one place only the connectivity helps.
    Piece pinched = Cap(high).piece();
    pinched.on_surface.points[at(pinched.filling.quads[0][0])] =
        pinched.on_surface.points[at(pinched.filling.quads[0][1])];
    for (const ChartKind kind : {ChartKind::mean_value, ChartKind::low_stretch})
        EXPECT_EQ(Chart(pinched.filling, pinched.on_surface, kind).positions(), tutte_of(pinched));
}

TEST(Chart, SaysWhereAFillingHasNoPlaceInThePlane) {
    const Piece piece = Cap(low).piece();
    const Chart chart(piece.filling, piece.on_surface);
    fill::Filling turned = piece.filling;
    for (auto &quad : turned.quads)
        std::swap(quad[1], quad[3]);
    EXPECT_FALSE(chart.place(turned, {}).valid);
}

} // namespace
} // namespace alphamst::refill
