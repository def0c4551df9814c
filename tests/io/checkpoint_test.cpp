#include "io/checkpoint.h"

#include <gtest/gtest.h>

#include "index.h"
#include "io/sections.h"
#include "samples.h"
#include "surface/boundary_curve.h"
#include "surface/curve.h"
#include "surface/surface.h"

namespace alphamst::io {
namespace {

using Eigen::Vector3d;
using mesh::QuadMesh;
using samples::failure_of;

// With all that a mesh can have.
QuadMesh full() {
    const Arrays arrays = samples::grid(3, 3);
    QuadMesh mesh = QuadMesh::build(3, arrays.points, arrays.faces);
    mesh.vertex_flags[2] = mesh::corner;
    mesh.edge_flags[5] = mesh::feature;
    mesh.face_flags[8] = mesh::fixed;
    mesh.edge_marker.assign(24, 0);
    mesh.edge_marker[3] = -7;
    mesh.curve_numbers = true;
    mesh.names = {{{Entity::edge, -7}, "a rim"}, {{Entity::face, 9}, "\xc3\xa9"}};
    for (const Entity entity : {Entity::vertex, Entity::edge, Entity::face}) {
        const int n = entity == Entity::vertex ? 16 : entity == Entity::edge ? 24 : 9;
        auto field = std::make_shared<mesh::Field>();
        *field = {entity, "the field", 2, mesh::Carry::inherit, std::vector<double>(at(2 * n), 0.1)};
        field->values.back() = -0.0;
        mesh.fields.set(std::move(field));
    }
    mesh.surface = std::make_shared<const surface::Surface>(
        std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, std::vector<std::array<int, 3>>{{0, 1, 2}});
    mesh.curves = std::make_shared<const surface::Curves>(
        std::span<const Vector3d>(), std::span<const std::array<int, 2>>(), 0.25,
        std::vector<surface::Line>{{Vector3d(0, 0, 0), Vector3d(1, 0, 0)}});
    mesh.boundary = std::make_shared<const surface::BoundaryCurves>(
        std::vector<std::vector<Vector3d>>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    return mesh;
}

const History history{4, 9, {{1, 2}}, {{3, 4, 5}}};

TEST(Checkpoint, HasAllOfAMesh) {
    const QuadMesh mesh = full();
    const std::string bytes = print_checkpoint(mesh, history);
    const Checkpoint back = parse_checkpoint(bytes);
    EXPECT_EQ(back.mesh->checksum(), mesh.checksum());
    EXPECT_EQ(back.mesh->names, mesh.names);
    EXPECT_TRUE(back.mesh->curve_numbers);
    EXPECT_TRUE(back.mesh->face_marker.empty());
    EXPECT_EQ(back.history.revision, 4);
    EXPECT_EQ(back.history.last_revision, 9);
    EXPECT_EQ(back.history.crossed, history.crossed);
    EXPECT_EQ(back.history.split, history.split);
    EXPECT_EQ(back.mesh->surface->points(), mesh.surface->points());
    EXPECT_EQ(back.mesh->curves->tolerance(), 0.25);
    EXPECT_EQ(back.mesh->boundary->points(0), mesh.boundary->points(0));
    // Nothing is lost that the file has.
    EXPECT_EQ(print_checkpoint(*back.mesh, back.history), bytes);
}

TEST(Checkpoint, KeepsIdsThatNoFileOfFacesHas) {
    const Arrays arrays = samples::grid(3, 3);
    QuadMesh mesh = QuadMesh::build(3, arrays.points, arrays.faces);
    // The square in the middle is cut into five: edges get ids in another order than of their vertices.
    const std::vector<int> face{4}, loop{5, 6, 10, 9};
    const std::vector<std::array<int, 4>> quads{
        {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
    const std::array<double, 4> at_x{0.4, 0.6, 0.6, 0.4}, at_y{0.4, 0.4, 0.6, 0.6};
    std::vector<OpenMesh::Vec3d> points;
    for (std::size_t i = 0; i < 4; ++i)
        points.emplace_back(at_x[i], at_y[i], 0);
    mesh.replace_disk(face, loop, quads, points);
    mesh.reset_origins();
    const Checkpoint back = parse_checkpoint(print_checkpoint(mesh, {}));
    for (int e = 0; e < mesh.n_edges(); ++e) {
        EXPECT_EQ(back.mesh->edge_vertices(e), mesh.edge_vertices(e));
        EXPECT_EQ(back.mesh->edge_faces(e), mesh.edge_faces(e));
    }
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        EXPECT_EQ(back.mesh->faces_around(v), mesh.faces_around(v));
        EXPECT_EQ(back.mesh->vertices_around(v), mesh.vertices_around(v));
    }
    const Arrays again = samples::grid(3, 3);
    const QuadMesh other = QuadMesh::build(3, again.points, again.faces);
    EXPECT_NE(other.connectivity().sides, back.mesh->connectivity().sides);
    EXPECT_EQ(mesh.connectivity().sides, back.mesh->connectivity().sides);
}

TEST(Checkpoint, EveryDamageIsFound) {
    const std::string bytes = print_checkpoint(full(), history);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 4);
        EXPECT_TRUE(failure_of([&] { parse_checkpoint(damaged); }).text.starts_with("byte ")) << i;
    }
    for (std::size_t n = 0; n < bytes.size(); n += 5)
        EXPECT_EQ(failure_of([&] { parse_checkpoint(bytes.substr(0, n)); }).fault, Fault::format);
}

// Sections that are sound and do not fit together: from somebody else's program.
TEST(Checkpoint, WhatIsNoMeshIsRefused) {
    const auto file_of = [](const std::vector<std::int32_t> &faces, const std::vector<std::int32_t> &sides,
                            const std::vector<std::int32_t> &first) {
        SectionWriter to;
        to.add("head", std::vector<std::int64_t>{2, 0, 0, 0, 0, 0, 0, 0});
        to.add("pnts", std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
        to.add("face", faces);
        to.add("side", sides);
        to.add("frst", first);
        return to.finished();
    };
    const auto text_of = [](const std::string &file) {
        return failure_of([&] { parse_checkpoint(file); }).text;
    };
    const std::vector<std::int32_t> faces{0, 1, 2, 3};
    EXPECT_NE(text_of(file_of({0, 1, 2, 4}, {0, 2, 4, 6}, {0, 2, 4, 6})).find("make no mesh"),
              std::string::npos);
    EXPECT_NE(text_of(file_of(faces, {0, 2, 4, 4}, {0, 2, 4, 6})).find("half-edge of another edge"),
              std::string::npos);
    EXPECT_NE(text_of(file_of(faces, {0, 2, 4, 8}, {0, 2, 4, 6})).find("not in the mesh"), std::string::npos);
    EXPECT_NE(text_of(file_of(faces, {0, 2, 4, 6}, {0, 2, 4, 99})).find("walks around vertex"),
              std::string::npos);
    EXPECT_NE(text_of(file_of(faces, {0, 2, 4, 6}, {0, 2, 4})).find("one half-edge for each corner"),
              std::string::npos);
}

} // namespace
} // namespace alphamst::io
