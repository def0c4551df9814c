#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "adapt/meshes.h"
#include "index.h"
#include "mesh/curved.h"
#include "refill/cavity.h"

namespace alphamst::refill {
namespace {

// A round patch of many singularities in a plane, away from the border of the mesh.
struct Source {
    mesh::QuadMesh mesh = adapt::samples::unstructured(14, 4);
    Patch patch;
    Goal goal;
    Settings settings;
    reference::Reference reference;

    Source() {
        for (int f = 0; f < mesh.n_faces(); ++f)
            if ((adapt::samples::centre(mesh, f) - OpenMesh::Vec3d(7, 7, 0)).norm() < 4.5)
                patch.faces.push_back(f);
        patch.faces = patch::repair(mesh, patch.faces, std::vector<char>(at(mesh.n_faces()), 0));
        goal.faces = std::ssize(patch.faces);
        settings.node_limit = 100; // enough for some of every kind
        reference = reference::reference_of(mesh);
    }
    Cavity cavity() const { return {mesh, patch, goal, settings, reference}; }
};

std::vector<Cavity::Group> groups_of(const Cavity::Generator &generator, std::size_t most = 3) {
    std::vector<Cavity::Group> groups;
    for (Cavity::Group group = generator(); !group.empty() && groups.size() < most; group = generator())
        groups.push_back(std::move(group));
    return groups;
}

std::vector<int> faces_at(const fill::Filling &filling) {
    std::vector<int> faces(at(filling.vertices), 0);
    for (const auto &quad : filling.quads)
        for (const int v : quad)
            ++faces[at(v)];
    return faces;
}

// A candidate is what its numbers say.
void expect_as_told(const Cavity &cavity, const Cavity::Candidate &candidate) {
    const fill::Filling filling = candidate.build().filling;
    EXPECT_EQ(std::ssize(filling.quads), candidate.faces);
    EXPECT_EQ(filling.boundary, std::ssize(cavity.window.loop));
    EXPECT_EQ(filling.vertices, candidate.faces + filling.boundary / 2 + 1); // a disk
    EXPECT_EQ(cavity.singular_all(filling), candidate.singularities);
}

TEST(Generators, OfAnyCountOfferFewestSingularitiesFirst) {
    Source source;
    source.goal.any_count = true;
    const Cavity cavity = source.cavity();
    const auto generators = cavity.generators();
    ASSERT_EQ(generators.size(), 1u);
    const auto groups = groups_of(generators[0], 3);
    ASSERT_GT(groups.size(), 1u);
    int before = 0;
    for (const Cavity::Group &group : groups)
        for (const Cavity::Candidate &candidate : group) {
            EXPECT_EQ(candidate.singularities, group[0].singularities);
            EXPECT_GE(candidate.singularities, before);
            before = candidate.singularities;
            EXPECT_GE(2 * candidate.faces, source.goal.faces);
            EXPECT_LE(candidate.faces, 2 * source.goal.faces);
            expect_as_told(cavity, candidate);
        }
    EXPECT_LT(groups[0][0].singularities, cavity.old_singular_all);
}

TEST(Generators, OfAnyCountKeepToTheRange) {
    Source source;
    source.goal.any_count = true;
    source.goal.fewest = source.goal.faces + 3;
    source.goal.most = source.goal.faces + 5;
    const Cavity cavity = source.cavity();
    const auto groups = groups_of(cavity.generators().at(0));
    ASSERT_FALSE(groups.empty());
    for (const Cavity::Group &group : groups)
        for (const Cavity::Candidate &candidate : group) {
            EXPECT_GE(candidate.faces, source.goal.fewest);
            EXPECT_LE(candidate.faces, source.goal.most);
        }
}

TEST(Generators, GiveTheWantedFacesAndLastThoseNearIt) {
    Source source;
    source.goal.faces -= 7;
    const Cavity cavity = source.cavity();
    ASSERT_FALSE(cavity.ragged());
    const auto generators = cavity.generators();
    ASSERT_EQ(generators.size(), 4u); // templates, inside, collapsed, near
    for (std::size_t g = 0; g < generators.size(); ++g) {
        const auto groups = groups_of(generators[g]);
        ASSERT_FALSE(groups.empty()) << g;
        for (const Cavity::Group &group : groups)
            for (const Cavity::Candidate &candidate : group) {
                EXPECT_LE(std::abs(candidate.faces - source.goal.faces), g == 3 ? 2 : 0) << g;
                expect_as_told(cavity, candidate);
            }
    }
}

TEST(Generators, AddNoMoreSingularitiesThanTheGoalAllows) {
    Source source;
    source.goal.any_count = true;
    for (const int added : {-2, -source.cavity().old_singular_all}) {
        source.goal.most_added = added;
        const Cavity cavity = source.cavity();
        for (const Cavity::Group &group : groups_of(cavity.generators().at(0)))
            for (const Cavity::Candidate &candidate : group)
                EXPECT_LE(candidate.singularities, cavity.old_singular_all + added);
    }
}

TEST(Generators, OfARaggedPatchTryTemplatesLate) {
    Source source;
    source.mesh = adapt::samples::grid(20, 4);
    source.reference = reference::reference_of(source.mesh);
    source.patch.faces = adapt::samples::block(20, 1, 1, 19, 3);
    source.goal.faces = 30;
    ASSERT_TRUE(source.cavity().ragged());
    const Cavity cavity = source.cavity();
    const auto generators = cavity.generators();
    EXPECT_EQ(generators.size(), 4u);
}

TEST(Generators, CollapsedOnesComeWithTheirPlaces) {
    Source source;
    source.goal.collapse = true;
    source.goal.faces -= 10;
    const Cavity cavity = source.cavity();
    const auto generators = cavity.generators();
    ASSERT_EQ(generators.size(), 1u);
    const auto groups = groups_of(generators[0], 20);
    EXPECT_EQ(groups.size(), 8u); // seeds
    for (const Cavity::Group &group : groups)
        for (const Cavity::Candidate &candidate : group) {
            EXPECT_EQ(candidate.faces, source.goal.faces);
            expect_as_told(cavity, candidate);
            const PlacedFilling shape = candidate.build();
            EXPECT_TRUE(geometry::shapes_of(shape.filling.quads, shape.positions).valid);
        }
    source.goal.faces = std::ssize(source.patch.faces); // there is nothing to collapse
    EXPECT_TRUE(source.cavity().generators().at(0)().empty());
}

// Faces at the loop stay, so each vertex there keeps its number of them.
TEST(Generators, OfTheInsideKeepTheFacesAround) {
    Source source;
    source.goal.keep_quality = true;
    const Cavity cavity = source.cavity();
    const std::vector<int> old = faces_at(cavity.old);
    const auto generators = cavity.generators();
    const std::size_t inner = generators.size() - 2;
    int seen = 0;
    for (std::size_t g = inner; g < generators.size(); ++g)
        for (const Cavity::Group &group : groups_of(generators[g]))
            for (const Cavity::Candidate &candidate : group) {
                ++seen;
                EXPECT_EQ(candidate.faces, source.goal.faces);
                EXPECT_LT(candidate.singularities, cavity.old_singular_all);
                expect_as_told(cavity, candidate);
                const std::vector<int> now = faces_at(candidate.build().filling);
                EXPECT_TRUE(std::equal(old.begin(), old.begin() + cavity.old.boundary, now.begin()));
            }
    EXPECT_GT(seen, 0);
}

TEST(Generators, LeaveABufferAloneOnlyWhereTheShapeIsGood) {
    Source source;
    source.mesh = adapt::samples::grid(8, 8);
    source.reference = reference::reference_of(source.mesh);
    source.patch.faces = adapt::samples::block(8, 1, 1, 7, 7);
    source.goal = {};
    source.goal.keep_quality = true;
    source.goal.faces = 36;
    EXPECT_EQ(source.cavity().generators().size(), 2u);
    source.mesh.set_point(4 * 9 + 4, OpenMesh::Vec3d(4.7, 4.7, 0));
    ASSERT_LT(source.cavity().old_quality, 0.6);
    EXPECT_EQ(source.cavity().generators().size(), 3u);
}

TEST(Generators, MakeNothingInsideWhereNothingIs) {
    Source source;
    source.mesh = adapt::samples::grid(8, 8);
    source.reference = reference::reference_of(source.mesh);
    source.patch.faces = adapt::samples::block(8, 2, 2, 5, 5);
    source.goal = {};
    source.goal.keep_quality = true;
    source.goal.faces = 9;
    const Cavity cavity = source.cavity();
    for (const Cavity::Generator &generator : cavity.generators())
        EXPECT_TRUE(generator().empty());
}

} // namespace
} // namespace alphamst::refill
