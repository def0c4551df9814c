#include "chord/trace.h"

#include <algorithm>
#include <array>

#include "chord/step.h"

namespace alphamst::chord {
namespace {

// Numbers that are in the list more than once, each counted once.
int repeated(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    int count = 0;
    for (std::size_t i = 1; i < numbers.size(); ++i)
        count += numbers[i] == numbers[i - 1] && (i == 1 || numbers[i - 2] != numbers[i]);
    return count;
}

// Follows the chord from a half-edge to the boundary or round to where it began.
void follow(const mesh::Kernel &kernel, int from, Chord &chord) {
    int side = from;
    do {
        chord.sides.push_back(side);
        const int face = kernel.face_handle(Halfedge(side)).idx();
        if (face < 0)
            return;
        chord.faces.push_back(face);
        side = ahead(kernel, side);
    } while (side != from);
    chord.closed = true;
}

// [half-edge] The next side of the chord, -1 from the boundary. In one go through the faces, as chords jump
// about in memory and each jump of theirs shall cost one access, not three.
std::vector<int> all_ahead(const mesh::QuadMesh &mesh) {
    const mesh::Kernel &kernel = mesh.kernel();
    std::vector<int> next(2 * static_cast<std::size_t>(mesh.n_edges()), -1);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        std::array<int, 4> sides;
        Halfedge side = kernel.halfedge_handle(mesh::Kernel::FaceHandle(f));
        for (int &s : sides) {
            s = side.idx();
            side = kernel.next_halfedge_handle(side);
        }
        for (std::size_t k = 0; k < 4; ++k)
            next[static_cast<std::size_t>(sides[k])] = sides[(k + 2) % 4] ^ 1;
    }
    return next;
}

} // namespace

Chord trace(const mesh::QuadMesh &mesh, int edge) {
    const mesh::Kernel &kernel = mesh.kernel();
    Chord chord;
    follow(kernel, 2 * edge, chord);
    if (!chord.closed) {
        // Once more from the end that was found, and from the other one if its edge is smaller.
        int end = chord.sides.back() ^ 1;
        chord = {};
        follow(kernel, end, chord);
        if (chord.sides.back() / 2 < end / 2) {
            end = chord.sides.back() ^ 1;
            chord = {};
            follow(kernel, end, chord);
        }
    }
    chord.crossings = repeated(chord.faces);
    std::vector<int> ends;
    ends.reserve(2 * chord.sides.size());
    for (const int side : chord.sides) {
        ends.push_back(kernel.to_vertex_handle(Halfedge(side)).idx());
        ends.push_back(kernel.to_vertex_handle(Halfedge(side ^ 1)).idx());
    }
    chord.touches = repeated(std::move(ends));
    return chord;
}

Labels label(const mesh::QuadMesh &mesh) {
    const std::vector<int> next = all_ahead(mesh);
    Labels labels;
    labels.of_edge.assign(static_cast<std::size_t>(mesh.n_edges()), -1);
    const auto walk = [&](int side, int number) {
        for (side = next[static_cast<std::size_t>(side)]; side >= 0;
             side = next[static_cast<std::size_t>(side)]) {
            int &of_edge = labels.of_edge[static_cast<std::size_t>(side / 2)];
            if (of_edge == number) // closed
                return true;
            of_edge = number;
        }
        return false;
    };
    for (int edge = 0; edge < mesh.n_edges(); ++edge) {
        if (labels.of_edge[static_cast<std::size_t>(edge)] >= 0)
            continue;
        const int number = static_cast<int>(labels.first.size());
        labels.first.push_back(edge);
        labels.of_edge[static_cast<std::size_t>(edge)] = number;
        if (!walk(2 * edge, number))
            walk(2 * edge + 1, number);
    }
    return labels;
}

} // namespace alphamst::chord
