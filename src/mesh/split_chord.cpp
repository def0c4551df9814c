// Cutting a chord lengthwise. Each edge of it becomes a row of pieces, each face a block of faces:
// one wide, or a square where the chord crosses itself.
#include <algorithm>

#include "index.h"
#include "mesh/link.h"
#include "stop.h"

namespace alphamst::mesh {

namespace {

[[noreturn]] void refuse(const char *text) { throw Failure(Fault::internal, text); }

// The pieces of an edge, from the start of the chord's half-edge `side` to its end.
struct Row {
    int side;
    std::vector<int> vertices; // one more than pieces
    std::vector<int> pieces;   // half-edges that run as side does
};

// The same row as another half-edge of the edge runs.
Row turned(const Row &row, int side) {
    Row result = row;
    if (side == row.side)
        return result;
    std::reverse(result.vertices.begin(), result.vertices.end());
    std::reverse(result.pieces.begin(), result.pieces.end());
    for (int &piece : result.pieces)
        piece ^= 1;
    return result;
}

// What a chord passes.
struct Chord {
    std::vector<std::array<int, 2>> row_of; // edge, place in sides; ascending
    std::vector<int> faces;                 // ascending, each once
};

Chord find_chord(const Kernel &kernel, std::span<const int> sides) {
    Chord chord;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (sides[i] < 0 || at(sides[i]) >= kernel.n_halfedges())
            refuse("a chord has an edge that is not in the mesh");
        chord.row_of.push_back({sides[i] / 2, static_cast<int>(i)});
        if (!kernel.is_boundary(Halfedge(sides[i])))
            chord.faces.push_back(kernel.face_handle(Halfedge(sides[i])).idx());
    }
    std::sort(chord.row_of.begin(), chord.row_of.end());
    for (std::size_t i = 1; i < chord.row_of.size(); ++i)
        if (chord.row_of[i][0] == chord.row_of[i - 1][0])
            refuse("a chord passes an edge twice");
    std::sort(chord.faces.begin(), chord.faces.end());
    chord.faces.erase(std::unique(chord.faces.begin(), chord.faces.end()), chord.faces.end());
    return chord;
}

OpenMesh::Vec3d between(const OpenMesh::Vec3d &a, const OpenMesh::Vec3d &b, std::size_t part,
                        std::size_t parts) {
    const double t = static_cast<double>(part) / static_cast<double>(parts);
    return a * (1 - t) + b * t;
}

} // namespace

// A face of the chord: nu x nv pieces over corners a, b = a + u, c = b + v, d = a + v. Half-edges u run
// from a to b, v from a to d.
struct QuadMesh::Block {
    Block(int of_face, std::size_t wide, std::size_t high, std::size_t from_corner)
        : face(of_face), nu(wide), nv(high), turn(from_corner), vertices((nu + 1) * (nv + 1)),
          u(nu * (nv + 1)), v(nv * (nu + 1)) {}

    int face;
    std::size_t nu, nv, turn; // corner `turn` of the face is a
    std::vector<int> vertices, u, v;

    int &vertex(std::size_t i, std::size_t j) { return vertices[j * (nu + 1) + i]; }
    int &along_u(std::size_t i, std::size_t j) { return u[j * nu + i]; }
    int &along_v(std::size_t i, std::size_t j) { return v[i * nv + j]; }

    // Side k of the face as it was: from a to b, b to c, c to d, d to a.
    void border(std::size_t k, const Row &row) {
        const std::size_t n = row.pieces.size();
        for (std::size_t i = 0; i <= n; ++i) {
            const int vertex_here = row.vertices[i];
            (k == 0   ? vertex(i, 0)
             : k == 1 ? vertex(nu, i)
             : k == 2 ? vertex(n - i, nv)
                      : vertex(0, n - i)) = vertex_here;
        }
        for (std::size_t i = 0; i < n; ++i)
            (k == 0   ? along_u(i, 0)
             : k == 1 ? along_v(nu, i)
             : k == 2 ? along_u(n - 1 - i, nv)
                      : along_v(0, n - 1 - i)) = k < 2 ? row.pieces[i] : row.pieces[i] ^ 1;
    }
};

// Every id and point that a chord cut lengthwise comes to, while the mesh is as it was. New ids follow
// those of the mesh: the rows first, in the order of the sides, then the blocks, in that of their faces.
struct QuadMesh::Pieces {
    const QuadMesh &mesh;
    const std::size_t n; // pieces of an edge
    const Chord chord;
    int next_vertex, next_edge, next_face; // as many as there will be in the end
    int first_rail;                        // the first edge that runs along the chord, inside a face
    std::vector<OpenMesh::Vec3d> points;   // of new vertices
    std::vector<Row> rows;
    std::vector<Block> blocks;

    Pieces(const QuadMesh &of, std::span<const int> sides, std::size_t pieces)
        : mesh(of), n(pieces), chord(find_chord(of.kernel(), sides)), next_vertex(of.n_vertices()),
          next_edge(of.n_edges()), next_face(of.n_faces()) {
        for (const int side : sides)
            rows.push_back(cut_edge(side));
        first_rail = next_edge;
        for (const int face : chord.faces) {
            Stop::point();
            blocks.push_back(cut_face(face));
        }
    }

private:
    Row cut_edge(int side) {
        Row row{side, {}, {}};
        const auto [start, end] = ends(side);
        for (std::size_t k = 0; k < n; ++k) {
            row.vertices.push_back(k == 0 ? start : next_vertex++);
            row.pieces.push_back(k == 0 ? side : 2 * next_edge++ + side % 2);
            if (k > 0)
                points.push_back(between(mesh.point(start), mesh.point(end), k, n));
        }
        row.vertices.push_back(end);
        return row;
    }

    // The row along a half-edge; an edge that the chord does not pass is one piece.
    Row row_at(int side) const {
        const auto found =
            std::lower_bound(chord.row_of.begin(), chord.row_of.end(), std::array{side / 2, -1});
        if (found != chord.row_of.end() && (*found)[0] == side / 2)
            return turned(rows[at((*found)[1])], side);
        const auto [start, end] = ends(side);
        return Row{side, {start, end}, {side}};
    }

    Block cut_face(int face) {
        const Kernel &kernel = mesh.kernel();
        std::array<Row, 4> border;
        Halfedge h = kernel.next_halfedge_handle(kernel.halfedge_handle(Face(face))); // from corner 0
        for (Row &row : border) {
            row = row_at(h.idx());
            h = kernel.next_halfedge_handle(h);
        }
        // a is a corner from which a cut side starts.
        const std::size_t turn = border[0].pieces.size() > 1 ? 0 : 1;
        std::rotate(border.begin(), border.begin() + static_cast<std::ptrdiff_t>(turn), border.end());
        if (border[0].pieces.size() != n || border[2].pieces.size() != n ||
            border[1].pieces.size() != border[3].pieces.size())
            refuse("a chord leaves a face through an edge that is not opposite");
        Block block(face, n, border[1].pieces.size(), turn);
        for (std::size_t k = 0; k < 4; ++k)
            block.border(k, border[k]);
        fill(block);
        return block;
    }

    // What is inside a block whose border is known.
    void fill(Block &block) {
        const auto corner = [&](std::size_t i, std::size_t j) { return mesh.point(block.vertex(i, j)); };
        for (std::size_t j = 1; j < block.nv; ++j)
            for (std::size_t i = 1; i < block.nu; ++i) {
                block.vertex(i, j) = next_vertex++;
                points.push_back(between(
                    between(corner(0, 0), corner(block.nu, 0), i, block.nu),
                    between(corner(0, block.nv), corner(block.nu, block.nv), i, block.nu), j, block.nv));
            }
        for (std::size_t j = 0; j < block.nv; ++j)
            for (std::size_t i = 1; i < block.nu; ++i)
                block.along_v(i, j) = 2 * next_edge++;
        for (std::size_t j = 1; j < block.nv; ++j)
            for (std::size_t i = 0; i < block.nu; ++i)
                block.along_u(i, j) = 2 * next_edge++;
        next_face += static_cast<int>(block.nu * block.nv) - 1;
    }

    std::array<int, 2> ends(int side) const {
        return {mesh.kernel().from_vertex_handle(Halfedge(side)).idx(),
                mesh.kernel().to_vertex_handle(Halfedge(side)).idx()};
    }
};

void QuadMesh::write_block(Block &block, std::vector<int> &pieces, int &next_face) {
    const int parent = block.face;
    for (std::size_t j = 0; j < block.nv; ++j)
        for (std::size_t i = 0; i < block.nu; ++i) {
            const int face = i + j == 0 ? parent : next_face++;
            std::array<int, 4> sides{block.along_u(i, j), block.along_v(i + 1, j),
                                     block.along_u(i, j + 1) ^ 1, block.along_v(i, j) ^ 1};
            std::array<int, 4> corners{block.vertex(i, j), block.vertex(i + 1, j), block.vertex(i + 1, j + 1),
                                       block.vertex(i, j + 1)};
            const auto turn = static_cast<std::ptrdiff_t>((4 - block.turn) % 4);
            std::rotate(sides.begin(), sides.begin() + turn, sides.end());
            std::rotate(corners.begin(), corners.begin() + turn, corners.end());
            corners_[at(face)] = corners;
            link_face(kernel_, face, sides, corners);
            face_flags[at(face)] = face_flags[at(parent)];
            face_origin[at(face)] = face_origin[at(parent)];
            if (!face_marker.empty())
                face_marker[at(face)] = face_marker[at(parent)];
            pieces.push_back(face);
        }
}

QuadMesh::Cut QuadMesh::split_chord(std::span<const int> sides, int copies) {
    refuse_with_journal();
    check_sizes();
    if (copies < 1 || sides.empty())
        refuse("a chord is cut into two at least");
    Pieces pieces(*this, sides, at(copies) + 1);
    Cut cut;
    cut.faces.reserve(at(pieces.next_face - n_faces()) + pieces.blocks.size());
    for (int v = n_vertices(); v < pieces.next_vertex; ++v)
        cut.vertices.push_back(v);
    reserve(at(pieces.next_vertex), at(pieces.next_edge), at(pieces.next_face));

    // From here on nothing throws.
    write_pieces(pieces, cut);
    return cut;
}

// What is new, then the rows, then the blocks, which count on the rows; the numbers of all pieces of
// faces go to cut.faces, which has room for them.
void QuadMesh::write_pieces(Pieces &pieces, Cut &cut) {
    const int old_vertices = n_vertices();
    int face = n_faces();
    resize(at(pieces.next_vertex), at(pieces.next_edge), at(pieces.next_face));
    for (std::size_t i = 0; i < pieces.points.size(); ++i)
        kernel_.set_point(Vertex(old_vertices + static_cast<int>(i)), pieces.points[i]);
    for (const int v : cut.vertices)
        vertex_origin[at(v)] = -1;
    for (int edge = pieces.first_rail; edge < pieces.next_edge; ++edge)
        edge_origin[at(edge)] = -1;
    for (const Row &row : pieces.rows)
        write_row(row.vertices, row.pieces);
    for (Block &block : pieces.blocks)
        write_block(block, cut.faces, face);
    for (const Block &block : pieces.blocks)
        for (std::size_t j = 1; j < block.nv; ++j)
            for (std::size_t i = 1; i < block.nu; ++i)
                kernel_.set_halfedge_handle(Vertex(block.vertices[j * (block.nu + 1) + i]),
                                            Halfedge(block.u[j * block.nu + i]));
}

// The pieces of an edge with what it had; on the boundary they follow each other in its loop.
void QuadMesh::write_row(const std::vector<int> &vertices, const std::vector<int> &pieces) {
    const int side = pieces.front(), edge = side / 2;
    const Vertex end(vertices.back());
    const bool start_of_end = kernel_.halfedge_handle(end) == Halfedge(side ^ 1);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const std::size_t piece = at(pieces[k] / 2);
        edge_flags[piece] = edge_flags[at(edge)];
        edge_origin[piece] = edge_origin[at(edge)];
        if (!edge_marker.empty())
            edge_marker[piece] = edge_marker[at(edge)];
        if (k > 0)
            kernel_.set_halfedge_handle(Vertex(vertices[k]), Halfedge(pieces[k]));
    }
    for (const int way : {0, 1}) {
        const Halfedge whole(side ^ way);
        if (!kernel_.is_boundary(whole))
            continue;
        const Halfedge previous = kernel_.prev_halfedge_handle(whole);
        const Halfedge next = kernel_.next_halfedge_handle(whole);
        Halfedge last = previous;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const std::size_t k = way == 0 ? i : pieces.size() - 1 - i;
            const Halfedge piece(pieces[k] ^ way);
            kernel_.set_boundary(piece);
            kernel_.set_next_halfedge_handle(last, piece);
            const std::size_t start = way == 0 ? k : k + 1;
            if (start > 0 && start + 1 < vertices.size())
                kernel_.set_halfedge_handle(Vertex(vertices[start]), piece);
            last = piece;
        }
        kernel_.set_next_halfedge_handle(last, next);
    }
    if (start_of_end)
        kernel_.set_halfedge_handle(end, Halfedge(pieces.back() ^ 1));
}

} // namespace alphamst::mesh
