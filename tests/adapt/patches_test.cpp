#include "adapt/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "index.h"
#include "mesh/curved.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

using samples::block;
using samples::silent;

std::vector<Patch> patches_of(const std::vector<std::vector<int>> &sets) {
    std::vector<Patch> patches;
    for (const std::vector<int> &faces : sets) {
        patches.emplace_back();
        patches.back().faces = faces;
    }
    return patches;
}

// So many times the faces.
GoalOf times(double alpha) {
    return [alpha](const Patch &patch) {
        refill::Goal goal;
        goal.faces = refill::wanted_faces(alpha, patch.faces.size());
        return goal;
    };
}

std::vector<Outcome> refill(mesh::QuadMesh &mesh, std::vector<Patch> &patches, double alpha,
                            const Settings &settings = {}, const Progress &progress = silent) {
    return refill_patches(mesh, patches, settings, progress, "test", times(alpha));
}

// Four quarters of a grid with a row of faces between them.
std::vector<std::vector<int>> quarters() {
    return {block(13, 1, 1, 6, 6), block(13, 7, 1, 12, 6), block(13, 1, 7, 6, 12), block(13, 7, 7, 12, 12)};
}

TEST(Patches, AreRefilledAndTheRestIsKept) {
    const mesh::QuadMesh before = samples::unstructured(13, 5);
    for (const double alpha : {0.72, 1.4}) {
        mesh::QuadMesh mesh = before;
        std::vector<Patch> patches = patches_of(quarters());
        const std::vector<Outcome> outcomes = refill(mesh, patches, alpha);
        EXPECT_NO_THROW(mesh.check());
        ASSERT_EQ(outcomes.size(), 4u);
        std::vector<std::vector<int>> refilled;
        std::vector<int> fresh;
        for (std::size_t p = 0; p < 4; ++p) {
            ASSERT_FALSE(outcomes[p].fault) << outcomes[p].text;
            EXPECT_EQ(std::ssize(patches[p].faces), std::llround(25 * alpha));
            EXPECT_TRUE(std::is_sorted(patches[p].faces.begin(), patches[p].faces.end()));
            EXPECT_EQ(outcomes[p].singular_after, samples::singular_in(mesh, patches[p].faces));
            refilled.push_back(quarters()[p]);
            fresh.insert(fresh.end(), patches[p].faces.begin(), patches[p].faces.end());
        }
        std::sort(fresh.begin(), fresh.end());
        EXPECT_EQ(fresh, samples::new_ones(mesh.face_origin));
        samples::expect_outside_kept(before, mesh, refilled);
    }
}

TEST(Patches, EqualOnAnyNumberOfThreads) {
    std::set<std::uint64_t> digests;
    std::set<std::int64_t> singular;
    for (const int threads : {1, 2}) {
        mesh::QuadMesh mesh = samples::unstructured(13, 5);
        std::vector<Patch> patches = patches_of(quarters());
        Settings settings;
        settings.threads = threads;
        std::int64_t sum = 0;
        for (const Outcome &outcome : refill(mesh, patches, 1.2, settings))
            sum += outcome.singular_after;
        digests.insert(mesh.checksum());
        singular.insert(sum);
    }
    EXPECT_EQ(digests.size(), 1u);
    EXPECT_EQ(singular.size(), 1u);
}

// Of two side by side the second is judged by the mesh that the first leaves.
TEST(Patches, ThatShareVerticesWaitForOneAnother) {
    const std::vector<std::vector<int>> sides{block(12, 1, 2, 6, 9), block(12, 6, 2, 11, 9)};
    mesh::QuadMesh together = samples::unstructured(12, 5), apart = together;
    std::vector<Patch> patches = patches_of(sides);
    const std::vector<Outcome> outcomes = refill(together, patches, 1.3);
    std::vector<Patch> first = patches_of({sides[0]}), second = patches_of({sides[1]});
    const Outcome one = refill(apart, first, 1.3).at(0), other = refill(apart, second, 1.3).at(0);
    ASSERT_FALSE(one.fault || other.fault);
    EXPECT_EQ(together.checksum(), apart.checksum());
    EXPECT_EQ(outcomes[0].singular_after, one.singular_after);
    EXPECT_EQ(outcomes[1].singular_before, other.singular_before);
    EXPECT_EQ(patches[1].faces, second[0].faces);
}

// The first leaves so few faces that the last of the mesh get other numbers.
TEST(Patches, AreFollowedWhereCommitsRenumberThem) {
    const mesh::QuadMesh before = samples::grid(13, 13);
    mesh::QuadMesh mesh = before;
    std::vector<Patch> patches = patches_of({block(13, 1, 1, 6, 6), block(13, 6, 6, 13, 13)});
    patches[1].corners = {6 * 14 + 6, 6 * 14 + 13, 13 * 14 + 13, 13 * 14 + 6};
    const OpenMesh::Vec3d corner = mesh.point(13 * 14 + 13);
    const auto goal = [](const Patch &patch) {
        refill::Goal goal;
        goal.faces = patch.corners.empty() ? 18 : 60;
        return goal;
    };
    const auto outcomes = refill_patches(mesh, patches, {}, silent, "test", goal);
    EXPECT_NO_THROW(mesh.check());
    ASSERT_FALSE(outcomes[0].fault) << outcomes[0].text;
    ASSERT_FALSE(outcomes[1].fault) << outcomes[1].text;
    EXPECT_EQ(patches[0].faces.size(), 18u);
    EXPECT_EQ(patches[1].faces.size(), 60u);
    samples::expect_outside_kept(before, mesh, {block(13, 1, 1, 6, 6), block(13, 6, 6, 13, 13)});
    EXPECT_EQ(mesh.point(patches[1].corners[2]), corner);
}

TEST(Patches, ThatCannotBeFilledAreLeftAndSayWhy) {
    mesh::QuadMesh mesh = samples::grid(13, 13);
    std::vector<Patch> patches = patches_of(quarters());
    patches[1].faces = {0, 168};
    const std::vector<Outcome> outcomes = refill(mesh, patches, 1.2);
    EXPECT_EQ(outcomes[1].fault, Fault::patch);
    EXPECT_EQ(patches[1].faces.size(), 2u);
    for (const std::size_t p : {0, 2, 3})
        EXPECT_FALSE(outcomes[p].fault) << outcomes[p].text;
    EXPECT_EQ(mesh.n_faces(), 169 + 3 * 5);
}

TEST(Patches, TellHowFarTheyAreAndCanBeStopped) {
    mesh::QuadMesh mesh = samples::grid(13, 13);
    std::vector<Patch> patches = patches_of(quarters());
    std::vector<double> told;
    refill(mesh, patches, 1.2, {}, [&](double fraction, const char *stage) {
        EXPECT_STREQ(stage, "test");
        told.push_back(fraction);
    });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
    EXPECT_THROW(
        refill(mesh, patches, 1, {}, [](double, const char *) { throw Failure(Fault::cancelled, "enough"); }),
        Failure);
}

TEST(Patches, WantMoreRoomWhereTheToleranceIsInTheWay) {
    refill::Proposal proposal;
    EXPECT_FALSE(wants_more_room(proposal)); // it was taken
    proposal.outcome.fault = Fault::geometry;
    EXPECT_FALSE(wants_more_room(proposal)); // for other reasons
    proposal.trace.refuse(refill::Refused::distance);
    EXPECT_TRUE(wants_more_room(proposal));
    proposal.outcome.fault.reset();
    EXPECT_FALSE(wants_more_room(proposal)); // one came right
    proposal.unchanged = true;
    EXPECT_TRUE(wants_more_room(proposal));
}

// A cap of a sphere.
struct Cap {
    mesh::QuadMesh mesh = mesh::sphere(6);
    std::vector<Patch> patches =
        patches_of({patch::ball(mesh, {0, 0, 1}, 0.9, std::vector<char>(at(mesh.n_faces()), 0))});
};

TEST(Patches, HaveTheSizesOfAField) {
    mesh::QuadMesh mesh = samples::grid(20, 20);
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    for (int v = 0; v < mesh.n_vertices(); ++v)
        field.values.push_back(mesh.point(v)[0] < 10 ? 0.5 : 1);
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
    std::vector<Patch> patches = patches_of({block(20, 2, 2, 18, 18)});
    ASSERT_FALSE(refill(mesh, patches, 1.8).at(0).fault);
    double area[2] = {0, 0}, faces[2] = {0, 0};
    for (const int f : patches[0].faces) {
        const double x = samples::centre(mesh, f)[0];
        if (std::abs(x - 10) < 2 || std::abs(x - 10) > 6)
            continue; // amid the halves
        area[x > 10] += geometry::area_vector(reference::quad_of(mesh, f)).norm();
        ++faces[x > 10];
    }
    EXPECT_LT(area[0] / faces[0], 0.6 * area[1] / faces[1]);
}

TEST(Patches, KeepToASurfaceWhereTheyAreCurved) {
    Cap cap;
    PatchReference judged(cap.mesh, cap.patches, {}, times(0.8));
    ASSERT_TRUE(judged.reference.surface_distance);
    EXPECT_EQ(cap.mesh.surface, judged.reference.surface);
    EXPECT_TRUE(judged.reference.planes_first);
    const double tolerance = judged.reference.surface_distance->tolerance();
    EXPECT_GT(tolerance, 0);
    for (const double times : tolerances) {
        judged.loosen(times); // of what was asked for, not of the last one
        EXPECT_DOUBLE_EQ(judged.reference.surface_distance->tolerance(), times * tolerance);
    }
    mesh::QuadMesh flat = samples::grid(13, 13);
    PatchReference plane(flat, patches_of(quarters()), {}, times(0.8));
    plane.loosen(2);
    EXPECT_FALSE(plane.reference.surface_distance);
    EXPECT_EQ(flat.surface, nullptr);
}

TEST(Patches, AreTriedAgainWithMoreToleranceOnlyWhereThatIsInTheWay) {
    const auto lines = [](double tolerance) {
        std::vector<std::string> lines;
        auto log = std::make_shared<Log>();
        log->level = log_cavities;
        log->say = [&](int, const std::string &text) { lines.push_back(text); };
        Settings settings;
        settings.log = log;
        settings.tolerance = tolerance;
        Cap cap;
        refill(cap.mesh, cap.patches, 0.8, settings);
        return lines;
    };
    EXPECT_EQ(lines(0.5).size(), 1u);
    const std::vector<std::string> tried = lines(1e-5);
    ASSERT_EQ(tried.size(), std::size(tolerances));
    for (const std::string &line : tried)
        EXPECT_NE(line.find("off the surface"), std::string::npos) << line;
    // In between there is one that only comes right with some more.
    bool later = false;
    for (double tolerance = 0.5; tolerance > 0.01 && !later; tolerance *= 0.8) {
        const std::vector<std::string> steps = lines(tolerance);
        later = steps.size() > 1 && steps.back().find("taken") != std::string::npos;
    }
    EXPECT_TRUE(later);
}

// A roof with its ridge a feature, along the side of the patch. It is judged with the faces around it, to
// which samples of the surface may go, so a commit must know them.
TEST(Patches, BesideAFeatureTellTheFacesAround) {
    mesh::QuadMesh mesh = mesh::grid(12, 8, [](double s, double t) {
        return Eigen::Vector3d(12 * s, 8 * t, 6 - std::abs(12 * s - 6) + 0.05 * std::sin(6 * t));
    });
    for (int j = 0; j < 8; ++j)
        mesh.edge_flags[at(mesh.find_edge(13 * j + 6, 13 * j + 19))] = mesh::feature;
    std::vector<Patch> patches = patches_of({block(12, 6, 2, 10, 6)});
    PatchReference judged(mesh, patches, {}, times(2));
    ASSERT_TRUE(mesh.curves);
    const refill::Proposal proposal =
        refill::propose(mesh, patches[0], times(2)(patches[0]), {}, judged.reference);
    ASSERT_FALSE(proposal.outcome.fault) << proposal.outcome.text;
    EXPECT_EQ(proposal.buffer.size(), 20u); // the frame around 4 by 4
    const auto quads = std::ssize(proposal.replacement.filling.quads);
    for (const auto &owner : proposal.replacement.owners)
        EXPECT_LT(owner.quad, quads + std::ssize(proposal.buffer));
    EXPECT_FALSE(refill(mesh, patches, 2).at(0).fault);
    EXPECT_NO_THROW(mesh.check());
}

} // namespace
} // namespace alphamst::adapt
