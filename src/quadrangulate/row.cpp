#include "quadrangulate/row.h"

#include <algorithm>

#include "disjoint_sets.h"
#include "failure.h"
#include "index.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

// The rows that can be split at once, having no face in common.
class Rows {
public:
    explicit Rows(QuadArrays &quads)
        : quads_(quads),
          across_(across_edges(quads.faces, mesh::pair_sides(quads.faces, quads.points.size() / 3))),
          cuts_(quads.origin.size(), {-1, -1}), reached_(quads.origin.size(), -1), from_(quads.origin.size()),
          components_(quads.origin.size()), may_leave_(quads.origin.size()) {
        for (std::size_t c = 0; c < across_.size(); ++c)
            if (across_[c] > static_cast<std::int32_t>(c))
                components_.unite(static_cast<std::int32_t>(c / 4), across_[c] / 4);
        for (std::size_t f = 0; f < quads.origin.size(); ++f)
            if (mesh::is_triangle(quads.faces, f))
                may_leave_[components_.find(f)].flip();
    }

    // False if the way is blocked by the rows before.
    bool find(std::int32_t triangle) {
        if (cuts_[at(triangle)][0] >= 0)
            return true; // the end of one
        std::vector<std::int32_t> queue{triangle};
        reached_[at(triangle)] = triangle;
        for (std::size_t head = 0; head < queue.size(); ++head) {
            const std::int32_t face = queue[head];
            // Straight on first: the side across from where the row came in.
            const std::int32_t sides = mesh::is_triangle(quads_.faces, at(face)) ? 3 : 4;
            const std::int32_t first = face == triangle ? 0 : across_[at(from_[at(face)])] % 4 + 2;
            for (std::int32_t i = 0; i < sides; ++i) {
                const std::int32_t corner = 4 * face + (first + i) % sides, other = across_[at(corner)];
                if (other >= 0 && (reached_[at(other / 4)] == triangle || cuts_[at(other / 4)][0] >= 0))
                    continue;
                if (other < 0) {
                    if (!may_leave_[at(components_.find(face))])
                        continue;
                    may_leave_[at(components_.find(face))] = false;
                }
                if (other < 0 || mesh::is_triangle(quads_.faces, at(other / 4))) {
                    take(triangle, corner);
                    return true;
                }
                reached_[at(other / 4)] = triangle;
                from_[at(other / 4)] = corner;
                queue.push_back(other / 4);
            }
        }
        return false;
    }

    void split(std::vector<std::array<std::int32_t, 2>> &flat) {
        QuadArrays old;
        old.faces.swap(quads_.faces);
        old.origin.swap(quads_.origin);
        quads_.faces.reserve(old.faces.size());
        quads_.origin.reserve(old.origin.size());
        vertex_.assign(old.faces.size(), -1);
        for (std::size_t f = 0; f < old.origin.size(); ++f)
            split(old, f, flat);
    }

private:
    // Notes the sides that the row through this last corner crosses.
    void take(std::int32_t triangle, std::int32_t corner) {
        if (const std::int32_t other = across_[at(corner)]; other >= 0)
            note(other);
        for (;;) {
            note(corner);
            if (corner / 4 == triangle)
                return;
            corner = from_[at(corner / 4)];
            note(across_[at(corner)]);
        }
    }

    void note(std::int32_t corner) {
        auto &cut = cuts_[at(corner / 4)];
        cut[cut[0] < 0 ? 0 : 1] = static_cast<std::int8_t>(corner % 4);
    }

    std::int32_t midpoint(mesh::Faces faces, std::size_t corner) {
        if (vertex_[corner] < 0) {
            vertex_[corner] = halve(quads_, faces[corner], faces[mesh::next_corner(faces, corner)]);
            if (across_[corner] >= 0)
                vertex_[at(across_[corner])] = vertex_[corner];
        }
        return vertex_[corner];
    }

    void split(const QuadArrays &old, std::size_t face, std::vector<std::array<std::int32_t, 2>> &flat) {
        const mesh::Faces faces = old.faces;
        const std::int32_t origin = old.origin[face];
        auto [i, j] = cuts_[face];
        const auto corner = [&](int k) { return old.faces[4 * face + at(k % 4)]; };
        if (i < 0) {
            add_face(quads_, origin, {corner(0), corner(1), corner(2), corner(3)});
            return;
        }
        const std::int32_t m = midpoint(faces, 4 * face + at(i));
        if (mesh::is_triangle(faces, face)) {
            const std::int32_t a = corner(i), b = corner((i + 1) % 3), c = corner((i + 2) % 3);
            add_face(quads_, origin, {a, m, b, c});
            flat.push_back({a, m});
            return;
        }
        const std::int32_t n = midpoint(faces, 4 * face + at(j));
        if ((j - i + 4) % 4 == 2) {
            add_face(quads_, origin, {corner(i), m, n, corner(i + 3)});
            add_face(quads_, origin, {m, corner(i + 1), corner(i + 2), n});
            return;
        }
        // A turn around the corner between the two sides.
        const bool next = (j - i + 4) % 4 == 1;
        const std::int32_t in = next ? m : n, out = next ? n : m;
        const int turn = next ? j : i;
        const std::int32_t centre = append_vertex(quads_, {in, out, corner(turn + 2)});
        add_face(quads_, origin, {in, corner(turn), out, centre});
        add_face(quads_, origin, {out, corner(turn + 1), corner(turn + 2), centre});
        add_face(quads_, origin, {corner(turn + 2), corner(turn + 3), in, centre});
    }

    QuadArrays &quads_;
    std::vector<std::int32_t> across_;
    std::vector<std::array<std::int8_t, 2>> cuts_; // of each face
    std::vector<std::int32_t> reached_, from_;     // the triangle that a search began at; the corner before
    DisjointSets components_;
    std::vector<bool>
        may_leave_; // of the face that stands for a component: whether a row to the boundary is due
    std::vector<std::int32_t> vertex_; // the midpoint at each corner
};

} // namespace

void split_rows(QuadArrays &quads, std::vector<std::array<std::int32_t, 2>> &flat) {
    for (;;) {
        std::vector<std::int32_t> triangles;
        for (std::size_t f = 0; f < quads.origin.size(); ++f)
            if (mesh::is_triangle(quads.faces, f))
                triangles.push_back(static_cast<std::int32_t>(f));
        if (triangles.empty())
            return;
        Rows rows(quads);
        for (const std::int32_t triangle : triangles)
            if (!rows.find(triangle) && triangle == triangles.front())
                throw Failure(Fault::internal, "face {} is a triangle that has no way to another one",
                              Entity::face, {quads.origin[at(triangle)]});
        rows.split(flat);
    }
}

} // namespace alphamst::quadrangulate
