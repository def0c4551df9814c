#include "io/fields.h"

#include <gtest/gtest.h>

#include <limits>

#include "samples.h"

namespace alphamst::io {
namespace {

TEST(Fields, CarryRulesSuitWhatTheyAreOf) {
    Arrays mesh = samples::grid(1, 2);
    add_new_field(mesh, Entity::vertex, "a", 1, false, {1, 2, 3, 4});
    add_new_field(mesh, Entity::vertex, "b", 1, true, {1, 2, 3, 4});
    add_new_field(mesh, Entity::face, "c", 2, false, {1, 2});
    add_new_field(mesh, Entity::face, "d", 1, true, {1});
    add_new_field(mesh, Entity::face, "cross", 3, false, {1, 0, 0});
    settle_fields(mesh);
    EXPECT_TRUE(mesh.remarks.empty());
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "a")->carry, mesh::Carry::linear);
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "b")->carry, mesh::Carry::inherit);
    EXPECT_EQ(mesh.fields.find(Entity::face, "c")->carry, mesh::Carry::conserve);
    EXPECT_EQ(mesh.fields.find(Entity::face, "d")->carry, mesh::Carry::inherit);
    EXPECT_EQ(mesh.fields.find(Entity::face, "cross")->carry, mesh::Carry::inherit);
}

TEST(Fields, WhatCannotBeOneIsLeftOutAndTold) {
    Arrays mesh = samples::grid(1, 2);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    add_new_field(mesh, Entity::vertex, "hole", 1, false, {1, nan, 3, 4});
    add_new_field(mesh, Entity::vertex, "size", 1, false, {1, 2, 0, 4});
    add_new_field(mesh, Entity::vertex, "", 1, false, {1, 2, 3, 4});
    add_new_field(mesh, Entity::face, "good", 1, false, {1});
    add_new_field(mesh, Entity::face, "good", 1, false, {2});
    settle_fields(mesh);
    EXPECT_EQ(mesh.remarks,
              (std::vector<std::string>{
                  "there are several data 'good', of which the last count",
                  "the data 'hole' are left out: vertex number 1 has a value that is not a finite "
                  "number",
                  "the data 'size' are left out: vertex number 2 has a \"size\" that is not above 0",
                  "the data '' are left out: it has no name"}));
    EXPECT_EQ(std::distance(mesh.fields.begin(), mesh.fields.end()), 1);
    EXPECT_EQ(mesh.fields.find(Entity::face, "good")->values, std::vector<double>{2});
}

} // namespace
} // namespace alphamst::io
