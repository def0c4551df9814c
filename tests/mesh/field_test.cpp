#include "mesh/field.h"

#include <gtest/gtest.h>

#include "grids.h"

namespace alphamst::mesh {
namespace {

std::shared_ptr<const Field> field(Entity entity, const char *name, std::vector<double> values) {
    return std::make_shared<const Field>(Field{entity, name, 1, Carry::inherit, std::move(values)});
}

TEST(Fields, AreFoundByEntityAndName) {
    Fields fields;
    EXPECT_TRUE(fields.empty());
    fields.set(field(Entity::vertex, "a", {1}));
    fields.set(field(Entity::face, "a", {2}));
    fields.set(field(Entity::vertex, "b", {3}));
    EXPECT_FALSE(fields.empty());
    EXPECT_EQ(fields.find(Entity::vertex, "a")->values, std::vector{1.0});
    EXPECT_EQ(fields.find(Entity::face, "a")->values, std::vector{2.0});
    EXPECT_EQ(fields.find(Entity::vertex, "b")->values, std::vector{3.0});
    EXPECT_EQ(fields.find(Entity::face, "b"), nullptr);
    EXPECT_EQ(fields.find(Entity::vertex, ""), nullptr);
}

TEST(Fields, OneOfANameTakesThePlaceOfTheOther) {
    Fields fields;
    fields.set(field(Entity::edge, "a", {1}));
    fields.set(field(Entity::edge, "b", {2}));
    fields.set(field(Entity::edge, "a", {3}));
    EXPECT_EQ(std::distance(fields.begin(), fields.end()), 2);
    EXPECT_EQ((*fields.begin())->values, std::vector{3.0});
    fields.remove(Entity::face, "a");
    fields.remove(Entity::edge, "a");
    EXPECT_EQ(std::distance(fields.begin(), fields.end()), 1);
    EXPECT_EQ(fields.find(Entity::edge, "a"), nullptr);
}

TEST(Fields, ACopyOfAMeshHasItsOwn) {
    QuadMesh mesh = plane(1, 1).build();
    EXPECT_EQ(mesh.field(Entity::vertex, "a"), nullptr);
    const std::uint64_t digest = mesh.checksum();
    mesh.fields.set(field(Entity::vertex, "a", {1, 2, 3, 4}));
    EXPECT_EQ(mesh.checksum(), digest);
    const QuadMesh copy = mesh;
    mesh.fields.set(field(Entity::vertex, "a", {5, 6, 7, 8}));
    ASSERT_NE(copy.field(Entity::vertex, "a"), nullptr);
    EXPECT_EQ(*copy.field(Entity::vertex, "a"), (std::vector<double>{1, 2, 3, 4}));
    EXPECT_EQ(*mesh.field(Entity::vertex, "a"), (std::vector<double>{5, 6, 7, 8}));
}

} // namespace
} // namespace alphamst::mesh
