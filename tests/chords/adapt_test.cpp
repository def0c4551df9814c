#include "chords/edit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "chord/meshes.h"
#include "chord/table.h"
#include "mesh/curved.h"

namespace alphamst::chords {
namespace {

using namespace adapt::samples;

const Settings settings;

std::int64_t singular(const mesh::QuadMesh &mesh) {
    return static_cast<std::int64_t>(mesh.singularities().size());
}
TEST(AdaptChords, RemovesOrSplitsWholeChordsTowardsTheCount) {
    const mesh::QuadMesh start = chord::samples::sphere(8);
    for (const double alpha : {0.3, 0.6, 1.5, 3.0}) {
        mesh::QuadMesh mesh = start;
        const Outcome outcome = adapt_chords(mesh, alpha, 1 << 20, {}, settings, silent);
        mesh.check();
        const std::int64_t wanted = std::llround(alpha * start.n_faces());
        EXPECT_EQ(outcome.faces_wanted, wanted);
        EXPECT_EQ(outcome.faces_after, mesh.n_faces());
        EXPECT_EQ(singular(mesh), 8);
        // No other chord fits, and the number is not passed.
        const std::int64_t missing = alpha < 1 ? mesh.n_faces() - wanted : wanted - mesh.n_faces();
        EXPECT_GE(missing, 0);
        for (const chord::Row &row : chord::table(mesh, {}))
            EXPECT_TRUE(row.reasons != 0 || row.length > missing) << alpha << ": " << missing;
    }
}

// A torus of 24 by 12 faces of which the rows 5 and 6 are narrow: they go, though others are as short.
TEST(ApproachByChords, TheNarrowestGoFirst) {
    const auto place = [](double t) { // [row boundary / 24]
        const double row = 24 * t;
        return (row <= 5 ? row : row <= 7 ? 5 + 0.2 * (row - 5) : row - 1.6) / 22.4;
    };
    const auto at_angles = [&](double s, double t) {
        const double a = 2 * std::numbers::pi * place(s), b = 2 * std::numbers::pi * t;
        return Eigen::Vector3d((3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b));
    };
    const mesh::QuadMesh start = mesh::grid(24, 12, at_angles, true, true);
    ASSERT_EQ(start.n_faces(), 288);
    const auto narrowest = [](const mesh::QuadMesh &mesh) {
        double least = 10;
        for (int e = 0; e < mesh.n_edges(); ++e) {
            const auto [v, w] = mesh.edge_vertices(e);
            least = std::min(least, (mesh.point(v) - mesh.point(w)).norm());
        }
        return least;
    };
    const double before = narrowest(start);
    mesh::QuadMesh mesh = start;
    approach_by_chords(mesh, 288 - 12, {}, Order::narrowest, silent);
    EXPECT_EQ(mesh.n_faces(), 288 - 12);
    EXPECT_NEAR(narrowest(mesh), 1.5 * before, 0.1 * before); // the other one, wider by half of it
    approach_by_chords(mesh, 288 - 24, {}, Order::narrowest, silent);
    EXPECT_EQ(mesh.n_faces(), 288 - 24);
    EXPECT_GT(narrowest(mesh), 2.3 * before);
}

TEST(AdaptChords, RemovesEveryChordThatCanGo) {
    mesh::QuadMesh mesh = chord::samples::scrambled(grid(20, 20, 3), 60, 4);
    relax(mesh, 100);
    adapt_chords(mesh, 1e-9, 1 << 20, {true}, settings, silent);
    mesh.check();
    EXPECT_LT(mesh.n_faces(), 400);
    mesh = chord::samples::sphere(12);
    adapt_chords(mesh, 1e-9, 1 << 20, {}, settings, silent);
    EXPECT_LE(mesh.n_faces(), 24);
}
} // namespace
} // namespace alphamst::chords
