#include "refill/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "adapt/run.h"
#include "index.h"
#include "mesh/curved.h"
#include "mesh/grids.h"
#include "reference/statistics.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;
using adapt::samples::grid;

// One patch of a mesh, and what is asked for.
struct Case {
    mesh::QuadMesh mesh;
    Patch patch;
    Goal goal;
    Settings settings;
    reference::Reference reference;

    Case(mesh::QuadMesh of, std::vector<int> faces, double alpha) : mesh(std::move(of)) {
        patch.faces = std::move(faces);
        goal.faces = wanted_faces(alpha, patch.faces.size());
        goal.keep_quality = alpha == 1;
        settings.node_limit = 200;
        reference = reference::reference_of(std::as_const(mesh), std::vector{patch});
    }
    Proposal propose() const { return refill::propose(mesh, patch, goal, settings, reference); }
};

Case irregular(double alpha, unsigned seed = 4) {
    const mesh::QuadMesh mesh = adapt::samples::unstructured(14, seed);
    const std::vector<char> none(at(mesh.n_faces()), 0);
    return {mesh, patch::repair(mesh, patch::ball(mesh, {7, 7, 0}, 4.5, none), none), alpha};
}

void expect_fault(const Case &of, Fault fault, const std::string &text) {
    const Proposal proposal = of.propose();
    EXPECT_EQ(proposal.outcome.fault, fault);
    EXPECT_NE(proposal.outcome.text.find(text), std::string::npos) << proposal.outcome.text;
    EXPECT_EQ(proposal.outcome.faces_after, proposal.outcome.faces_before);
    EXPECT_FALSE(proposal.unchanged);
}

TEST(WantedFaces, AreRoundedHalfAwayFromZero) {
    EXPECT_EQ(wanted_faces(0.5, 5), 3);
    EXPECT_EQ(wanted_faces(1.5, 3), 5);
    EXPECT_EQ(wanted_faces(0.1, 4), 0);
    EXPECT_EQ(wanted_faces(1, 123456789), 123456789);
    EXPECT_EQ(wanted_faces(1e300, 10), 4000000000000000000);
}

TEST(Propose, GivesTheWantedFacesAndLeavesAllOutside) {
    for (const double alpha : {0.7, 1.6}) {
        Case of = irregular(alpha);
        const mesh::QuadMesh before = of.mesh;
        const Proposal proposal = of.propose();
        ASSERT_FALSE(proposal.outcome.fault) << proposal.outcome.text;
        EXPECT_EQ(of.mesh.checksum(), before.checksum()); // until the commit
        const auto replaced = commit(of.mesh, proposal.replacement);
        EXPECT_NO_THROW(of.mesh.check());
        EXPECT_EQ(std::ssize(replaced.faces), of.goal.faces);
        EXPECT_EQ(proposal.outcome.faces_after, of.goal.faces);
        EXPECT_EQ(proposal.outcome.faces_wanted, of.goal.faces);
        adapt::samples::expect_outside_kept(before, of.mesh, {of.patch.faces});
        EXPECT_EQ(proposal.outcome.singular_after, adapt::samples::singular_in(of.mesh, replaced.faces));
        EXPECT_EQ(std::ssize(before.singularities()) + proposal.replacement.singular_change,
                  std::ssize(of.mesh.singularities()));
        EXPECT_TRUE(proposal.replacement.moved.vertices.empty());
        EXPECT_NEAR(proposal.outcome.quality_after,
                    adapt::samples::least_scaled_jacobian(of.mesh, replaced.faces), 1e-9);
    }
}

TEST(Propose, TellsSizes) {
    Case of(grid(12, 12), block(12, 2, 2, 10, 10), 2);
    const mesh::QuadMesh before = of.mesh;
    const Proposal proposal = of.propose();
    const Outcome &outcome = proposal.outcome;
    ASSERT_FALSE(outcome.fault) << outcome.text;
    EXPECT_GT(outcome.size_error_before, 0.8); // by a factor of more than 2 in the core, of 1 at the border
    EXPECT_LT(outcome.size_error_before, 1.5);
    EXPECT_LT(outcome.size_error_after, outcome.size_error_before);
    EXPECT_NEAR(outcome.least_area_before, 1.2, 0.2); // next to the border; no face is too small
    EXPECT_GT(outcome.least_area_after, 0.125);
    EXPECT_LT(outcome.least_area_after, 1);
    EXPECT_NEAR(outcome.shortest_edge_before, std::sqrt(outcome.least_area_before), 1e-9); // squares
    EXPECT_GT(outcome.shortest_edge_after, 0.2);
    EXPECT_LT(outcome.shortest_edge_after, 1);
    EXPECT_NEAR(outcome.aspect_ratio_before, 1, 1e-12);
    const auto replaced = commit(of.mesh, proposal.replacement);
    EXPECT_NEAR(outcome.time_step,
                reference::time_step(of.mesh, replaced.faces) / reference::time_step(before, of.patch.faces),
                1e-12);
    EXPECT_LT(outcome.time_step, 0.8); // half the area, at best
    EXPECT_NEAR(outcome.aspect_ratio_after, reference::largest_aspect_ratio(of.mesh, replaced.faces), 1e-12);
}

void expect_sizes_stay(const Outcome &outcome) {
    EXPECT_FALSE(std::isnan(outcome.size_error_before));
    EXPECT_EQ(outcome.size_error_after, outcome.size_error_before);
    EXPECT_EQ(outcome.least_area_after, outcome.least_area_before);
    EXPECT_EQ(outcome.shortest_edge_after, outcome.shortest_edge_before);
    EXPECT_EQ(outcome.aspect_ratio_after, outcome.aspect_ratio_before);
    EXPECT_EQ(outcome.time_step, 1);
}

TEST(Propose, TellsTheOldSizesWhereThePatchIsLeft) {
    Case of(grid(8, 8), block(8, 1, 1, 7, 7), 1);
    const Outcome same = of.propose().outcome; // nothing is better
    expect_sizes_stay(same);
    EXPECT_NEAR(same.size_error_after, 0, 1e-6);
    EXPECT_NEAR(same.least_area_after, 1, 1e-6);
    of.goal.faces = 4;
    const Outcome left = of.propose().outcome;
    EXPECT_EQ(left.fault, Fault::no_filling);
    expect_sizes_stay(left);
    of.patch.faces = {0, 20}; // no disk, so that there are no sizes to want
    const Outcome apart = of.propose().outcome;
    EXPECT_EQ(apart.fault, Fault::patch);
    EXPECT_TRUE(std::isnan(apart.size_error_before) && std::isnan(apart.least_area_after));
    EXPECT_TRUE(std::isnan(apart.shortest_edge_before));
    EXPECT_NEAR(apart.aspect_ratio_before, 1, 1e-12);
    EXPECT_EQ(apart.aspect_ratio_after, apart.aspect_ratio_before);
    EXPECT_EQ(apart.time_step, 1);
}

TEST(Propose, LeavesWhatCannotBeBettered) {
    const Case of(grid(8, 8), block(8, 1, 1, 7, 7), 1);
    const Proposal proposal = of.propose();
    EXPECT_FALSE(proposal.outcome.fault);
    EXPECT_TRUE(proposal.unchanged);
    EXPECT_EQ(proposal.outcome.faces_after, 36);
    EXPECT_EQ(proposal.outcome.singular_after, 0);
    EXPECT_EQ(proposal.outcome.valences_after, (std::map<int, std::int64_t>{{4, 49}}));
}

TEST(Propose, LeavesWhatIsThereWhereNothingIsAsGood) {
    Case of(grid(8, 8), block(8, 1, 1, 7, 7), 1);
    of.settings.min_quality = 1; // nor would the mesh itself pass
    const Proposal proposal = of.propose();
    EXPECT_TRUE(proposal.unchanged);
    EXPECT_FALSE(proposal.outcome.fault);
    EXPECT_EQ(proposal.outcome.faces_after, 36);
    EXPECT_EQ(proposal.outcome.quality_after, 1);
    EXPECT_GT(proposal.trace.of(Refused::shape), 0);
}

TEST(Propose, SavesSingularitiesAtTheSameNumberOfFaces) {
    Case of = irregular(1);
    const Proposal proposal = of.propose();
    ASSERT_FALSE(proposal.outcome.fault);
    ASSERT_FALSE(proposal.unchanged);
    EXPECT_LT(proposal.outcome.singular_after, proposal.outcome.singular_before);
    EXPECT_GE(proposal.outcome.singular_after, proposal.outcome.singular_bound);
    EXPECT_EQ(proposal.outcome.faces_after, proposal.outcome.faces_before);
}

TEST(Propose, SaysWhyThereIsNoFilling) {
    Case of(grid(8, 8), block(8, 1, 1, 7, 7), 0.1);
    expect_fault(of, Fault::no_filling, "24 edges needs at least 11");
    of.patch.faces = {0, 20};
    expect_fault(of, Fault::patch, "not connected");
}

TEST(Propose, ComesAsNearAsTheBoundaryAllowsWhereThatIsAskedFor) {
    for (const double alpha : {0.05, 0.2}) {
        Case of = irregular(alpha);
        EXPECT_EQ(of.propose().outcome.fault, Fault::no_filling);
        of.goal.or_nearest = true;
        const Outcome outcome = of.propose().outcome;
        EXPECT_FALSE(outcome.fault) << outcome.text;
        EXPECT_EQ(outcome.faces_wanted, of.goal.faces);
        EXPECT_GT(outcome.faces_after, outcome.faces_wanted);
        EXPECT_LT(outcome.faces_after, outcome.faces_before);
        EXPECT_GE(outcome.quality_after, 0.1);
        EXPECT_NE(outcome.text.find("the nearest number of faces is " + std::to_string(outcome.faces_after)),
                  std::string::npos)
            << outcome.text;
    }
}

TEST(Propose, SaysThatNoFillingHasTheWantedShape) {
    Case of = irregular(0.8);
    of.settings.min_quality = 1;
    of.settings.candidates = 2;
    const Proposal proposal = of.propose();
    EXPECT_EQ(proposal.outcome.fault, Fault::geometry);
    EXPECT_GT(proposal.trace.candidates, 0);
    EXPECT_EQ(proposal.trace.of(Refused::shape) + proposal.trace.of(Refused::embedding),
              proposal.trace.candidates);
    expect_fault(of, Fault::geometry, "could be given a valid shape");
}

TEST(Propose, TellsTheToleranceWhereThatIsInTheWay) {
    mesh::QuadMesh sphere = mesh::sphere(6);
    const std::vector<int> faces =
        patch::ball(sphere, {0, 0, 1}, 0.9, std::vector<char>(at(sphere.n_faces()), 0));
    Case of(std::move(sphere), faces, 0.8);
    of.reference = reference::reference_of(of.mesh);
    EXPECT_FALSE(of.propose().outcome.fault);
    of.reference.surface_distance =
        reference::surface_distance_of(of.mesh, *of.reference.surface, of.mesh.n_faces(), 1e-5);
    expect_fault(of, Fault::geometry, "farther from the surface than AMST_OPT_TOLERANCE");
    EXPECT_GT(of.propose().trace.of(Refused::distance), 0);
}

TEST(Propose, DependsOnItsArgumentsAlone) {
    const Case of = irregular(1.3);
    const Proposal first = of.propose(), second = of.propose();
    EXPECT_EQ(first.replacement.filling.quads, second.replacement.filling.quads);
    EXPECT_EQ(first.replacement.points, second.replacement.points);
}

} // namespace
} // namespace alphamst::refill
