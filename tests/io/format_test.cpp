#include <gtest/gtest.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <limits>

#include "io/arrays.h"
#include "samples.h"

namespace alphamst::io {
namespace {

using samples::failure_of;

TEST(Format, EveryFormatKeepsEveryBit) {
    const samples::Folder folder;
    for (int dim : {2, 3}) {
        Arrays mesh = samples::grid(4, dim);
        mesh.points[0] = -0.0;
        mesh.points[1] = std::numeric_limits<double>::denorm_min();
        mesh.points[3] = std::numeric_limits<double>::max();
        mesh.points.insert(mesh.points.end(), {-1.0 / 3, 1e-300, 0}); // a vertex without a face
        for (const char *name : {"m.off", "m.obj", "m.ply", "m.msh", "m.vtk", "M.VTK", "a.b/m.Off"}) {
            if (std::string(name).find('/') != std::string::npos)
                std::filesystem::create_directories(folder / "a.b");
            write(folder / name, mesh);
            const Arrays back = read(folder / name);
            EXPECT_TRUE(samples::same_bits(back.points, mesh.points)) << name;
            EXPECT_EQ(back.faces, mesh.faces) << name;
            EXPECT_EQ(back.dim, dim) << name;
        }
    }
}

TEST(Format, OpenMeshReadsWhatIsWritten) {
    const samples::Folder folder;
    const Arrays mesh = samples::cube();
    for (const char *name : {"m.off", "m.obj", "m.ply"}) {
        write(folder / name, mesh);
        OpenMesh::PolyMesh_ArrayKernelT<> other;
        ASSERT_TRUE(OpenMesh::IO::read_mesh(other, folder / name)) << name;
        ASSERT_EQ(other.n_vertices(), 8u) << name;
        ASSERT_EQ(other.n_faces(), 6u) << name;
        for (int v = 0; v < 8; ++v)
            for (unsigned k = 0; k < 3; ++k)
                EXPECT_EQ(double{other.point(OpenMesh::VertexHandle(v))[k]},
                          mesh.points[static_cast<std::size_t>(v) * 3 + k]);
    }
}

TEST(Format, KnowsItsExtensions) {
    const samples::Folder folder;
    for (const char *name : {"m.stl", "m", "m.", "x.off/m", "m.svg"})
        EXPECT_EQ(failure_of([&] { read(folder / name); }).fault, Fault::unsupported) << name;
    for (const char *name : {"m.stl", "m"})
        EXPECT_EQ(failure_of([&] { write(folder / name, samples::cube()); }).fault, Fault::unsupported)
            << name;
    EXPECT_EQ(failure_of([&] { read(folder / "m.off"); }).fault, Fault::io);
}

TEST(Format, SaysWhichMarkersItHasNoPlaceFor) {
    const samples::Folder folder;
    Arrays mesh = samples::cube();
    for (const char *name : {"m.off", "m.msh", "m.su2", "m.vtk"})
        EXPECT_TRUE(write(folder / name, mesh).empty()) << name;
    mesh.face_marker = {0, 0, 3, 3, 3, 0};
    mesh.marked_edges = {{{0, 1}, 7}};
    mesh.marked_points = {{5, 1}, {6, 1}};
    mesh.names = {{{Entity::edge, 7}, "rim"}, {{Entity::face, 3}, "top"}};
    using Remarks = std::vector<std::string>;
    EXPECT_EQ(write(folder / "m.msh", mesh), Remarks());
    EXPECT_EQ(write(folder / "m.vtk", mesh), Remarks());
    EXPECT_EQ(write(folder / "m.vtu", mesh), Remarks());
    EXPECT_EQ(write(folder / "m.su2", mesh), Remarks({".su2 has no place for 3 markers of faces",
                                                      ".su2 has no place for 2 markers of vertices",
                                                      ".su2 has no place for 1 names of markers"}));
    EXPECT_EQ(
        write(folder / "m.off", mesh),
        Remarks({".off has no place for 1 markers of edges", ".off has no place for 3 markers of faces",
                 ".off has no place for 2 markers of vertices", ".off has no place for 2 names of markers"}));
    mesh.marked_points = {{8, 1}};
    EXPECT_EQ(failure_of([&] { write(folder / "m.msh", mesh); }).fault, Fault::range);
}

TEST(Format, WritesNoMeshThatItCouldNotRead) {
    const samples::Folder folder;
    Arrays mesh = samples::cube();
    mesh.points[5] = std::numeric_limits<double>::quiet_NaN();
    Failure failure = failure_of([&] { write(folder / "m.off", mesh); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{1});
    mesh = samples::cube();
    mesh.faces[9] = 8;
    failure = failure_of([&] { write(folder / "m.vtk", mesh); });
    EXPECT_EQ(failure.fault, Fault::range);
    EXPECT_EQ(failure.ids, std::vector<std::int64_t>{2});
    mesh = samples::cube();
    mesh.face_marker = {1};
    EXPECT_EQ(failure_of([&] { write(folder / "m.off", mesh); }).fault, Fault::argument);
    EXPECT_EQ(folder.size(), 0u);
}

} // namespace
} // namespace alphamst::io
