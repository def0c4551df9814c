#include "chord/table.h"

#include <algorithm>

namespace alphamst::chord {
namespace {

int singularities_on(const mesh::QuadMesh &mesh, const Chord &chord) {
    std::vector<int> singular;
    for (const int side : chord.sides)
        for (const int v : mesh.edge_vertices(side / 2))
            if (mesh.singular(v))
                singular.push_back(v);
    std::sort(singular.begin(), singular.end());
    return static_cast<int>(std::unique(singular.begin(), singular.end()) - singular.begin());
}

} // namespace

std::vector<Row> table(const mesh::QuadMesh &mesh, const Rules &rules) {
    const int singular = static_cast<int>(mesh.singularities().size());
    Judge judge(mesh, rules);
    std::vector<Row> rows;
    for (const int edge : label(mesh).first) {
        const Chord chord = trace(mesh, edge);
        const Collapse verdict = judge(chord);
        Row row;
        row.edge = edge;
        row.closed = chord.closed;
        row.length = static_cast<int>(chord.length());
        row.crossings = chord.crossings;
        row.touches = chord.touches;
        row.singularities = singularities_on(mesh, chord);
        row.reasons = verdict.reasons;
        row.singular_after = singular + (verdict.reasons == 0 ? verdict.singular_change : 0);
        rows.push_back(row);
    }
    return rows;
}

} // namespace alphamst::chord
