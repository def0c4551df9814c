#include <gtest/gtest.h>

#include "io/fields.h"
#include "io/formats.h"
#include "samples.h"

namespace alphamst::io {
namespace {

// Marked, named, with fields.
Arrays full() {
    Arrays mesh = samples::grid(2, 3);
    mesh.face_marker = {1, 0, 3, -2147483647 - 1};
    mesh.marked_edges = {{{0, 1}, 5}, {{1, 2}, 7}};
    mesh.marked_points = {{8, 6}};
    mesh.names = {{{Entity::edge, 5}, "low & <wide> rim"}, {{Entity::face, 3}, "\xc3\xa9t\xc3\xa9"}};
    add_new_field(mesh, Entity::vertex, "a temperature", 1, false, {1, 2, 3, 4, 5, 6, 7, 8, 0.1});
    add_new_field(mesh, Entity::vertex, "label", 1, true, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    add_new_field(mesh, Entity::face, "u & v", 2, false, {1, 2, 3, 4, 5, 6, -0.0, 1.0 / 3});
    return mesh;
}

void expect_equal(const Arrays &back, const Arrays &mesh) {
    EXPECT_TRUE(samples::same_bits(back.points, mesh.points));
    EXPECT_EQ(back.dim, mesh.dim);
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.face_marker, mesh.face_marker);
    EXPECT_EQ(samples::edges_of(back), samples::edges_of(mesh));
    EXPECT_EQ(back.names, mesh.names);
    for (const auto &field : mesh.fields) {
        const mesh::Field *found = back.fields.find(field->entity, field->name);
        ASSERT_NE(found, nullptr) << field->name;
        EXPECT_EQ(found->components, field->components);
        EXPECT_EQ(found->carry, field->carry);
        EXPECT_TRUE(samples::same_bits(found->values, field->values)) << field->name;
    }
    EXPECT_TRUE(back.remarks.empty());
}

TEST(VtuWrite, LosesNothing) {
    const Arrays mesh = full(), plain = samples::grid(3, 2);
    expect_equal(parse_vtu(print_vtu(mesh)), mesh);
    expect_equal(parse_vtu(print_vtu(plain)), plain);
    expect_equal(parse_vtk(print_vtk(mesh)), mesh); // nor does the legacy format
}

TEST(VtuWrite, SaysThatFieldsOfEdgesAreLost) {
    const samples::Folder folder;
    Arrays mesh = full();
    auto chord = std::make_shared<mesh::Field>();
    chord->entity = Entity::edge;
    chord->name = "chord";
    chord->values.resize(12);
    mesh.fields.set(chord);
    using Remarks = std::vector<std::string>;
    EXPECT_EQ(write(folder / "m.vtu", mesh), Remarks{".vtu has no place for 1 fields: 'chord'"});
    EXPECT_EQ(write(folder / "m.vtk", mesh), Remarks{".vtk has no place for 1 fields: 'chord'"});
    EXPECT_EQ(write(folder / "m.msh", mesh),
              Remarks{".msh has no place for 4 fields: 'a?temperature', 'label', 'u?&?v', 'chord'"});
    expect_equal(read(folder / "m.vtu"), full());
}

TEST(VtuWrite, NamesAreCharacters) {
    Arrays mesh = samples::grid(1, 2);
    for (const char *name : {"\xff", "\xc3", "a\xed\xa0\x80", "\x01", "\xf5\x80\x80\x80", "\xc0\x80"}) {
        mesh.fields = {};
        add_new_field(mesh, Entity::face, name, 1, false, {1});
        EXPECT_FALSE(parse_vtu(print_vtu(mesh)).fields.empty()) << name;
    }
}

} // namespace
} // namespace alphamst::io
