#include "refill/choice.h"

#include <gtest/gtest.h>

#include <utility>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "reference/cross_field.h"
#include "reference/statistics.h"
#include "refill/patch.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

// The choice for one patch.
struct Choosing {
    mesh::QuadMesh mesh;
    Patch patch;
    Goal goal;
    Settings settings;
    reference::Reference reference;
    Trace trace;

    Choosing(mesh::QuadMesh of, std::vector<int> faces, double alpha) : mesh(std::move(of)) {
        patch.faces = std::move(faces);
        goal.faces = wanted_faces(alpha, patch.faces.size());
        goal.keep_quality = alpha == 1;
        goal.sizes = true;
        reference = reference::reference_of(std::as_const(mesh), std::vector{patch});
    }
    Chosen run() {
        const Cavity cavity(mesh, patch, goal, settings, reference);
        const BufferRing buffer(mesh, cavity, {}, true);
        Evaluator evaluator(mesh, cavity, buffer, settings, trace);
        return FillingChoice(cavity, evaluator, trace, goal, settings).run();
    }
};

Choosing round(double alpha, unsigned seed) {
    const mesh::QuadMesh mesh = adapt::samples::unstructured(18, seed);
    const std::vector<char> none(at(mesh.n_faces()), 0);
    return {mesh, patch::repair(mesh, patch::ball(mesh, {9, 9, 0}, 6, none), none), alpha};
}

// A web of rings around a small core has the fewest singular vertices, and faces of 2^-29 of the wanted size.
TEST(Choice, HasFewSingularitiesAndTheSizesThatAlphaAsksFor) {
    for (const unsigned seed : {1U, 2U, 3U})
        for (const double alpha : {0.7, 1.5, 2.0, 4.0}) {
            Choosing of = round(alpha, seed);
            const Chosen chosen = of.run();
            ASSERT_TRUE(chosen.evaluation);
            EXPECT_EQ(std::ssize(chosen.evaluation->replacement.filling.quads), of.goal.faces);
            EXPECT_LT(chosen.evaluation->size_error.rms, 0.9) << alpha;
            EXPECT_GT(chosen.evaluation->size_error.least, -3) << alpha;
            EXPECT_LT(reference::singular(chosen.valences), 30) << alpha;
        }
}

TEST(Choice, NeverHasMoreSingularitiesOrWorseShapesWhereTheCountStays) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        Choosing of = round(1, seed);
        const Cavity cavity(of.mesh, of.patch, of.goal, of.settings, of.reference);
        const Chosen chosen = of.run();
        if (!chosen.evaluation)
            continue;
        EXPECT_LE(reference::singular(chosen.valences), reference::singular(cavity.valences(cavity.old)));
        EXPECT_GE(chosen.evaluation->shape.scaled_jacobian, cavity.old_quality);
    }
}

TEST(Choice, TakesNothingWhereNothingIsGained) {
    Choosing of(grid(10, 10), block(10, 1, 1, 9, 9), 1);
    EXPECT_FALSE(of.run().evaluation);
}

TEST(Choice, LiesAlongTheCrossField) {
    double sum = 0, sum_along = 0;
    for (const double alpha : {0.7, 1.4, 2.0, 2.5}) {
        mesh::QuadMesh sphere = mesh::sphere(8);
        const std::vector<int> faces =
            patch::ball(sphere, {0, 0, 1}, 0.9, std::vector<char>(at(sphere.n_faces()), 0));
        Choosing of(std::move(sphere), faces, alpha);
        of.reference = reference::reference_of(of.mesh);
        const reference::CrossField cross_field(of.mesh);
        const auto error = [&](const Chosen &chosen) {
            std::vector<geometry::Quad> quads;
            const Replacement &taken = chosen.evaluation->replacement;
            for (const auto &q : taken.filling.quads) {
                quads.push_back({});
                for (std::size_t k = 0; k < 4; ++k) {
                    const auto v = at(q[k]);
                    const OpenMesh::Vec3d p = v < taken.window.loop.size()
                                                  ? of.mesh.point(taken.window.loop[v])
                                                  : taken.points[v - taken.window.loop.size()];
                    quads.back()[k] = {p[0], p[1], p[2]};
                }
            }
            return cross_field.alignment_error(quads);
        };
        const Chosen any = of.run();
        of.reference.cross_field = &cross_field;
        const Chosen along = of.run();
        ASSERT_TRUE(any.evaluation && along.evaluation);
        sum += error(any);
        sum_along += error(along);
    }
    EXPECT_LT(sum_along, 0.95 * sum);
}

TEST(Choice, SaysWhatWasInTheWay) {
    Choosing coarse(grid(10, 10), block(10, 1, 1, 9, 9), 0.1);
    try {
        coarse.run();
        FAIL();
    } catch (const Refusal &refusal) {
        EXPECT_EQ(refusal.fault, Fault::no_filling);
        EXPECT_NE(refusal.text.find("32 edges needs at least 15"), std::string::npos) << refusal.text;
    }
    Choosing perfect = round(1.5, 1);
    perfect.settings.min_quality = 1;
    try {
        perfect.run();
        FAIL();
    } catch (const Refusal &refusal) {
        EXPECT_EQ(refusal.fault, Fault::geometry);
        EXPECT_NE(refusal.text.find("could be given a valid shape"), std::string::npos) << refusal.text;
    }
}

} // namespace
} // namespace alphamst::refill
