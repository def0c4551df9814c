#include "run.h"

namespace alphamst::adapt::samples {
namespace {

Outcome reduce(mesh::QuadMesh &mesh, std::vector<int> &faces) {
    std::vector<Patch> regions(1);
    regions[0].faces = faces;
    const Outcome outcome = reduce_singularities(mesh, regions, {}, silent).at(0);
    faces = regions[0].faces;
    return outcome;
}

// Turns edges inside the faces, so that there are more singular vertices, and reduces.
void expect_least(mesh::QuadMesh mesh, std::vector<int> faces, std::int64_t least, int turns, unsigned seed) {
    std::mt19937 random(seed);
    turn_edges(mesh, faces, turns, random);
    relax(mesh, 60);
    mesh.reset_origins();
    ASSERT_NO_THROW(mesh.check());
    ASSERT_GT(singular_in(mesh, faces), least);
    const mesh::QuadMesh before = mesh;
    const std::vector<int> patch = faces;
    const Outcome outcome = reduce(mesh, faces);
    ASSERT_FALSE(outcome.fault) << outcome.text;
    EXPECT_NO_THROW(mesh.check());
    EXPECT_EQ(outcome.singular_before, singular_in(before, patch));
    EXPECT_EQ(outcome.singular_after, singular_in(mesh, faces));
    EXPECT_EQ(outcome.singular_after, least);
    EXPECT_LE(outcome.singular_bound, least);
    EXPECT_EQ(faces, new_ones(mesh.face_origin));
    expect_outside_kept(before, mesh, {patch});
}

// The rectangle in the middle of a grid, whole and with parts cut out of its corners and
// sides: each can be regular.
TEST(Reduce, CleansRectanglesWithCutOuts) {
    constexpr int n = 16;
    const std::vector<int> whole = block(n, 3, 3, 13, 13);
    const auto without = [&](const std::vector<int> &cut) {
        std::vector<int> faces = whole;
        std::erase_if(faces, [&](int f) { return std::find(cut.begin(), cut.end(), f) != cut.end(); });
        return faces;
    };
    std::vector<int> stairs = block(n, 10, 3, 13, 5), tee = block(n, 3, 3, 6, 6);
    for (const int f : block(n, 12, 5, 13, 8))
        stairs.push_back(f);
    for (const int f : block(n, 10, 3, 13, 6))
        tee.push_back(f);
    const std::vector<int> shapes[] = {whole, without(block(n, 9, 9, 13, 13)), without(stairs), without(tee)};
    for (std::size_t shape = 0; shape < std::size(shapes); ++shape)
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE("shape " + std::to_string(shape) + ", seed " + std::to_string(seed));
            expect_least(grid(n, n), shapes[shape], 0, 4, seed);
        }
}

// Polygons of equal sides within a larger mesh: one singular vertex for 3 and 5 sides, two of
// valence 5 for 6.
TEST(Reduce, ReachesTheLeastOfPolygons) {
    for (const auto &[n, least] : {std::pair(3, 1), {4, 0}, {5, 1}, {6, 2}})
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(std::to_string(n) + " sides, seed " + std::to_string(seed));
            constexpr int m = 6;
            std::vector<int> faces;
            for (int sector = 0; sector < n; ++sector)
                for (const int f : block(m, 0, 0, 4, 4))
                    faces.push_back(sector * m * m + f);
            expect_least(star(n, m), faces, least, 3, seed);
        }
}

TEST(Reduce, NeverAdds) {
    const mesh::QuadMesh mesh = unstructured(30, 21);
    std::mt19937 random(22);
    for (int i = 0; i < 12; ++i) {
        SCOPED_TRACE(i);
        std::vector<int> faces = random_patch(mesh, 20, 150, random);
        const std::vector<int> patch = faces;
        mesh::QuadMesh after = mesh;
        const Outcome outcome = reduce(after, faces);
        EXPECT_FALSE(outcome.fault) << outcome.text;
        EXPECT_NO_THROW(after.check());
        EXPECT_LE(outcome.singular_after, outcome.singular_before);
        EXPECT_GE(outcome.singular_after, outcome.singular_bound);
        EXPECT_EQ(outcome.singular_after, singular_in(after, faces));
        if (after.checksum() == mesh.checksum()) // nothing could be gained
            EXPECT_EQ(outcome.singular_after, outcome.singular_before);
        else
            expect_outside_kept(mesh, after, {patch});
        const Outcome again = reduce(after, faces);
        EXPECT_LE(again.singular_after, outcome.singular_after);
    }
}

TEST(Reduce, RefusesWhatIsHeld) {
    mesh::QuadMesh mesh = grid(8, 8);
    mesh.vertex_flags[4 * 9 + 4] = mesh::feature;
    const auto before = mesh.checksum();
    std::vector<int> faces = block(8, 2, 2, 6, 6);
    EXPECT_EQ(reduce(mesh, faces).fault, Fault::patch);
    EXPECT_EQ(mesh.checksum(), before);
}

} // namespace
} // namespace alphamst::adapt::samples
