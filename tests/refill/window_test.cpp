#include "refill/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "adapt/meshes.h"
#include "index.h"
#include "patch/grow.h"
#include "reference/reference.h"
#include "refill/patch.h"

namespace alphamst::refill {
namespace {

using adapt::samples::block;

constexpr ShapeBounds usual{0.3, 0.1, 3, 0};

// A window of a mesh that may change with the faces around it.
struct Opened {
    mesh::QuadMesh mesh;
    Place place;
    Goal goal;
    Settings settings;
    reference::Reference reference;
    Trace trace;

    Opened(mesh::QuadMesh of, std::vector<int> faces) : mesh(std::move(of)) {
        const std::vector<int> all = patch::Growth(mesh).surround(faces, 2);
        place.buffer.assign(all.begin() + std::ssize(faces), all.end());
        place.faces = std::move(faces);
        goal.faces = std::ssize(place.faces);
        goal.any_count = true;
        settings.node_limit = 200;
        reference = reference::reference_of(mesh);
    }
    std::optional<Replacement> refill(const ShapeBounds &wanted = usual) {
        trace = {};
        return refill_window(mesh, place, goal, wanted, settings, reference, trace);
    }
    double quality() const {
        const std::vector<double> each = reference.scaled_jacobians(mesh);
        return *std::min_element(each.begin(), each.end());
    }
};

Opened irregular(unsigned seed = 4) {
    mesh::QuadMesh mesh = adapt::samples::unstructured(14, seed);
    const std::vector<char> none(at(mesh.n_faces()), 0);
    std::vector<int> faces = patch::repair(mesh, patch::ball(mesh, {7, 7, 0}, 3.5, none), none);
    return {std::move(mesh), std::move(faces)};
}

void put(mesh::QuadMesh &mesh, const Replacement &found) {
    for (const auto &[v, point] : found.moved.vertices)
        mesh.set_point(v, point);
    commit(mesh, found);
}

TEST(Window, AddsNoMoreSingularitiesThanTheGoalAllows) {
    int found = 0;
    for (const unsigned seed : {1, 2, 3, 4}) {
        for (const int added : {-1, -3, -6}) {
            Opened opened = irregular(seed);
            opened.goal.most_added = added;
            const auto replacement = opened.refill();
            if (!replacement)
                continue;
            ++found;
            EXPECT_LE(replacement->singular_change, added);
            const auto before = std::ssize(opened.mesh.singularities());
            put(opened.mesh, *replacement);
            EXPECT_NO_THROW(opened.mesh.check());
            EXPECT_EQ(std::ssize(opened.mesh.singularities()), before + replacement->singular_change);
        }
    }
    EXPECT_GT(found, 4);
    Opened opened = irregular();
    opened.goal.most_added = -1000;
    EXPECT_FALSE(opened.refill());
}

TEST(Window, OfARegularMeshHasNothingToSave) {
    Opened opened(adapt::samples::grid(10, 10), block(10, 2, 2, 7, 7));
    opened.goal.most_added = -1;
    EXPECT_FALSE(opened.refill());
    EXPECT_EQ(opened.trace.candidates, 0);
    opened.goal.most_added = 0;
    const auto replacement = opened.refill();
    ASSERT_TRUE(replacement);
    EXPECT_EQ(replacement->singular_change, 0);
}

TEST(Window, KeepsTheShapeThatIsWantedOrWasThere) {
    for (const unsigned seed : {1, 2, 3, 4}) {
        Opened opened = irregular(seed);
        opened.goal.most_added = -1;
        const double before = opened.quality();
        if (const auto replacement = opened.refill()) {
            put(opened.mesh, *replacement);
            EXPECT_GE(opened.quality(), std::min(before, usual.scaled_jacobian) - 1e-12);
        }
        // No shape is as good as this; then the old one is what counts.
        Opened strict = irregular(seed);
        strict.goal.most_added = -1;
        if (const auto replacement = strict.refill({2, 2, 1e9, 0})) {
            put(strict.mesh, *replacement);
            EXPECT_GE(strict.quality(), before - 1e-12);
        }
    }
}

TEST(Window, HasTheWantedFacesWhereTheyCount) {
    for (const std::int64_t more : {-4, 3}) {
        Opened opened = irregular();
        opened.goal.any_count = false;
        opened.goal.faces += more;
        const auto replacement = opened.refill({0.1, 0.01, 100, 0});
        ASSERT_TRUE(replacement) << more;
        EXPECT_EQ(std::ssize(replacement->filling.quads), opened.goal.faces);
    }
    Opened opened = irregular();
    opened.goal.fewest = opened.goal.most = opened.goal.faces + 2;
    const auto replacement = opened.refill({0.1, 0.01, 100, 0});
    ASSERT_TRUE(replacement);
    EXPECT_EQ(std::ssize(replacement->filling.quads), opened.goal.fewest);
}

// Collapsed ones come whatever their numbers are.
TEST(Window, TellsWhatItsNumbersForbid) {
    Opened opened(adapt::samples::grid(10, 10), block(10, 2, 2, 8, 8));
    opened.goal.any_count = false;
    opened.goal.collapse = true;
    opened.goal.faces = 30;
    EXPECT_TRUE(opened.refill({0.1, 0.01, 100, 0}));
    opened.goal.most_added = 0;
    EXPECT_FALSE(opened.refill({0.1, 0.01, 100, 0}));
    EXPECT_GT(opened.trace.of(Refused::numbers), 0);
    EXPECT_EQ(opened.trace.candidates, 0);
}

TEST(Window, BettersTheOldFillingWhereThatIsNoAnswer) {
    mesh::QuadMesh mesh = adapt::samples::grid(10, 10);
    mesh.set_point(5 * 11 + 5, OpenMesh::Vec3d(5.75, 5.75, 0));
    Opened opened(std::move(mesh), block(10, 3, 3, 7, 7));
    opened.goal.forbid_old = true;
    opened.goal.fewest = opened.goal.most = opened.goal.faces;
    opened.goal.most_added = 0;
    const double before = opened.quality();
    const auto replacement = opened.refill();
    ASSERT_TRUE(replacement);
    put(opened.mesh, *replacement);
    EXPECT_GE(opened.quality(), std::min(0.3, before + 0.05) - 1e-12);
    EXPECT_GT(opened.quality(), before);
}

TEST(Window, ThatIsNoDiskIsLeft) {
    Opened opened(adapt::samples::grid(6, 6), {0, 20});
    EXPECT_FALSE(opened.refill());
    EXPECT_EQ(opened.trace.candidates, 0);
}

TEST(Window, GivesUpAfterSoManyCandidates) {
    Opened opened = irregular();
    opened.goal.any_count = false;
    opened.goal.faces += 40;
    opened.settings.candidates = 2;
    for (const ShapeBounds &wanted : {ShapeBounds{2, 2, 0, 0}}) {
        const auto replacement = opened.refill(wanted);
        if (!replacement) {
            EXPECT_LE(opened.trace.candidates, 2);
        }
        EXPECT_LE(opened.trace.of(Refused::shape) + opened.trace.of(Refused::embedding), 2);
    }
}

} // namespace
} // namespace alphamst::refill
