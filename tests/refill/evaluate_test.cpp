#include "refill/evaluate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "patch/grow.h"
#include "reference/cross_field.h"
#include "reference/locate.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

constexpr ShapeBounds anything{-2, -2, 1e18, 1 << 20};

// One cavity and its judge.
struct Court {
    mesh::QuadMesh mesh;
    Patch patch;
    std::vector<int> buffer;
    Goal goal;
    Settings settings;
    reference::Reference reference;
    Trace trace;
    std::optional<Cavity> cavity;
    std::optional<BufferRing> ring;
    std::optional<Evaluator> evaluator;

    Court(mesh::QuadMesh of, std::vector<int> faces, double tolerance = 0) : mesh(std::move(of)) {
        const std::vector<int> all = patch::Growth(mesh).surround(faces, 2);
        buffer.assign(all.begin() + std::ssize(faces), all.end());
        patch.faces = std::move(faces);
        goal.faces = std::ssize(patch.faces);
        goal.any_count = true;
        reference = reference::reference_of(mesh);
        if (tolerance > 0)
            reference.surface_distance =
                reference::surface_distance_of(mesh, *reference.surface, mesh.n_faces(), tolerance);
    }
    Court(const Court &) = delete;
    Court &operator=(const Court &) = delete;

    void open(bool stays) {
        cavity.emplace(mesh, patch, goal, settings, reference);
        ring.emplace(mesh, *cavity, buffer, stays);
        evaluator.emplace(mesh, *cavity, *ring, settings, trace);
    }
    PlacedFilling old() const { return {cavity->old, {}}; }
    std::optional<Evaluation> judge(const PlacedFilling &shape, const ShapeBounds &bounds) {
        return evaluator->evaluate(shape, bounds);
    }
    // Nothing but this was the reason, and only so many times.
    void expect_refused(Refused reason, int times) const {
        EXPECT_EQ(trace.of(reason), times);
        EXPECT_EQ(std::accumulate(trace.refused.begin(), trace.refused.end(), 0), times)
            << reason_names[at(static_cast<int>(reason))];
    }
};

// Faces of a sphere around one of its poles.
std::vector<int> cap(const mesh::QuadMesh &sphere, double radius) {
    return patch::ball(sphere, {0, 0, 1}, radius, std::vector<char>(at(sphere.n_faces()), 0));
}

// Two faces side by side, cut along the diagonal of their six corners: one of them has three in a line.
PlacedFilling without_a_shape(const Cavity &cavity, int from) {
    const auto &loop = cavity.window.loop;
    const auto k = static_cast<int>(std::find(loop.begin(), loop.end(), from) - loop.begin());
    const auto name = [&](int i) { return (k + i) % 6; };
    return {{6, 6, {{name(0), name(1), name(2), name(3)}, {name(0), name(3), name(4), name(5)}}}, {}};
}

TEST(Trace, CountsByReason) {
    Trace trace;
    EXPECT_FALSE(trace.refuse(Refused::edge));
    trace.refuse(Refused::distance);
    trace.refuse(Refused::distance);
    EXPECT_EQ(trace.of(Refused::edge), 1);
    EXPECT_EQ(trace.of(Refused::distance), 2);
    EXPECT_EQ(trace.of(Refused::numbers), 0);
    EXPECT_STREQ(reason_names[static_cast<int>(Refused::edge)], "double edge");
}

TEST(Evaluator, TakesTheFillingThatIsThere) {
    Court court(grid(6, 6), block(6, 1, 1, 4, 4));
    court.open(true);
    EXPECT_EQ(court.evaluator->before().scaled_jacobian, 1);
    EXPECT_TRUE(court.evaluator->fits(court.cavity->old));
    const auto evaluation = court.judge(court.old(), {0.99, 0.99, 0, 0});
    ASSERT_TRUE(evaluation);
    EXPECT_EQ(court.trace.candidates, 1);
    const Replacement &replacement = evaluation->replacement;
    EXPECT_EQ(replacement.window.faces, court.patch.faces);
    EXPECT_EQ(replacement.filling.quads, court.cavity->old.quads);
    ASSERT_EQ(replacement.points.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT((replacement.points[i] - court.mesh.point(replacement.window.interior[i])).norm(), 1e-9);
    EXPECT_TRUE(replacement.surface_triangles.empty());
    EXPECT_TRUE(replacement.moved.vertices.empty());
    EXPECT_TRUE(replacement.owners.empty());
    EXPECT_EQ(replacement.singular_change, 0);
}

TEST(Evaluator, RefusesADoubleEdge) {
    std::vector<int> faces = block(5, 1, 1, 4, 3);
    std::erase(faces, 2 * 5 + 2);
    Court court(grid(5, 4), faces);
    court.open(true);
    const auto &loop = court.cavity->window.loop;
    const auto place = [&](int v) {
        return static_cast<int>(std::find(loop.begin(), loop.end(), v) - loop.begin());
    };
    fill::Filling filling = court.cavity->old;
    filling.quads.push_back({place(14), place(15), place(21), place(20)}); // the notch
    EXPECT_FALSE(court.evaluator->fits(filling));
    court.expect_refused(Refused::edge, 1);
    EXPECT_TRUE(court.evaluator->fits(court.cavity->old));
    EXPECT_EQ(court.trace.candidates, 0); // none was laid out
}

TEST(Evaluator, RefusesWhatHasNoShape) {
    Court court(grid(6, 6), block(6, 2, 2, 4, 3));
    for (const bool stays : {true, false}) {
        court.trace = {};
        court.open(stays);
        EXPECT_FALSE(court.judge(without_a_shape(*court.cavity, 2 * 7 + 2), anything));
        EXPECT_EQ(court.trace.candidates, 1);
        court.expect_refused(Refused::embedding, 1);
    }
}

TEST(Evaluator, RefusesAgainWhereItGotStuckBefore) {
    Court court(grid(8, 8), block(8, 1, 1, 7, 7));
    court.open(true);
    // A vertex of two faces in a face at the boundary: one of them always has 180 degrees.
    fill::Filling filling = court.cavity->old;
    const auto [a, b, c, d] = filling.quads[2];
    filling.quads[2] = {a, b, c, filling.vertices};
    filling.quads.push_back({a, filling.vertices, c, d});
    ++filling.vertices;
    ASSERT_TRUE(court.evaluator->fits(filling));
    EXPECT_FALSE(court.judge({filling, {}}, anything));
    court.expect_refused(Refused::embedding, 1);
    EXPECT_FALSE(court.evaluator->fits(filling));
    EXPECT_EQ(court.trace.of(Refused::obstacle), 1);
    EXPECT_TRUE(court.evaluator->fits(court.cavity->old));
}

TEST(Evaluator, RefusesAShapeBelowTheBounds) {
    Court court(adapt::samples::unstructured(8, 2), {});
    court.patch.faces = patch::ball(court.mesh, {4, 4, 0}, 2.5, std::vector<char>(64, 0));
    court.open(true);
    const ShapeBounds there = court.judge(court.old(), anything).value().shape;
    EXPECT_TRUE(court.judge(court.old(), there));
    int refused = 0;
    for (const ShapeBounds &more : {ShapeBounds{1.1, -2, 1e18, 9}, ShapeBounds{-2, 1.1, 1e18, 9},
                                    ShapeBounds{-2, -2, there.poor - 1, 9}}) {
        EXPECT_FALSE(court.judge(court.old(), more));
        court.expect_refused(Refused::shape, ++refused);
    }
    EXPECT_EQ(court.trace.candidates, 5);
}

// A loop with a vertex pulled aside is mended only together with the faces around.
TEST(Evaluator, MovesTheBufferOnlyWhereTheFillingAloneIsNoGood) {
    mesh::QuadMesh mesh = grid(10, 10);
    mesh.set_point(4 * 11 + 4, OpenMesh::Vec3d(4.4, 4.3, 0));
    Court court(std::move(mesh), block(10, 4, 4, 7, 7));
    court.open(false);
    const ShapeBounds before = court.evaluator->before();
    EXPECT_LT(before.scaled_jacobian, 0.9);
    const auto kept = court.judge(court.old(), {0.3, 0.1, before.poor + 5, 0});
    ASSERT_TRUE(kept);
    EXPECT_TRUE(kept->replacement.moved.vertices.empty());
    const ShapeBounds more{0.95, 0.5, 0, 0};
    const auto mended = court.judge(court.old(), more);
    ASSERT_TRUE(mended);
    EXPECT_EQ(mended->replacement.moved.vertices.size(), 32u);
    EXPECT_TRUE(reaches(mended->shape, more));
    EXPECT_EQ(mended->replacement.points.size(), 4u); // without those of the buffer
    court.open(true);
    EXPECT_FALSE(court.judge(court.old(), more));
}

TEST(Evaluator, RefusesWhatLeavesTheSurface) {
    Court court(mesh::sphere(6), {}, 0.5);
    court.patch.faces = cap(court.mesh, 0.9);
    court.goal.any_count = false;
    court.goal.faces = std::ssize(court.patch.faces) - 3;
    court.open(true);
    const PlacedFilling coarser = court.cavity->generators().at(0)().at(0).build();
    ASSERT_TRUE(court.judge(coarser, anything));
    court.expect_refused(Refused::distance, 0);
    const double near = court.reference.surface_distance->tolerance();
    court.reference.surface_distance->set_tolerance(1e-6);
    court.open(true);
    EXPECT_FALSE(court.judge(coarser, anything));
    court.expect_refused(Refused::distance, 1);
    court.reference.surface_distance->set_tolerance(near);
    court.open(true);
    EXPECT_TRUE(court.judge(coarser, anything));
}

TEST(Evaluator, GivesSamplesOfTheSurfaceToTheNewQuads) {
    Court court(mesh::sphere(6), {}, 0.5);
    court.patch.faces = cap(court.mesh, 0.9);
    court.goal.any_count = false;
    court.goal.faces = std::ssize(court.patch.faces) + 4;
    court.open(true);
    const auto evaluation = court.judge(court.cavity->generators().at(0)().at(0).build(), anything);
    ASSERT_TRUE(evaluation);
    const Replacement &replacement = evaluation->replacement;
    std::vector<int> before, after;
    for (const int f : court.patch.faces)
        for (const int sample : court.reference.surface_distance->samples(f))
            before.push_back(sample);
    for (const auto &owner : replacement.owners) {
        after.push_back(owner.sample);
        EXPECT_LE(owner.distance, court.reference.surface_distance->allowed(owner.sample));
        EXPECT_LT(owner.quad, std::ssize(replacement.filling.quads) + std::ssize(court.buffer));
    }
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(after, before);
    ASSERT_EQ(replacement.surface_triangles.size(), replacement.points.size());
    for (const OpenMesh::Vec3d &p : replacement.points)
        EXPECT_LT(court.cavity->surface().nearest({p[0], p[1], p[2]}).distance, 1e-12);
}

// A roof with its ridge a feature; a quad beside it is turned over.
TEST(Evaluator, RefusesWhatIsInvertedAcrossFeatures) {
    mesh::QuadMesh roof = mesh::grid(8, 6, [](double s, double t) {
        return Eigen::Vector3d(8 * s, 6 * t, 4 - std::abs(8 * s - 4) + 0.05 * std::sin(6 * t));
    });
    for (int j = 0; j < 6; ++j)
        roof.edge_flags[at(roof.find_edge(9 * j + 4, 9 * j + 13))] = mesh::feature;
    Court court(std::move(roof), block(8, 4, 2, 6, 4));
    court.open(false);
    ASSERT_TRUE(court.cavity->curved());
    EXPECT_EQ(court.evaluator->inverted_at_features(), 0);
    PlacedFilling shape = court.cavity->present().value().build();
    EXPECT_TRUE(court.judge(shape, anything));
    std::swap(shape.filling.quads[0][1], shape.filling.quads[0][3]);
    EXPECT_FALSE(court.judge(shape, anything));
    court.expect_refused(Refused::feature, 1);
}

TEST(Evaluator, TellsHowFarEdgesAreFromTheCrossField) {
    Court court(grid(6, 6), block(6, 1, 1, 4, 4));
    court.open(true);
    EXPECT_EQ(court.judge(court.old(), anything).value().replacement.alignment_error, 0); // there is none
    std::vector<double> values;
    for (int f = 0; f < court.mesh.n_faces(); ++f)
        values.insert(values.end(), {std::cos(0.3), std::sin(0.3), 0});
    court.mesh.fields.set(std::make_shared<const mesh::Field>(
        mesh::Field{Entity::face, "cross", 3, mesh::Carry::drop, std::move(values)}));
    const reference::CrossField field(court.mesh);
    court.reference.cross_field = &field;
    court.open(true);
    EXPECT_NEAR(court.judge(court.old(), anything).value().replacement.alignment_error,
                0.3 * 180 / std::numbers::pi, 1e-6);
}

} // namespace
} // namespace alphamst::refill
