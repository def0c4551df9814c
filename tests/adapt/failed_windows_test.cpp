#include "adapt/failed_windows.h"

#include <gtest/gtest.h>

#include <set>

#include "meshes.h"

namespace alphamst::adapt {
namespace {

const refill::Place place{{5, 6, 9, 10}, {0, 1, 2}};
const refill::ShapeBounds bounds{0.3, 0.1, 3, 0};

std::uint64_t of(const mesh::QuadMesh &mesh, const refill::Place &where = place,
                 const refill::Goal &goal = {}, const refill::ShapeBounds &wanted = bounds,
                 double tolerance = 1) {
    return fingerprint(mesh, where, goal, wanted, tolerance);
}

TEST(FailedWindows, HaveAFingerprintOfAllThatTheAnswerDependsOn) {
    const mesh::QuadMesh mesh = samples::grid(4, 4);
    EXPECT_EQ(of(mesh), of(mesh));
    std::set<std::uint64_t> different{of(mesh)};
    different.insert(of(mesh, {{5, 6, 9}, {10, 0, 1, 2}})); // a face changes sides
    different.insert(of(mesh, {{5, 6, 9, 10}, {0, 1}}));
    mesh::QuadMesh moved = mesh;
    moved.set_point(mesh.corners(0)[0], OpenMesh::Vec3d(-1e-9, 0, 0)); // of the buffer
    different.insert(of(moved));
    for (const auto set :
         {+[](refill::Goal &goal) { goal.faces = 7; }, +[](refill::Goal &goal) { goal.fewest = 2; },
          +[](refill::Goal &goal) { goal.most = 9; }, +[](refill::Goal &goal) { goal.any_count = true; },
          +[](refill::Goal &goal) { goal.forbid_old = true; }, +[](refill::Goal &goal) { goal.turn = true; },
          +[](refill::Goal &goal) { goal.collapse = true; },
          +[](refill::Goal &goal) { goal.most_added = 2; }}) {
        refill::Goal goal;
        set(goal);
        different.insert(of(mesh, place, goal));
    }
    different.insert(of(mesh, place, {}, {0.2, 0.1, 3, 0}));
    different.insert(of(mesh, place, {}, {0.3, 0.1, 3, 1}));
    different.insert(of(mesh, place, {}, bounds, 1.4));
    EXPECT_EQ(different.size(), 15u);
}

TEST(FailedWindows, AreRemembered) {
    FailedWindows failed;
    EXPECT_FALSE(failed.hold(3));
    failed.add(3);
    EXPECT_TRUE(failed.hold(3));
    EXPECT_FALSE(failed.hold(4));
}

} // namespace
} // namespace alphamst::adapt
