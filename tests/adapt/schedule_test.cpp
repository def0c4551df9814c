#include "adapt/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "eared.h"
#include "reference/cross_field.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

using samples::silent;

// A mesh after the stages.
struct Scheduled {
    mesh::QuadMesh before, mesh;
    reference::Reference reference;

    Scheduled(const mesh::QuadMesh &of, const Aim &aim, const Settings &settings = {},
              const Progress &progress = silent)
        : before(of), mesh(of), reference(reference::reference_of(mesh)) {
        if (reference.surface)
            reference.surface_distance =
                reference::surface_distance_of(mesh, *reference.surface, aim.faces, settings.tolerance);
        std::optional<reference::CrossField> cross_field;
        if (settings.align)
            cross_field.emplace(mesh);
        run_schedule(mesh, reference, aim, cross_field, settings, progress);
        EXPECT_NO_THROW(mesh.check());
    }
    Scheduled(const Scheduled &) = delete;
    Scheduled &operator=(const Scheduled &) = delete;

    double quality() const {
        const std::vector<double> each = reference.scaled_jacobians(mesh);
        return *std::min_element(each.begin(), each.end());
    }
};

TEST(Schedule, DeliversTheExactCount) {
    const mesh::QuadMesh mesh = samples::unstructured(10, 7);
    for (const std::int64_t faces : {85, 100, 131}) {
        const Scheduled scheduled(mesh, {faces, true, {}});
        EXPECT_EQ(scheduled.mesh.n_faces(), faces);
        EXPECT_LT(2 * scheduled.mesh.singularities().size(), mesh.singularities().size());
        EXPECT_GT(scheduled.quality(), 0.2);
    }
}

TEST(Schedule, KeepsTheCountWithinAFewPercentOtherwise) {
    const mesh::QuadMesh mesh = samples::unstructured(12, 3);
    const Scheduled scheduled(mesh, {144, false, {}});
    EXPECT_NEAR(scheduled.mesh.n_faces(), 144, 8);
    EXPECT_LT(2 * scheduled.mesh.singularities().size(), mesh.singularities().size());
}

TEST(Schedule, LeavesARegularMesh) {
    const Scheduled scheduled(samples::grid(10, 8), {80, true, {}});
    EXPECT_EQ(scheduled.mesh.checksum(), scheduled.before.checksum());
}

TEST(Schedule, KeepsTheBorderOfTheMesh) {
    const Scheduled scheduled(samples::unstructured(10, 7), {110, true, {}});
    std::set<std::array<double, 3>> border[2];
    for (const auto *mesh : {&scheduled.before, &scheduled.mesh})
        for (int v = 0; v < mesh->n_vertices(); ++v)
            if (mesh->on_boundary(v))
                border[mesh == &scheduled.mesh].insert(
                    {mesh->point(v)[0], mesh->point(v)[1], mesh->point(v)[2]});
    EXPECT_EQ(border[0].size(), 40u);
    EXPECT_EQ(border[0], border[1]);
}

TEST(Schedule, LeavesNoMoreSingularVerticesWhereTheRoomIsGiven) {
    const mesh::QuadMesh ears = samples::eared(2);
    const Scheduled scheduled(ears, {std::llround(1.2 * ears.n_faces()), true, 1.0});
    EXPECT_LE(scheduled.mesh.singularities().size(), ears.singularities().size());
}

TEST(Schedule, KeepsVerticesOnTheSurfaceAndItsNumbers) {
    const mesh::QuadMesh ears = samples::eared(2);
    const Scheduled scheduled(ears, {std::llround(0.9 * ears.n_faces()), true, {}});
    EXPECT_EQ(scheduled.mesh.n_vertices() - scheduled.mesh.n_faces(), 2); // still a sphere
    EXPECT_EQ(std::ssize(scheduled.reference.surface_triangles), scheduled.mesh.n_vertices());
    EXPECT_EQ(scheduled.reference.surface_distance->faces(), scheduled.mesh.n_faces());
    for (int v = 0; v < scheduled.mesh.n_vertices(); ++v) {
        const OpenMesh::Vec3d &p = scheduled.mesh.point(v);
        EXPECT_LT(scheduled.reference.surface->nearest({p[0], p[1], p[2]}).distance, 1e-9);
    }
}

TEST(Schedule, TellsItsStagesToTheEnd) {
    std::vector<std::pair<double, std::string>> told;
    const Scheduled scheduled(
        samples::unstructured(8, 7), {70, true, {}}, {},
        [&](double fraction, const char *stage) { told.emplace_back(fraction, stage); });
    std::set<std::string> stages;
    for (const auto &[fraction, stage] : told) {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
        stages.insert(stage);
    }
    EXPECT_TRUE(stages.contains("reduce") && stages.contains("count") && stages.contains("relax"));
    EXPECT_EQ(told.back(), std::pair(1.0, std::string("mend")));
}

TEST(Schedule, EndsWhereItIsCancelled) {
    const auto cancel = [](double, const char *) { throw Failure(Fault::cancelled, "enough"); };
    mesh::QuadMesh mesh = samples::unstructured(8, 7);
    reference::Reference reference = reference::reference_of(mesh);
    EXPECT_THROW(run_schedule(mesh, reference, {64, true, {}}, {}, {}, cancel), Failure);
}

TEST(Schedule, EqualOnAnyNumberOfThreads) {
    std::set<std::uint64_t> digests;
    for (const int threads : {1, 2}) {
        Settings settings;
        settings.threads = threads;
        digests.insert(Scheduled(samples::unstructured(8, 5), {72, true, {}}, settings).mesh.checksum());
    }
    EXPECT_EQ(digests.size(), 1u);
}

} // namespace
} // namespace alphamst::adapt
