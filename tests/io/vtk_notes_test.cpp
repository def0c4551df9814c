#include "io/vtk_notes.h"

#include <gtest/gtest.h>

#include "io/fields.h"
#include "samples.h"

namespace alphamst::io::vtk {
namespace {

TEST(VtkNotes, BringBackCarryRulesAndNames) {
    Arrays mesh = samples::grid(1, 2);
    add_new_field(mesh, Entity::vertex, "the temperature", 1, true, {1, 2, 3, 4});
    add_new_field(mesh, Entity::face, "energy", 1, false, {1});
    mesh.names = {
        {{Entity::edge, 7}, "inlet of air"}, {{Entity::edge, -9}, "inlet of air"}, {{Entity::face, 7}, "x"}};
    const std::vector<Data> notes = notes_of(mesh);
    EXPECT_EQ(notes.size(), 4u);
    Arrays back = samples::grid(1, 2);
    add_new_field(back, Entity::vertex, "the temperature", 1, false, {1, 2, 3, 4});
    add_new_field(back, Entity::face, "energy", 1, true, {1});
    add_notes(notes, back);
    EXPECT_EQ(back.names, mesh.names);
    EXPECT_EQ(back.fields.find(Entity::vertex, "the temperature")->carry, mesh::Carry::inherit);
    EXPECT_EQ(back.fields.find(Entity::face, "energy")->carry, mesh::Carry::conserve);
}

TEST(VtkNotes, OtherDataArePassedOver) {
    Arrays mesh = samples::grid(1, 2);
    add_new_field(mesh, Entity::vertex, "t", 1, false, {1, 2, 3, 4});
    const std::vector<Data> others{{"TIME", 1, false, {0.5}},        {"carry vertex t", 1, false, {1}},
                                   {"carry vertex t", 1, true, {9}}, {"carry vertex t", 1, true, {1, 1}},
                                   {"carry vertex u", 1, true, {1}}, {"carry t", 1, true, {1}},
                                   {"marker edge ", 1, true, {1}},   {"marker edge a", 1, true, {0, 1e12}},
                                   {"marker volume a", 1, true, {3}}};
    add_notes(others, mesh);
    EXPECT_TRUE(mesh.names.empty());
    EXPECT_EQ(mesh.fields.find(Entity::vertex, "t")->carry, mesh::Carry::linear);
}

} // namespace
} // namespace alphamst::io::vtk
