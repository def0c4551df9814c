#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "grids.h"

namespace alphamst::mesh {
namespace {

using Quads = std::vector<std::array<int, 4>>;
using Points = std::vector<OpenMesh::Vec3d>;

struct Disk {
    std::vector<int> faces, loop, interior;
};

// The disk of a face set, by counting sides; an empty loop if it is none.
Disk disk_of(const QuadMesh &mesh, std::vector<int> faces) {
    std::set<std::array<int, 2>> sides;
    std::set<int> vertices;
    for (const int f : faces) {
        const auto c = mesh.corners(f);
        for (std::size_t i = 0; i < 4; ++i) {
            sides.insert({c[i], c[(i + 1) % 4]});
            vertices.insert(c[i]);
        }
    }
    std::map<int, int> next;
    std::size_t rim = 0;
    for (const auto &[v, w] : sides)
        if (!sides.contains({w, v})) {
            next[v] = w;
            ++rim;
        }
    Disk disk{std::move(faces), {}, {}};
    if (rim == 0 || next.size() != rim)
        return disk;
    std::vector<int> loop;
    int v = next.begin()->first;
    do {
        loop.push_back(v);
        v = next[v];
    } while (v != loop.front());
    const std::size_t edges = (sides.size() + rim) / 2;
    if (loop.size() != rim || vertices.size() + disk.faces.size() != edges + 1)
        return disk;
    disk.loop = loop;
    for (const int w : vertices)
        if (std::find(loop.begin(), loop.end(), w) == loop.end())
            disk.interior.push_back(w);
    return disk;
}

// The faces of the disk over local vertices: the loop, then its interior.
Quads own_quads(const QuadMesh &mesh, const Disk &disk) {
    std::map<int, int> local;
    for (const int v : disk.loop)
        local.emplace(v, static_cast<int>(local.size()));
    for (const int v : disk.interior)
        local.emplace(v, static_cast<int>(local.size()));
    Quads quads;
    for (const int f : disk.faces) {
        auto corners = mesh.corners(f);
        for (int &c : corners)
            c = local[c];
        quads.push_back(corners);
    }
    return quads;
}

Points own_points(const QuadMesh &mesh, const Disk &disk) {
    Points points;
    for (const int v : disk.interior)
        points.push_back(mesh.point(v));
    return points;
}

// Quad q becomes a smaller one inside and four around it.
void refine(Quads &quads, Points &points, std::size_t q, int n_loop) {
    const auto [a, b, c, d] = quads[q];
    const int e = n_loop + static_cast<int>(points.size()), f = e + 1, g = e + 2, h = e + 3;
    for (int i = 0; i < 4; ++i)
        points.push_back({0.1 * i, 0.7, static_cast<double>(points.size())});
    quads[q] = {e, f, g, h};
    quads.insert(quads.end(), {{a, b, f, e}, {b, c, g, f}, {c, d, h, g}, {d, a, e, h}});
}

void decorate(QuadMesh &mesh, unsigned seed) {
    std::mt19937 random(seed);
    mesh.edge_marker.resize(mesh.edge_flags.size());
    mesh.face_marker.resize(mesh.face_flags.size());
    for (auto *flags : {&mesh.vertex_flags, &mesh.edge_flags, &mesh.face_flags})
        for (auto &flag : *flags)
            flag = static_cast<std::uint8_t>(random() % 8);
    for (auto *markers : {&mesh.edge_marker, &mesh.face_marker})
        for (auto &marker : *markers)
            marker = static_cast<std::int32_t>(random() % 4);
}

std::size_t count_old(const std::vector<std::int32_t> &origins) {
    std::set<std::int32_t> distinct;
    std::size_t old = 0;
    for (const auto origin : origins)
        if (origin >= 0) {
            distinct.insert(origin);
            ++old;
        }
    EXPECT_EQ(distinct.size(), old) << "an origin occurs twice";
    return old;
}

// What came from `before` is as it was there, by the origins, and all of it came but the disk.
void expect_outside_kept(const QuadMesh &before, const QuadMesh &after, const Disk &disk) {
    ASSERT_EQ(count_old(after.vertex_origin), before.vertex_flags.size() - disk.interior.size());
    ASSERT_EQ(count_old(after.face_origin), before.face_flags.size() - disk.faces.size());
    const std::size_t inside = (4 * disk.faces.size() - disk.loop.size()) / 2;
    ASSERT_EQ(count_old(after.edge_origin), before.edge_flags.size() - inside);
    const auto origin = [&](int v) { return static_cast<int>(after.vertex_origin[std::size_t(v)]); };
    for (int v = 0; v < after.n_vertices(); ++v) {
        if (origin(v) < 0)
            continue;
        EXPECT_EQ(after.point(v), before.point(origin(v)));
        EXPECT_EQ(after.vertex_flags[std::size_t(v)], before.vertex_flags[std::size_t(origin(v))]);
        EXPECT_EQ(after.on_boundary(v), before.on_boundary(origin(v)));
    }
    for (std::size_t f = 0; f < after.face_flags.size(); ++f) {
        const auto o = after.face_origin[f];
        if (o < 0)
            continue;
        auto corners = after.corners(static_cast<int>(f));
        for (int &c : corners)
            c = origin(c);
        EXPECT_EQ(corners, before.corners(o));
        EXPECT_EQ(after.face_flags[f], before.face_flags[std::size_t(o)]);
        EXPECT_EQ(after.face_marker[f], before.face_marker[std::size_t(o)]);
    }
    for (std::size_t e = 0; e < after.edge_flags.size(); ++e) {
        const auto o = after.edge_origin[e];
        if (o < 0) {
            EXPECT_EQ(after.edge_flags[e], 0);
            EXPECT_EQ(after.edge_marker[e], 0);
            continue;
        }
        auto vertices = after.edge_vertices(static_cast<int>(e));
        for (int &v : vertices)
            v = origin(v);
        std::sort(vertices.begin(), vertices.end());
        EXPECT_EQ(vertices, before.edge_vertices(o));
        EXPECT_EQ(after.edge_flags[e], before.edge_flags[std::size_t(o)]);
        EXPECT_EQ(after.edge_marker[e], before.edge_marker[std::size_t(o)]);
    }
}

// Replaces, and looks at everything afterwards.
QuadMesh::Replaced replace(QuadMesh &mesh, const Disk &disk, const Quads &quads, const Points &points) {
    mesh.reset_origins();
    const QuadMesh before = mesh;
    const auto replaced = mesh.replace_disk(disk.faces, disk.loop, quads, points);
    EXPECT_NO_THROW(mesh.check());
    EXPECT_EQ(mesh.n_vertices() - mesh.n_edges() + mesh.n_faces(),
              before.n_vertices() - before.n_edges() + before.n_faces());
    EXPECT_EQ(replaced.faces.size(), quads.size());
    EXPECT_EQ(replaced.vertices.size(), points.size());
    std::map<int, int> local; // global id of the loop in the new mesh, by origin
    for (int v = 0; v < mesh.n_vertices(); ++v)
        for (std::size_t i = 0; i < disk.loop.size(); ++i)
            if (mesh.vertex_origin[std::size_t(v)] == disk.loop[i])
                local[static_cast<int>(i)] = v;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int v = replaced.vertices[i];
        local[static_cast<int>(disk.loop.size() + i)] = v;
        EXPECT_EQ(mesh.point(v), points[i]);
        EXPECT_EQ(mesh.vertex_flags[std::size_t(v)], 0);
        EXPECT_EQ(mesh.vertex_origin[std::size_t(v)], -1);
    }
    for (std::size_t q = 0; q < quads.size(); ++q) {
        auto corners = quads[q];
        for (int &c : corners)
            c = local[c];
        EXPECT_EQ(mesh.corners(replaced.faces[q]), corners);
        EXPECT_EQ(mesh.face_flags[std::size_t(replaced.faces[q])], 0);
        EXPECT_EQ(mesh.face_origin[std::size_t(replaced.faces[q])], -1);
    }
    expect_outside_kept(before, mesh, disk);
    return replaced;
}

const Quads four_from_corners{{0, 1, 2, 8}, {2, 3, 4, 8}, {4, 5, 6, 8}, {6, 7, 0, 8}};
const Quads three_in_a_row{{0, 1, 2, 3}, {0, 3, 4, 7}, {4, 5, 6, 7}};

Disk block(const QuadMesh &mesh) { // 2 x 2 in the middle of plane(4, 4), loop from its corner
    Disk disk = disk_of(mesh, {5, 6, 9, 10});
    std::rotate(disk.loop.begin(), std::find(disk.loop.begin(), disk.loop.end(), 6), disk.loop.end());
    return disk;
}

TEST(ReplaceDisk, BlockByFourOthers) {
    QuadMesh mesh = plane(4, 4).build(3);
    decorate(mesh, 1);
    const auto replaced = replace(mesh, block(mesh), four_from_corners, {{2.1, 2.1, 0}});
    EXPECT_EQ(replaced.faces, (std::vector{5, 6, 9, 10}));
    EXPECT_EQ(replaced.vertices, (std::vector{12}));
    EXPECT_EQ(mesh.singularities(), (std::vector{6, 7, 8, 11, 13, 16, 17, 18}));
}

TEST(ReplaceDisk, GapsAreFilledFromTheEnd) {
    QuadMesh mesh = plane(4, 4).build(3);
    decorate(mesh, 2);
    const auto replaced = replace(mesh, block(mesh), three_in_a_row, {});
    EXPECT_EQ(replaced.faces, (std::vector{5, 6, 9}));
    EXPECT_EQ(mesh.n_faces(), 15);
    EXPECT_EQ(mesh.n_vertices(), 24);
    EXPECT_EQ(mesh.face_origin[10], 15);
    EXPECT_EQ(mesh.vertex_origin[12], 24);
}

TEST(ReplaceDisk, GrowthAppends) {
    QuadMesh mesh = plane(4, 4).build(3);
    decorate(mesh, 3);
    const Disk disk = block(mesh);
    Quads quads = own_quads(mesh, disk);
    Points points = own_points(mesh, disk);
    refine(quads, points, 2, 8);
    const auto replaced = replace(mesh, disk, quads, points);
    EXPECT_EQ(replaced.faces, (std::vector{5, 6, 9, 10, 16, 17, 18, 19}));
    EXPECT_EQ(replaced.vertices, (std::vector{12, 25, 26, 27, 28}));
}

TEST(ReplaceDisk, FiveByOne) {
    QuadMesh mesh = plane(3, 3).build(3);
    const Disk middle = disk_of(mesh, {4});
    Quads quads = own_quads(mesh, middle);
    Points points;
    refine(quads, points, 0, 4);
    decorate(mesh, 4);
    auto faces = replace(mesh, middle, quads, points).faces;
    const Disk ring = disk_of(mesh, faces);
    ASSERT_EQ(ring.loop.size(), 4u);
    replace(mesh, ring, {{0, 1, 2, 3}}, {});
    EXPECT_EQ(mesh.n_faces(), 9);
    EXPECT_EQ(mesh.n_vertices(), 16);
}

TEST(ReplaceDisk, NewFacesInheritTheMostFrequentMarker) {
    QuadMesh mesh = plane(4, 4).build(3);
    mesh.face_marker.assign(16, 1);
    mesh.face_marker[5] = mesh.face_marker[10] = 7;
    mesh.face_marker[9] = 9;
    const auto replaced = mesh.replace_disk(block(mesh).faces, block(mesh).loop, three_in_a_row, {});
    for (const int f : replaced.faces)
        EXPECT_EQ(mesh.face_marker[std::size_t(f)], 7);
    EXPECT_TRUE(mesh.edge_marker.empty());
}

TEST(ReplaceDisk, WholeMesh) {
    QuadMesh mesh = plane(2, 2).build(3);
    decorate(mesh, 5);
    Disk disk = disk_of(mesh, {0, 1, 2, 3});
    replace(mesh, disk, four_from_corners, {{1, 1, 0}});
    disk = disk_of(mesh, {3, 1, 2, 0});
    std::rotate(disk.loop.begin(), disk.loop.begin() + 1, disk.loop.end());
    replace(mesh, disk, three_in_a_row, {});
    EXPECT_EQ(mesh.n_vertices(), 8);
    EXPECT_EQ(mesh.n_faces(), 3);
    for (int v = 0; v < 8; ++v)
        EXPECT_TRUE(mesh.on_boundary(v));
}

TEST(ReplaceDisk, LoopVertexOnTheBoundaryWithoutAnEdgeThere) {
    QuadMesh mesh = ell().build(3);
    decorate(mesh, 6);
    const Disk disk = disk_of(mesh, {0});
    Quads quads = own_quads(mesh, disk);
    Points points;
    refine(quads, points, 0, 4);
    replace(mesh, disk, quads, points);
    EXPECT_TRUE(mesh.on_boundary(4));
    EXPECT_EQ(mesh.valence(4), 5);
}

TEST(ReplaceDisk, ClosedSurfaceButOneFace) {
    QuadMesh mesh = Grid{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1},
                         {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7}}
                        .build(3);
    decorate(mesh, 7);
    replace(mesh, disk_of(mesh, {1, 2, 3, 4, 5}), {{0, 1, 2, 3}}, {}); // a pillow is left
    EXPECT_EQ(mesh.n_faces(), 2);
    EXPECT_EQ(mesh.n_vertices(), 4);
}

// A random face set that is a disk, grown from one face.
Disk random_disk(const QuadMesh &mesh, std::mt19937 &random) {
    for (;;) {
        std::vector<int> faces{static_cast<int>(random() % mesh.face_flags.size())};
        const std::size_t size = 1 + random() % 12;
        for (std::size_t tries = 0; faces.size() < size && tries < 60; ++tries) {
            const int next = mesh.neighbours(faces[random() % faces.size()])[random() % 4];
            if (next >= 0 && std::find(faces.begin(), faces.end(), next) == faces.end())
                faces.push_back(next);
        }
        if (Disk disk = disk_of(mesh, faces); !disk.loop.empty())
            return disk;
    }
}

void replace_at_random(QuadMesh mesh, unsigned seed, int runs) {
    std::mt19937 random(seed);
    decorate(mesh, seed);
    const int start = mesh.n_faces();
    int refused = 0, shrunk = 0, grown = 0;
    for (int run = 0; run < runs && !testing::Test::HasFailure(); ++run) {
        Disk disk = random_disk(mesh, random);
        std::rotate(disk.loop.begin(), disk.loop.begin() + static_cast<int>(random() % disk.loop.size()),
                    disk.loop.end());
        Quads quads = own_quads(mesh, disk);
        Points points = own_points(mesh, disk);
        if (disk.loop.size() == 8 && disk.faces.size() > 3) {
            quads = three_in_a_row;
            points.clear();
        } else if (disk.loop.size() == 4 && disk.faces.size() > 1) {
            quads = {{0, 1, 2, 3}};
            points.clear();
        } else if (disk.loop.size() == 6 && disk.faces.size() > 2) {
            quads = {{0, 1, 2, 5}, {2, 3, 4, 5}};
            points.clear();
        } else if (random() % 3 == 0 && mesh.n_faces() < 2 * start) {
            refine(quads, points, random() % quads.size(), static_cast<int>(disk.loop.size()));
        }
        std::shuffle(quads.begin(), quads.end(), random);
        for (auto &quad : quads)
            std::rotate(quad.begin(), quad.begin() + random() % 4, quad.end());
        std::shuffle(disk.faces.begin(), disk.faces.end(), random);
        const int before = mesh.n_faces();
        const auto checksum = mesh.checksum();
        try {
            QuadMesh trial = mesh;
            trial.replace_disk(disk.faces, disk.loop, quads, points);
        } catch (const Failure &failure) { // a chord that is outside already
            EXPECT_EQ(failure.entity, Entity::edge) << failure.text;
            EXPECT_LT(quads.size(), disk.faces.size()) << failure.text;
            EXPECT_ANY_THROW(mesh.replace_disk(disk.faces, disk.loop, quads, points));
            EXPECT_EQ(mesh.checksum(), checksum);
            ++refused;
            continue;
        }
        replace(mesh, disk, quads, points);
        shrunk += mesh.n_faces() < before ? 1 : 0;
        grown += mesh.n_faces() > before ? 1 : 0;
    }
    EXPECT_GT(shrunk, runs / 20);
    EXPECT_GT(grown, runs / 20);
    EXPECT_GT(refused, 0);
}

TEST(ReplaceDisk, ThousandAtRandomInThePlane) { replace_at_random(plane(9, 8).build(3), 1, 1000); }
TEST(ReplaceDisk, ThousandAtRandomOnATorus) { replace_at_random(torus(9, 8).build(3), 2, 1000); }

TEST(ReplaceDisk, SameCallsSameMesh) {
    const auto run = [] {
        std::mt19937 random(5);
        QuadMesh mesh = plane(8, 8).build(3);
        for (int i = 0; i < 50; ++i) {
            const Disk disk = random_disk(mesh, random);
            Quads quads = own_quads(mesh, disk);
            Points points = own_points(mesh, disk);
            refine(quads, points, 0, static_cast<int>(disk.loop.size()));
            mesh.replace_disk(disk.faces, disk.loop, quads, points);
        }
        return mesh.checksum();
    };
    EXPECT_EQ(run(), run());
}

class Refused : public testing::Test {
protected:
    QuadMesh mesh = plane(4, 4).build(3);
    Disk disk = block(mesh);
    Quads quads = four_from_corners;
    Points points{{2, 2, 0}};

    void expect_refused() {
        mesh.face_marker.assign(mesh.face_flags.size(), 3);
        const auto before = mesh.checksum();
        const auto origins = mesh.face_origin;
        const std::vector<std::array<int, 4>> faces(mesh.faces().begin(), mesh.faces().end());
        const int edges = mesh.n_edges();
        EXPECT_EQ(failure_of([&] { mesh.replace_disk(disk.faces, disk.loop, quads, points); }).fault,
                  Fault::internal);
        EXPECT_EQ(mesh.checksum(), before);
        EXPECT_EQ(mesh.face_origin, origins);
        EXPECT_TRUE(std::equal(faces.begin(), faces.end(), mesh.faces().begin(), mesh.faces().end()));
        EXPECT_EQ(mesh.n_edges(), edges);
        EXPECT_NO_THROW(mesh.check());
    }
};

TEST_F(Refused, NotThisOne) { EXPECT_NO_THROW(mesh.replace_disk(disk.faces, disk.loop, quads, points)); }
TEST_F(Refused, NoFaces) { disk.faces.clear(), expect_refused(); }
TEST_F(Refused, FaceOutOfRange) { disk.faces[0] = 16, expect_refused(); }
TEST_F(Refused, NegativeFace) { disk.faces[0] = -1, expect_refused(); }
TEST_F(Refused, FaceTwice) { disk.faces.push_back(5), expect_refused(); }
TEST_F(Refused, OtherFaces) { disk.faces[0] = 4, expect_refused(); }
TEST_F(Refused, FaceTooFew) { disk.faces.pop_back(), expect_refused(); }
TEST_F(Refused, FaceTooMany) { disk.faces.push_back(0), expect_refused(); }
TEST_F(Refused, LoopBackwards) { std::reverse(disk.loop.begin(), disk.loop.end()), expect_refused(); }
TEST_F(Refused, LoopVertexOutOfRange) { disk.loop[3] = 25, expect_refused(); }
TEST_F(Refused, LoopVertexTwice) { disk.loop[3] = disk.loop[5], expect_refused(); }
TEST_F(Refused, LoopEmpty) { disk.loop.clear(), expect_refused(); }
TEST_F(Refused, LoopTooLong) { disk.loop.push_back(0), expect_refused(); }
TEST_F(Refused, Annulus) {
    disk.faces = {0, 1, 2, 4, 6, 8, 9, 10};
    disk.loop = {0, 1, 2, 3, 8, 13, 18, 17, 16, 15, 10, 5};
    expect_refused();
}
TEST_F(Refused, NoQuads) { quads.clear(), points.clear(), expect_refused(); }
TEST_F(Refused, QuadMissing) { quads.pop_back(), expect_refused(); }
TEST_F(Refused, QuadTwice) { quads.push_back(quads[0]), expect_refused(); }
TEST_F(Refused, QuadReversed) { std::reverse(quads[1].begin(), quads[1].end()), expect_refused(); }
TEST_F(Refused, CornerOutOfRange) { quads[0][3] = 9, expect_refused(); }
TEST_F(Refused, NegativeCorner) { quads[0][3] = -1, expect_refused(); }
TEST_F(Refused, CornerTwice) { quads[0][3] = 1, expect_refused(); }
TEST_F(Refused, UnusedVertex) { points.push_back({2, 2, 0}), expect_refused(); }
TEST_F(Refused, NotFinite) {
    points[0][2] = std::numeric_limits<double>::infinity();
    expect_refused();
}
TEST_F(Refused, EdgeOfThreeQuads) {
    points.push_back({2, 2, 1});
    quads.push_back({0, 8, 2, 9});
    expect_refused();
}
TEST_F(Refused, ExtraPillow) { // two quads of their own that fit nothing else
    for (int i = 0; i < 4; ++i)
        points.push_back({0, 0, 0});
    quads.insert(quads.end(), {{9, 10, 11, 12}, {12, 11, 10, 9}});
    expect_refused();
}
TEST_F(Refused, ExtraTorus) { // Euler number 1, but not in one piece
    for (int i = 0; i < 9; ++i)
        points.push_back({0, 0, 0});
    const Grid extra = torus(3, 3);
    for (std::size_t c = 0; c < extra.faces.size(); c += 4)
        quads.push_back(
            {9 + extra.faces[c], 9 + extra.faces[c + 1], 9 + extra.faces[c + 2], 9 + extra.faces[c + 3]});
    expect_refused();
}
TEST_F(Refused, PinchedNewVertex) { // a pillow that hangs on vertex 8 only
    for (int i = 0; i < 3; ++i)
        points.push_back({0, 0, 0});
    quads.insert(quads.end(), {{8, 9, 10, 11}, {11, 10, 9, 8}});
    expect_refused();
}
TEST_F(Refused, ChordThatIsOutside) {
    // A U of five squares around face 4; the edge 5-6 that would close it is outside.
    mesh = plane(3, 3).build(3);
    disk = disk_of(mesh, {3, 6, 7, 8, 5});
    disk.loop = {5, 9, 10, 6, 7, 11, 15, 14, 13, 12, 8, 4};
    quads = {{0, 1, 2, 3}, {0, 3, 4, 11}, {11, 4, 5, 10}, {10, 5, 6, 9}, {9, 6, 7, 8}};
    points.clear();
    const auto failure = failure_of([&] { mesh.replace_disk(disk.faces, disk.loop, quads, points); });
    EXPECT_EQ(failure.entity, Entity::edge);
    EXPECT_EQ(failure.ids, (std::vector<std::int64_t>{mesh.find_edge(5, 6)}));
    expect_refused();
}

} // namespace
} // namespace alphamst::mesh
