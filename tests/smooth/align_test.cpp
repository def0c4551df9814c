#include "smooth/align.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "adapt/eared.h"
#include "adapt/run.h"
#include "mesh/cross_field.h"
#include "patch/patches.h"
#include "reference/surface_of.h"
#include "refill/window.h"

namespace alphamst::smooth {
namespace {

using namespace adapt::samples;

// Mean angle in degrees between the sides of the faces and the field there.
double angle(const mesh::QuadMesh &mesh, const reference::CrossField &cross_field) {
    std::vector<double> values;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const geometry::Quad corners = reference::quad_of(mesh, f);
        const Eigen::Vector3d cross = cross_field.at((corners[0] + corners[1] + corners[2] + corners[3]) / 4);
        values.insert(values.end(), cross.data(), cross.data() + 3);
    }
    return mesh::alignment(mesh, values);
}

mesh::QuadMesh adapted(mesh::QuadMesh mesh, bool align) {
    Settings settings;
    settings.align = align;
    const Outcome outcome = adapt::adapt_whole(mesh, 0.7, settings, silent);
    EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
    EXPECT_GT(outcome.quality_after, 0.1);
    return mesh;
}

TEST(Align, WholeMeshesFollowTheFieldOfTheirCurvature) {
    const mesh::QuadMesh before = eared(4);
    const reference::CrossField cross_field(before);
    const mesh::QuadMesh plain = adapted(before, false), aligned = adapted(before, true);
    EXPECT_LT(angle(aligned, cross_field), 0.7 * angle(plain, cross_field));
    EXPECT_EQ(plain.n_faces(), aligned.n_faces());
}

TEST(Align, StrayingIsTheMeanAngle) {
    const mesh::QuadMesh mesh = eared(3);
    const reference::CrossField cross_field(mesh);
    std::vector<geometry::Quad> quads;
    for (int f = 0; f < mesh.n_faces(); ++f)
        quads.push_back(reference::quad_of(mesh, f));
    EXPECT_NEAR(cross_field.alignment_error(quads), angle(mesh, cross_field), 1e-9);
    EXPECT_EQ(cross_field.alignment_error({}), 0);
}

// One window after the other: whatever comes back has no more singular vertices and follows the field better.
TEST(Align, WindowsTurnTowardsTheField) {
    mesh::QuadMesh mesh = adapted(eared(3), false);
    const reference::CrossField cross_field(mesh);
    reference::Reference reference = reference::reference_of(mesh);
    reference.cross_field = &cross_field;
    refill::Goal goal;
    goal.any_count = goal.forbid_old = goal.turn = true;
    goal.most_added = 0;
    Settings settings;
    settings.patient = false;
    int turned = 0;
    for (int v = 0; v < mesh.n_vertices(); v += 3) {
        refill::Place place;
        place.faces = patch::rings(mesh, v, 3, {});
        goal.faces = static_cast<std::int64_t>(place.faces.size());
        std::vector<geometry::Quad> before;
        for (const int f : place.faces)
            before.push_back(reference::quad_of(mesh, f));
        refill::Trace trace;
        const auto found =
            refill::refill_window(mesh, place, goal, {0.1, 0.1, 3, 0}, settings, reference, trace);
        if (!found)
            continue;
        ++turned;
        EXPECT_LE(found->singular_change, 0);
        EXPECT_LT(found->alignment_error, cross_field.alignment_error(before) - 2);
    }
    EXPECT_GT(turned, 3);
}

TEST(Align, OrTheFieldThatTheCallerSets) {
    mesh::QuadMesh mesh = eared(3);
    auto field = std::make_shared<mesh::Field>();
    field->entity = Entity::face;
    field->name = "cross";
    field->components = 3;
    for (int f = 0; f < mesh.n_faces(); ++f)
        field->values.insert(field->values.end(), {0.0, 0.0, f + 1.0});
    mesh.fields.set(field);
    const reference::CrossField cross_field(mesh);
    for (int f = 0; f < mesh.n_faces(); f += 7) {
        const geometry::Quad corners = reference::quad_of(mesh, f);
        const Eigen::Vector3d near = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
        EXPECT_EQ(cross_field.at(near).z(), f + 1.0);
    }
}

// Farthest that a vertex of the mesh before is from the one after, in wanted edges.
double farthest(double alpha, double tolerance, std::uint64_t seed) {
    const mesh::QuadMesh before = eared(3);
    mesh::QuadMesh mesh = before;
    Settings settings;
    settings.seed = seed;
    settings.tolerance = tolerance;
    const Outcome outcome = adapt::adapt_whole(mesh, alpha, settings, silent);
    EXPECT_EQ(outcome.faces_after, outcome.faces_wanted);
    std::vector<int> all(static_cast<std::size_t>(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    const reference::FaceTree faces(mesh, all);
    double most = 0;
    for (int v = 0; v < before.n_vertices(); ++v)
        most = std::max(most, faces.nearest(reference::point_of(before, v)).spot.distance);
    return std::sqrt(most * static_cast<double>(mesh.n_faces()) / reference::surface_of(before)->area());
}

TEST(Tolerance, KeepsTheSurfaceNearTheMesh) {
    double without = 0;
    for (const std::uint64_t seed : {0, 1, 2, 3, 4}) {
        EXPECT_LE(farthest(1, 0.2, seed), 0.2) << seed; // no faces are missing for which it would be eased
        EXPECT_LE(farthest(0.2, 0.5, seed), 0.5) << seed;
        without = std::max(without, farthest(0.2, 20, seed));
    }
    EXPECT_GT(without, 0.55);
}

} // namespace
} // namespace alphamst::smooth
