#include "adapt/divide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "adapt/patches.h"
#include "index.h"
#include "mesh/curved.h"
#include "patch/window.h"
#include "run.h"

namespace alphamst::adapt {
namespace {

using samples::silent;

// A frame of a 20 by 20 grid, four faces wide.
std::vector<int> frame() {
    std::vector<int> faces;
    for (const int f : samples::block(20, 2, 2, 18, 18)) {
        const int i = f % 20, j = f / 20;
        if (i < 6 || i >= 14 || j < 6 || j >= 14)
            faces.push_back(f);
    }
    return faces;
}

TEST(Parts, BringARingToItsCountAndLeaveAllElse) {
    for (const double alpha : {0.6, 2.0, 4.0}) {
        mesh::QuadMesh mesh = samples::grid(20, 20);
        std::vector<Patch> patches(2);
        patches[0].faces = samples::block(20, 8, 8, 12, 12); // another, in the middle
        patches[1].faces = frame();
        const double height = samples::centre(mesh, patches[0].faces[0])[1];
        ASSERT_EQ(patch::defects(mesh, patches[1].faces), patch::not_disk);
        const std::int64_t wanted = std::llround(alpha * static_cast<double>(patches[1].faces.size()));
        Outcome outcome;
        refill_in_parts(mesh, patches, 1, wanted, {}, silent, outcome);
        ASSERT_NO_THROW(mesh.check());
        EXPECT_EQ(std::ssize(patches[1].faces), wanted) << alpha;
        EXPECT_EQ(outcome.faces_after, wanted);
        EXPECT_EQ(outcome.singular_before, 0);
        EXPECT_EQ(outcome.singular_after, samples::singular_in(mesh, patches[1].faces));
        EXPECT_GT(outcome.quality_after, 0.1) << alpha;
        EXPECT_LT(outcome.size_error_after, 1) << alpha;
        // The hole is as it was.
        EXPECT_EQ(patches[0].faces.size(), 16u);
        EXPECT_EQ(samples::centre(mesh, patches[0].faces[0])[1], height);
        for (const int f : patches[1].faces) {
            const OpenMesh::Vec3d c = samples::centre(mesh, f);
            EXPECT_TRUE(std::max(std::abs(c[0] - 10), std::abs(c[1] - 10)) > 4);
        }
    }
}

// What is known of each face is of the faces that are there now, or nothing is.
TEST(Parts, OfAMeshWithAFieldOfSizesTellNothingOfOtherFaces) {
    mesh::QuadMesh mesh = samples::grid(20, 20);
    mesh::Field field{Entity::vertex, "size", 1, mesh::Carry::linear, {}};
    field.values.assign(at(mesh.n_vertices()), 1);
    mesh.fields.set(std::make_shared<const mesh::Field>(std::move(field)));
    mesh.begun = std::make_shared<const mesh::QuadMesh>(mesh);
    std::vector<Patch> patches(1);
    patches[0].faces = frame();
    Outcome outcome;
    outcome.size_errors = {1, 2, 3}; // of faces that were there
    refill_in_parts(mesh, patches, 0, 300, {}, silent, outcome);
    EXPECT_TRUE(outcome.size_errors.empty());
    EXPECT_TRUE(std::isnan(outcome.size_error_after));
    sort_faces(patches[0], outcome);
    EXPECT_TRUE(std::is_sorted(patches[0].faces.begin(), patches[0].faces.end()));
}

TEST(Parts, SaveSingularVerticesWhereTheCountStays) {
    mesh::QuadMesh mesh = samples::unstructured(20, 5);
    std::vector<Patch> patches(1);
    patches[0].faces = samples::all_faces(mesh);
    Outcome outcome;
    refill_in_parts(mesh, patches, 0, mesh.n_faces(), {}, silent, outcome);
    EXPECT_EQ(mesh.n_faces(), 400);
    EXPECT_LT(outcome.singular_after, outcome.singular_before);
    EXPECT_GE(outcome.quality_after, outcome.quality_before - 1e-12);
}

// A finger, which no chart on a circle takes as a whole: it has a border of 12 edges and 300 faces.
mesh::QuadMesh finger() {
    std::vector<double> points;
    std::vector<std::int32_t> faces;
    constexpr int around = 12, rings = 24;
    const auto add = [&](double radius, double angle, double z) {
        points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), z});
    };
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i < around; ++i)
            add(1, 2 * std::numbers::pi * i / around, 0.5 * j);
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            const int next = (i + 1) % around;
            faces.insert(faces.end(),
                         {j * around + i, j * around + next, (j + 1) * around + next, (j + 1) * around + i});
        }
    // The cap: six quads around its middle.
    const int middle = static_cast<int>(points.size() / 3), top = rings * around;
    add(0, 0, 0.5 * rings + 0.3);
    for (int i = 0; i < around; i += 2)
        faces.insert(faces.end(), {top + i, top + i + 1, top + (i + 2) % around, middle});
    return mesh::QuadMesh::build(3, points, faces);
}

TEST(Parts, FillAFinger) {
    mesh::QuadMesh mesh = finger();
    std::vector<Patch> patches(1);
    patches[0].faces = samples::all_faces(mesh);
    const std::int64_t before = mesh.n_faces();
    const std::vector<Outcome> outcomes = adapt(mesh, patches, 2, {}, silent);
    EXPECT_FALSE(outcomes[0].fault) << outcomes[0].text;
    EXPECT_NEAR(static_cast<double>(outcomes[0].faces_after), 2.0 * static_cast<double>(before), 12);
    EXPECT_GT(outcomes[0].quality_after, 0);
    EXPECT_NO_THROW(mesh.check());
}

} // namespace
} // namespace alphamst::adapt
