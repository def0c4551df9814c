#include "geometry/rail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "geometry/drape.h"
#include "geometry/relax.h"
#include "geometry/unfold.h"
#include "mesh/curved.h"
#include "mesh/reference.h"

namespace alphamst::geometry {
namespace {

using Eigen::Vector3d;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr int across = 4, along = 8; // faces; the ridge is in the middle

int vertex(int i, int j) { return j * (across + 1) + i; }

// A roof over [-2, 2] x [0, 8], each of its two halves turned down so many degrees; the vertices of the ridge
// are bunched at its start, the more the higher the power.
struct Roof {
    mesh::QuadMesh mesh;
    std::shared_ptr<const surface::Surface> surface;
    Drape drape;
    std::vector<char> fixed;
    std::vector<Rail> rails;

    Roof(double degrees, double power) : mesh(mesh::grid(across, along, place(degrees))) {
        surface = mesh::surface_of(mesh);
        fixed.assign(at(mesh.n_vertices()), 1);
        rails.resize(fixed.size());
        const surface::Line ridge{{0, -1, 0}, {0, 10, 0}};
        for (int j = 0; j <= along; ++j)
            for (int i = 0; i <= across; ++i) {
                const auto &p = mesh.point(vertex(i, j));
                const double y = i == across / 2 ? along * std::pow(p[1] / along, power) : p[1];
                drape.add(surface->nearest({p[0], y, p[2]}));
                if (i != across / 2 || j == 0 || j == along)
                    continue;
                fixed[at(vertex(i, j))] = 0;
                rails[at(vertex(i, j))] = {ridge, {vertex(i, j - 1), vertex(i, j + 1)}};
            }
    }
    static std::function<Vector3d(double, double)> place(double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return [angle](double s, double t) {
            const double x = across * (s - 0.5);
            return Vector3d(x * std::cos(angle), along * t, -std::abs(x) * std::sin(angle));
        };
    }
    Judgement improve(int steps = 20) {
        EmbedOptions options;
        options.steps = steps;
        options.rails = rails;
        return geometry::improve(*surface, mesh.faces(), fixed, drape, options);
    }
    const Vector3d &ridge(int j) const { return drape.points[at(vertex(across / 2, j))]; }
};

TEST(Rail, VerticesOffCentreSlideToTheCentre) {
    for (const double degrees : {0.0, 20.0, 45.0, 70.0})
        for (const double power : {1.5, 3.0}) {
            Roof roof(degrees, power);
            const Roof before = roof;
            const Judgement judgement = roof.improve(200);
            EXPECT_GT(std::abs(before.ridge(4).y() - 4), 1) << degrees;
            for (int j = 0; j <= along; ++j) {
                EXPECT_NEAR(roof.ridge(j).y(), j, 0.1) << degrees << " " << j;
                EXPECT_EQ(roof.ridge(j).x(), 0);
                EXPECT_EQ(roof.ridge(j).z(), 0);
            }
            EXPECT_TRUE(judgement.valid ||
                        degrees == 70); // against the other side's normals it is hard to be
            for (std::size_t v = 0; v < roof.fixed.size(); ++v)
                if (roof.fixed[v]) {
                    EXPECT_EQ(roof.drape.points[v], before.drape.points[v]);
                }
        }
}

// Whatever the shapes want: with hardly any room, or with a neighbour that is in the way.
TEST(Rail, VerticesNeverPassTheirNeighbours) {
    for (int steps = 1; steps < 30; ++steps) {
        Roof roof(45, 8);
        roof.improve(steps);
        for (int j = 1; j <= along; ++j)
            EXPECT_LT(roof.ridge(j - 1).y(), roof.ridge(j).y());
    }
    Roof roof(30, 1);
    for (int j = 1; j < along; ++j)
        if (j != 4) {
            roof.fixed[at(vertex(2, j))] = 1;
            roof.rails[at(vertex(2, j))] = {};
        }
    // The neighbours, fixed, are where they should not be: the quads there are turned over.
    roof.drape.put(vertex(2, 3), roof.surface->nearest({0, 5.5, 0}));
    roof.drape.put(vertex(2, 4), roof.surface->nearest({0, 5.6, 0}));
    roof.drape.put(vertex(2, 5), roof.surface->nearest({0, 5.7, 0}));
    roof.improve();
    EXPECT_GT(roof.ridge(4).y(), 5.5);
    EXPECT_LT(roof.ridge(4).y(), 5.7);
}

TEST(Rail, HoldsWhatIsStrictlyBetween) {
    const std::vector<Vector3d> points{{2, 0, 0}, {4, 0, 0}};
    const surface::Line line{{0, 0, 0}, {10, 0, 0}};
    for (const Rail &rail : {Rail{line, {0, 1}}, Rail{line, {1, 0}}}) {
        EXPECT_TRUE(rail);
        EXPECT_TRUE(rail.holds({3, 0, 0}, points));
        EXPECT_FALSE(rail.holds({2, 0, 0}, points));
        EXPECT_FALSE(rail.holds({4, 0, 0}, points));
        EXPECT_FALSE(rail.holds({5, 0, 0}, points));
        EXPECT_FALSE(rail.holds({1, 0, 0}, points));
    }
    EXPECT_FALSE(Rail{});
}

TEST(Unfold, LaysASharpCreaseFlat) {
    for (const double degrees : {10.0, 60.0, 89.0}) {
        const Roof roof(degrees, 2);
        const Stars stars(roof.mesh.faces(), roof.mesh.n_vertices());
        const int v = vertex(2, 4);
        std::vector<Sector> sectors;
        Points flat;
        unfold(stars.at(v), roof.drape.points, v, roof.rails[at(v)], sectors, flat);
        ASSERT_EQ(sectors.size(), 4u);
        EXPECT_EQ(flat[0], Eigen::Vector2d(0, 0));
        const double here = roof.ridge(4).y();
        for (const Sector &s : sectors) {
            const auto &quad = roof.mesh.faces()[at(s.quad)];
            const auto k = static_cast<std::size_t>(std::find(quad.begin(), quad.end(), v) - quad.begin());
            std::size_t step = 1;
            for (const int point : {s.next, s.opposite, s.previous}) {
                const int w = quad[(k + step++) % 4];
                // Ahead is to the right, so that the columns to the right of the ridge are below.
                EXPECT_NEAR(flat[at(point)].x(), roof.drape.points[at(w)].y() - here, 1e-12);
                EXPECT_NEAR(flat[at(point)].y(), across / 2 - w % (across + 1), 1e-12);
            }
        }
    }
}

TEST(Unfold, NeedsAllQuadsAround) {
    const Roof roof(30, 1);
    const Quads some = Quads(roof.mesh.faces()).subspan(0, 4 * across - 2); // not both behind row 3
    const Stars stars(some, roof.mesh.n_vertices());
    std::vector<Sector> sectors;
    Points flat;
    unfold(stars.at(vertex(2, 2)), roof.drape.points, vertex(2, 2), roof.rails[at(vertex(2, 2))], sectors,
           flat);
    EXPECT_EQ(sectors.size(), 4u);
    unfold(stars.at(vertex(2, 3)), roof.drape.points, vertex(2, 3), roof.rails[at(vertex(2, 3))], sectors,
           flat);
    EXPECT_TRUE(sectors.empty());
    const Rail wrong{roof.rails[at(vertex(2, 2))].line, {vertex(2, 1), vertex(2, 4)}}; // no neighbour
    unfold(stars.at(vertex(2, 2)), roof.drape.points, vertex(2, 2), wrong, sectors, flat);
    EXPECT_TRUE(sectors.empty());
}

// Four quads around the origin; the vertex is pushed off, and the best place is not on its line.
TEST(Freedom, AStepOnALineStaysOnItAndLowersTheEnergy) {
    const std::vector<std::array<int, 4>> quads{{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}, {0, 7, 8, 1}};
    const Points start{{0.3, 0.2}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const Stars stars(quads, 9);
    const std::vector<double> area(4, 1);
    const Barrier barrier{.theta = 0.6, .area = area};
    Points on_line = start, in_plane = start, sharp = start;
    for (int i = 0; i < 20; ++i) {
        relax(barrier, stars.at(0), on_line, 0, no_floor, Freedom::line);
        relax(barrier, stars.at(0), in_plane, 0, no_floor);
        sharpen(stars.at(0), sharp, 0, 0, 0, Freedom::line);
    }
    EXPECT_NEAR(in_plane[0].norm(), 0, 1e-3);
    for (const Points *points : {&on_line, &sharp}) {
        EXPECT_EQ((*points)[0].y(), 0.2);
        EXPECT_NEAR((*points)[0].x(), 0, 1e-3);
    }
}

} // namespace
} // namespace alphamst::geometry
