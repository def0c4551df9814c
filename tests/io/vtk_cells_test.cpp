#include "io/vtk_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/fields.h"
#include "samples.h"

namespace alphamst::io::vtk {
namespace {

Arrays marked() {
    Arrays mesh = samples::grid(2, 3);
    mesh.face_marker = {1, 0, 3, 4};
    mesh.marked_edges = {{{0, 1}, 5}, {{1, 2}, 0}};
    mesh.marked_points = {{8, 6}};
    add_new_field(mesh, Entity::face, "energy", 2, false, {1, 2, 3, 4, 5, 6, 7, 8});
    add_new_field(mesh, Entity::vertex, "t", 1, false, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    return mesh;
}

TEST(VtkCells, FacesLinesAndPointsInOrder) {
    const DataSet data = data_set_of(marked());
    EXPECT_EQ(data.types, (std::vector<std::int64_t>{9, 9, 9, 9, 3, 1}));
    EXPECT_EQ(data.cells.offsets, (std::vector<std::int64_t>{0, 4, 8, 12, 16, 18, 19}));
    ASSERT_EQ(data.of_cells.size(), 2u);
    EXPECT_EQ(data.of_cells[0].values, (std::vector<double>{1, 0, 3, 4, 5, 6}));
    EXPECT_EQ(data.of_cells[1].values.size(), 12u);
    EXPECT_TRUE(std::isnan(data.of_cells[1].values[8]));
}

TEST(VtkCells, ThereAndBack) {
    const Arrays mesh = marked();
    Arrays back;
    back.points = mesh.points;
    const Scanner scan("");
    add_data_set(scan, data_set_of(mesh), back);
    EXPECT_EQ(back.faces, mesh.faces);
    EXPECT_EQ(back.face_marker, mesh.face_marker);
    EXPECT_EQ(back.marked_edges.size(), 1u);
    EXPECT_EQ(back.marked_points.size(), 1u);
    EXPECT_EQ(back.fields.find(Entity::face, "energy")->values,
              mesh.fields.find(Entity::face, "energy")->values);
    EXPECT_EQ(back.fields.find(Entity::vertex, "t")->values, mesh.fields.find(Entity::vertex, "t")->values);
    EXPECT_TRUE(back.remarks.empty());
}

TEST(VtkCells, DataOfAnotherLengthAreToldAndLeftOut) {
    Arrays mesh = samples::grid(1, 2), back;
    back.points = mesh.points;
    DataSet data = data_set_of(mesh);
    data.of_points.push_back({"short", 1, false, {1, 2, 3}});
    const Scanner scan("");
    add_data_set(scan, data, back);
    EXPECT_EQ(back.remarks, std::vector<std::string>{"the data 'short' are not 4 and are left out"});
    EXPECT_TRUE(back.fields.empty());
}

TEST(VtkCells, OffsetsAscend) {
    const Scanner scan("");
    CellArray cells;
    cells.connectivity = {0, 1, 2, 3};
    for (const std::vector<std::int64_t> &offsets :
         {std::vector<std::int64_t>{0, 5}, {1, 4}, {0, 3, 2, 4}, {0, -1, 4}, {0}}) {
        cells.offsets = offsets;
        EXPECT_EQ(samples::failure_of([&] { require_ascending(scan, cells); }).fault, Fault::format);
    }
    cells.offsets = {0, 2, 4};
    require_ascending(scan, cells);
}

} // namespace
} // namespace alphamst::io::vtk
