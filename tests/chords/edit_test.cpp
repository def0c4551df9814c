#include "chords/edit.h"

#include <gtest/gtest.h>

#include "adapt/meshes.h"
#include "adapt/run.h"
#include "chord/table.h"
#include "mesh/grids.h"

namespace alphamst::chords {
namespace {

using namespace adapt::samples;

const Settings settings;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

TEST(CollapseChord, KeepsElementsUprightAndTheBoundaryInPlace) {
    mesh::QuadMesh mesh = grid(8, 8);
    std::vector<Patch> patches{{block(8, 2, 2, 6, 6), {}, 0}};
    insert_chords(mesh, patches, 2, settings, silent);
    const mesh::QuadMesh before = mesh;
    for (const chord::Row &row : chord::table(before, {}))
        if (row.reasons == 0) {
            mesh = before;
            mesh.reset_origins();
            const Outcome outcome = collapse_chord(mesh, row.edge, {}, settings, silent);
            mesh.check();
            EXPECT_EQ(outcome.faces_after, before.n_faces() - row.length);
            EXPECT_EQ(outcome.singular_after, row.singular_after);
            for (int v = 0; v < mesh.n_vertices(); ++v)
                if (mesh.on_boundary(v)) {
                    EXPECT_EQ(mesh.point(v), before.point(mesh.vertex_origin[at(v)]));
                }
        }
}
TEST(SplitChord, CutsEveryFaceOfTheRow) {
    const mesh::QuadMesh before = grid(6, 4);
    for (const int copies : {1, 3}) {
        mesh::QuadMesh mesh = before;
        const int edge = mesh.find_edge(0, 1); // of the column i = 0, of 4 faces
        const Outcome outcome = split_chord(mesh, edge, copies, 1 << 20, {true}, settings, silent);
        mesh.check();
        EXPECT_EQ(outcome.faces_before, 24);
        EXPECT_EQ(outcome.faces_after, 24 + 4 * copies);
        EXPECT_EQ(mesh.n_faces(), 24 + 4 * copies);
        EXPECT_EQ(outcome.singular_after, 0);
    }
    mesh::QuadMesh mesh = before;
    const auto digest = mesh.checksum();
    EXPECT_EQ(mesh::failure_of([&] {
                  split_chord(mesh, mesh.find_edge(0, 1), 2, 31, {true}, settings, silent);
              }).fault,
              Fault::range);
    EXPECT_EQ(mesh.checksum(), digest);
}

} // namespace
} // namespace alphamst::chords
