#include "chord/table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "chord/meshes.h"

namespace alphamst::chord {
namespace {

TEST(Table, EveryChordHasARowWithItsNumbers) {
    for (const auto &[name, mesh] : samples::kinds()) {
        const std::vector<Row> rows = table(mesh, {});
        const Labels labels = label(mesh);
        ASSERT_EQ(rows.size(), labels.first.size()) << name;
        int faces = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row &row = rows[i];
            const Chord chord = trace(mesh, labels.first[i]);
            EXPECT_EQ(row.edge, labels.first[i]) << name;
            EXPECT_EQ(row.closed, chord.closed) << name;
            EXPECT_EQ(row.crossings, chord.crossings) << name;
            EXPECT_EQ(row.touches, chord.touches) << name;
            std::set<int> singular;
            for (const int side : chord.sides)
                for (const int v : mesh.edge_vertices(side / 2))
                    if (mesh.singular(v))
                        singular.insert(v);
            EXPECT_EQ(row.singularities, static_cast<int>(singular.size())) << name;
            faces += row.length;
        }
        EXPECT_EQ(faces, 2 * mesh.n_faces()) << name; // each is on two chords or twice on one
    }
}

// What the table says of the mesh without a chord is what is there when it is gone.
TEST(Table, SingularVerticesAreThoseLeftBehind) {
    int collapsed = 0, kept = 0;
    for (const auto &[name, mesh] : samples::kinds())
        for (const bool boundary : {false, true}) {
            const Rules rules{.boundary = boundary};
            for (const Row &row : table(mesh, rules)) {
                const Chord chord = trace(mesh, row.edge);
                const Collapse verdict = Judge(mesh, rules)(chord);
                EXPECT_EQ(row.reasons, verdict.reasons) << name;
                if (row.reasons != 0) {
                    EXPECT_EQ(row.singular_after, static_cast<int>(mesh.singularities().size())) << name;
                    ++kept;
                    continue;
                }
                std::vector<std::array<int, 2>> merged;
                for (const Group &group : verdict.groups)
                    for (const int other : group.others)
                        merged.push_back({other, group.survivor});
                mesh::QuadMesh rest = mesh;
                rest.collapse_chord(chord.sides, merged);
                EXPECT_EQ(row.singular_after, static_cast<int>(rest.singularities().size())) << name;
                EXPECT_EQ(rest.n_faces(), mesh.n_faces() - row.length) << name;
                ++collapsed;
            }
        }
    EXPECT_GT(collapsed, 30);
    EXPECT_GT(kept, 30);
}

TEST(Table, RulesDecideOnTheBoundary) {
    const mesh::QuadMesh mesh = samples::grid(4, 3);
    const auto free = [](const std::vector<Row> &rows) {
        return std::count_if(rows.begin(), rows.end(), [](const Row &row) { return row.reasons == 0; });
    };
    EXPECT_EQ(free(table(mesh, {})), 0);
    EXPECT_GT(free(table(mesh, {.boundary = true})), 0);
}

} // namespace
} // namespace alphamst::chord
