#include "chords/edit.h"

#include "chords/faces.h"
#include "smooth/smooth.h"

namespace alphamst::chords {
namespace {

constexpr int layers = 2; // of faces around the chord that may give way

std::vector<int> vertices_of(const mesh::QuadMesh &mesh, const chord::Chord &chord) {
    std::vector<int> vertices;
    for (const int side : chord.sides)
        for (const int v : mesh.edge_vertices(side / 2))
            vertices.push_back(v);
    return vertices;
}

void smooth_around(mesh::QuadMesh &mesh, const std::vector<int> &faces, const Settings &settings,
                   const Progress &progress) {
    const std::vector<Patch> region{{faces, {}, 0}};
    smooth::smooth(mesh, &region, settings, progress);
}

[[noreturn]] void refuse(const char *what, const chord::Verdict &verdict) {
    throw Failure(Fault::chord, "the chord cannot be " + std::string(what) + ": " + verdict.text(),
                  verdict.entity, {verdict.where});
}

} // namespace

Outcome collapse_chord(mesh::QuadMesh &mesh, int edge, const chord::Rules &rules, const Settings &settings,
                       const Progress &progress) {
    const chord::Chord chord = chord::trace(mesh, edge);
    const chord::Collapse verdict = chord::Judge(mesh, rules)(chord);
    if (verdict.reasons != 0)
        refuse("collapsed", verdict);
    Account account(mesh);
    keep_surface(mesh);
    const std::int64_t before = inverted(mesh, faces_around(mesh, vertices_of(mesh, chord), layers));
    const std::int64_t wanted = mesh.n_faces() - static_cast<std::int64_t>(chord.length());
    std::vector<int> survivors;
    remove(mesh, chord, verdict, survivors);
    const std::vector<int> faces = faces_around(mesh, survivors, layers);
    smooth_around(mesh, faces, settings, progress);
    if (inverted(mesh, faces) > before)
        throw Failure(Fault::geometry, "without the chord no valid shape was found for the faces around it; "
                                       "it is left as it was");
    return account.close(mesh, wanted);
}

Outcome split_chord(mesh::QuadMesh &mesh, int edge, int copies, std::int64_t most_faces,
                    const chord::Rules &rules, const Settings &settings, const Progress &progress) {
    const chord::Chord chord = chord::trace(mesh, edge);
    const chord::Verdict verdict = chord::judge_split(mesh, chord, rules);
    if (verdict.reasons != 0)
        refuse("split", verdict);
    const double n = copies; // n * n may be more than an integer holds
    if (n * static_cast<double>(chord.length()) + n * n * chord.crossings >
        static_cast<double>(most_faces - mesh.n_faces()))
        throw Failure(Fault::range, "n is " + std::to_string(copies) +
                                        "; the mesh would have more faces than 32-bit ids can name");
    const std::int64_t wanted = mesh.n_faces() + chord::faces_added(chord, copies);
    Account account(mesh);
    keep_surface(mesh);
    const mesh::QuadMesh::Cut cut = mesh.split_chord(chord.sides, copies);
    const std::vector<int> faces = faces_around(mesh, cut.vertices, layers);
    const std::int64_t before = inverted(mesh, faces);
    smooth_around(mesh, faces, settings, progress);
    if (inverted(mesh, faces) > before)
        throw Failure(Fault::geometry, "no valid shape was found for the copies of the chord");
    return account.close(mesh, wanted);
}

} // namespace alphamst::chords
