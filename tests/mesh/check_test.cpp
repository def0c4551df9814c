#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Vertex = Kernel::VertexHandle;
using Halfedge = Kernel::HalfedgeHandle;
using Face = Kernel::FaceHandle;

// The mesh gives its kernel for reading; a fault must be forced in.
Failure after(const QuadMesh &good, void (*damage)(Kernel &, QuadMesh &)) {
    QuadMesh mesh = good;
    damage(const_cast<Kernel &>(mesh.kernel()), mesh);
    return failure_of([&] { mesh.check(); });
}

TEST(Check, AcceptsGoodMeshes) {
    EXPECT_NO_THROW(plane(4, 5).build().check());
    EXPECT_NO_THROW(torus(4, 5).build(3).check());
    EXPECT_NO_THROW(ell().build().check());
}

TEST(Check, FindsDamage) {
    const QuadMesh mesh = plane(3, 3).build();
    using Damage = void (*)(Kernel &, QuadMesh &);
    const Damage damages[] = {
        [](Kernel &k, QuadMesh &) { k.set_vertex_handle(Halfedge(6), Vertex(14)); },
        [](Kernel &k, QuadMesh &) { k.set_vertex_handle(Halfedge(6), Vertex(99)); },
        [](Kernel &k, QuadMesh &) { k.set_vertex_handle(Halfedge(6), Vertex(-1)); },
        [](Kernel &k, QuadMesh &) { k.set_next_halfedge_handle(Halfedge(4), Halfedge(20)); },
        [](Kernel &k, QuadMesh &) { k.set_prev_halfedge_handle(Halfedge(4), Halfedge(20)); },
        [](Kernel &k, QuadMesh &) { k.set_face_handle(Halfedge(4), Face(8)); },
        [](Kernel &k, QuadMesh &) { k.set_halfedge_handle(Face(0), k.halfedge_handle(Face(1))); },
        [](Kernel &k, QuadMesh &) { k.set_halfedge_handle(Face(0), Halfedge()); },
        [](Kernel &k, QuadMesh &) { k.set_halfedge_handle(Vertex(5), Halfedge()); },
        [](Kernel &k, QuadMesh &) { k.set_halfedge_handle(Vertex(5), k.halfedge_handle(Vertex(6))); },
        [](Kernel &k, QuadMesh &) {
            k.set_halfedge_handle(Vertex(1), k.ccw_rotated_halfedge_handle(k.halfedge_handle(Vertex(1))));
        },
        [](Kernel &k, QuadMesh &) { k.new_face(); },
        [](Kernel &k, QuadMesh &m) { k.new_face(), m.face_flags.push_back(0), m.face_origin.push_back(0); },
        [](Kernel &k, QuadMesh &m) {
            k.new_edge(Vertex(0), Vertex(5)), m.edge_flags.push_back(0), m.edge_origin.push_back(0);
        },
        [](Kernel &, QuadMesh &m) { m.edge_flags.pop_back(); },
        [](Kernel &, QuadMesh &m) { const_cast<int &>(m.faces()[4][2]) = 0; },
        [](Kernel &, QuadMesh &m) {
            auto &corners = const_cast<std::array<int, 4> &>(m.faces()[4]);
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        },
        [](Kernel &, QuadMesh &m) {
            m.edge_marker = {1, 2};
        }};
    for (const Damage damage : damages)
        EXPECT_EQ(after(mesh, damage).fault, Fault::internal) << "damage " << &damage - damages;
}

// Two squares glued to a third one along nothing but equal vertices: 0-1 twice.
TEST(Check, FindsDoubledEdge) {
    Grid grid = plane(3, 1);
    const QuadMesh mesh = grid.build();
    EXPECT_EQ(after(mesh,
                    [](Kernel &k, QuadMesh &) {
                        // Give the far end the ids of the near end: both ends now have the edge 0-4.
                        for (int i = 0; i < static_cast<int>(k.n_halfedges()); ++i) {
                            const int v = k.to_vertex_handle(Halfedge(i)).idx();
                            if (v == 3 || v == 7)
                                k.set_vertex_handle(Halfedge(i), Vertex(v - 3));
                        }
                        k.set_halfedge_handle(Vertex(3), Halfedge());
                        k.set_halfedge_handle(Vertex(7), Halfedge());
                    })
                  .fault,
              Fault::internal);
}

TEST(Check, FindsNotFinite) {
    QuadMesh mesh = plane(2, 2).build();
    mesh.set_point(7, {0, std::numeric_limits<double>::quiet_NaN(), 0});
    const Failure failure = failure_of([&] { mesh.check(); });
    EXPECT_EQ(failure.fault, Fault::not_finite);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{7}));
}

TEST(Check, FindsInvertedCornerInThePlaneOnly) {
    Grid grid = plane(3, 3);
    grid.points[3 * 5] += 1.5; // over the opposite edge of face 4
    const Failure failure = failure_of([&] { grid.build(2).check(); });
    EXPECT_EQ(failure.fault, Fault::argument);
    EXPECT_EQ(failure.entity, Entity::face);
    EXPECT_EQ(failure.ids.size(), 2u);
    EXPECT_NE(failure.text.find("inverted"), std::string::npos);
    EXPECT_NO_THROW(grid.build(3).check());

    Grid flat = plane(1, 1);
    flat.points[9] = flat.points[10] = 0.5; // on the diagonal
    EXPECT_EQ(failure_of([&] { flat.build(2).check(); }).fault, Fault::argument);
}

TEST(Checksum, EveryPartCounts) {
    const Grid grid = plane(3, 3);
    std::set<std::uint64_t> seen;
    int tried = 0;
    const auto add = [&](auto change) {
        QuadMesh mesh = grid.build();
        change(mesh);
        seen.insert(mesh.checksum());
        ++tried;
    };
    add([](QuadMesh &) {});
    add([](QuadMesh &m) { m.set_point(0, {0, 0, 1e-300}); });
    add([](QuadMesh &m) { m.set_point(0, {1e-300, 0, 0}); });
    add([](QuadMesh &m) { m.vertex_flags[0] = fixed; });
    add([](QuadMesh &m) { m.vertex_flags[0] = feature; });
    add([](QuadMesh &m) { m.vertex_flags[1] = fixed; });
    add([](QuadMesh &m) { m.edge_flags[0] = fixed; });
    add([](QuadMesh &m) { m.edge_flags[1] = fixed; });
    add([](QuadMesh &m) { m.face_flags[0] = fixed; });
    add([](QuadMesh &m) { m.face_marker.assign(9, 0), m.face_marker[3] = -1; });
    add([](QuadMesh &m) { m.edge_marker.assign(24, 0), m.edge_marker[3] = 1; });
    add([](QuadMesh &m) { m.edge_marker.assign(24, 0), m.edge_marker[4] = 1; });
    add([&](QuadMesh &m) { m = grid.build(3); });
    add([](QuadMesh &m) {
        Grid other = plane(3, 3);
        std::rotate(other.faces.begin(), other.faces.begin() + 1, other.faces.begin() + 4);
        m = other.build();
    });
    add([](QuadMesh &m) {
        Grid other = plane(3, 3);
        std::rotate(other.faces.begin(), other.faces.begin() + 4, other.faces.end());
        m = other.build();
    });
    EXPECT_EQ(seen.size(), std::size_t(tried));
}

TEST(Checksum, NoMarkersEqualZeroMarkers) {
    QuadMesh mesh = plane(3, 3).build();
    const auto before = mesh.checksum();
    mesh.edge_marker.assign(24, 0);
    mesh.face_marker.assign(9, 0);
    EXPECT_EQ(mesh.checksum(), before);
    mesh.vertex_origin[3] = -1;
    EXPECT_EQ(mesh.checksum(), before);
}

} // namespace
} // namespace alphamst::mesh
