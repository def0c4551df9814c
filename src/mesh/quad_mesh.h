// QuadMesh: a manifold, oriented all-quad mesh on OpenMesh's half-edge kernel, with
// flags, markers, fields and an origin for every entity. Only replace_disk, collapse_chord and
// split_chord alter connectivity.
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "failure.h"
#include "mesh/field.h"
#include "names.h"

namespace alphamst::surface {
class BoundaryCurves;
class Curves;
class Surface;
} // namespace alphamst::surface

namespace alphamst::mesh {

struct Ids;

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};
using Kernel = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

// held: of faces that are fixed only while an operation is under way.
enum Flag : std::uint8_t { fixed = 1, feature = 2, corner = 4, held = 8 };

// A copy is deep, and so is a move: OpenMesh's kernel has no move constructor.
class QuadMesh {
public:
    // points [n][3]; faces [n][4], counter-clockwise, 0-based. Vertices without a
    // face stay. Throws Failure: not_finite, range, not_quad, not_manifold
    // (an edge with three faces, two faces that run along an edge in the same
    // direction, a vertex whose faces are not one fan), naming the entity; argument,
    // if dim is not 2 or 3 or a length is no multiple. Edges come in ascending order
    // of their vertices, smaller first. The half-edge OpenMesh keeps for a face runs
    // from its last corner to its first, so that OpenMesh's circulators, too, begin at
    // the first corner.
    static QuadMesh build(int dim, std::span<const double> points, std::span<const std::int32_t> faces);

    // The connectivity to the last id, so that whatever is done to a mesh and to one restored from it has
    // equal results. Half-edges 2 * e and 2 * e + 1 are of edge e.
    struct Connectivity {
        std::vector<std::int32_t> faces, sides; // [n][4] corners, and the half-edge that starts at each
        std::vector<std::int32_t> first; // [vertex] the half-edge where walks around it begin, -1: none
    };
    Connectivity connectivity() const;
    // As build, and Failure (argument) if faces, half-edges and edges do not fit together.
    static QuadMesh restore(int dim, std::span<const double> points, const Connectivity &connectivity);

    int dim() const { return dim_; }
    int n_vertices() const { return static_cast<int>(kernel_.n_vertices()); }
    int n_edges() const { return static_cast<int>(kernel_.n_edges()); }
    int n_faces() const { return static_cast<int>(kernel_.n_faces()); }
    const Kernel &kernel() const { return kernel_; }

    const OpenMesh::Vec3d &point(int v) const { return kernel_.point(Kernel::VertexHandle(v)); }
    void set_point(int v, const OpenMesh::Vec3d &p) { kernel_.set_point(Kernel::VertexHandle(v), p); }
    // In the order they were given; faces() is all of them.
    std::array<int, 4> corners(int face) const { return corners_[static_cast<std::size_t>(face)]; }
    std::span<const std::array<int, 4>> faces() const { return corners_; }
    std::array<int, 2> edge_vertices(int edge) const; // smaller id first
    // Left and right of (smaller -> larger), -1 beyond the boundary.
    std::array<int, 2> edge_faces(int edge) const;
    int find_edge(int v, int w) const;             // -1 if there is none
    bool on_boundary(int v) const;                 // false for a vertex without a face
    bool isolated(int v) const;                    // no face at it
    int valence(int v) const;                      // number of edges at it
    bool singular(int v) const;                    // interior and valence != 4
    std::vector<int> faces_around(int v) const;    // counter-clockwise; from the boundary if on it
    std::vector<int> vertices_around(int v) const; // counter-clockwise, one edge away; likewise
    // The face across the edge from corner i to corner i+1 of face, -1 at the boundary.
    std::array<int, 4> neighbours(int face) const;
    std::vector<int> singularities() const; // ascending

    // Flags and markers, one per entity.
    std::vector<std::uint8_t> vertex_flags, edge_flags, face_flags;    // bits of Flag
    std::vector<std::int32_t> vertex_marker, edge_marker, face_marker; // 0: none; empty: all none
    Names names;                                                       // of markers; not in the checksum
    // Edges are numbered by tags of curves that nobody named: where one ends and the next begins, the
    // boundary goes on.
    bool curve_numbers = false;

    // Not in the checksum. While origins say that something has changed, the values are still those of
    // the mesh before: transfer::carry brings them along, once for an operation.
    Fields fields;
    // That mesh before, while an operation changes this one; null: nothing has changed yet.
    std::shared_ptr<const QuadMesh> begun;
    // Values [entities][components] of a field, null if there is none of that name.
    const std::vector<double> *field(Entity entity, std::string_view name) const noexcept {
        const Field *found = fields.find(entity, name);
        return found == nullptr ? nullptr : &found->values;
    }

    // What the vertices keep to while they move, shared by copies; not in the checksum. Null: as
    // reference::surface_of, see reference/surface_of.h, makes it when the first operation on a curved mesh
    // begins.
    std::shared_ptr<const surface::Surface> surface;
    // What vertices on features slide along, likewise. Brought up to date, see reference::curves_of in
    // reference/surface_of.h, when an operation begins that lets them.
    std::shared_ptr<const surface::Curves> curves;
    // What vertices of the boundary come and go on, likewise, see reference/projection.h.
    std::shared_ptr<const surface::BoundaryCurves> boundary;

    // Where each vertex, edge and face was when origins were last reset; -1 if new.
    std::vector<std::int32_t> vertex_origin, edge_origin, face_origin;
    void reset_origins();

    // Replaces the faces of a disk by new ones. `loop` is the disk's boundary,
    // counter-clockwise; quads use 0 .. loop.size()-1 for it and
    // loop.size() .. loop.size()+points.size()-1 for new vertices at `points`.
    // Nothing outside changes: no coordinate, no connectivity; ids of removed entities
    // are used again, and only if fewer come than go do the last entities of
    // the mesh move into the gaps (the origins tell). New faces inherit the marker of
    // the removed ones (the most frequent). Where the disk is on the boundary of the mesh, vertices of that
    // may go, and others come: then a negative number in the loop is a new vertex, the points of which come
    // first, and the new edge from loop[i] has the flags, the number and the origin of the edge of the
    // boundary that starts at the vertex parents[i], the disk at its left, and goes. Costs O(disk). Throws
    // Failure (internal) before any change if the quads do not fit the loop or would break the manifold: an
    // interior edge that exists outside the disk, an edge of three quads, a boundary edge not used once.
    struct Replaced {
        std::vector<int> faces;    // ids of the new faces, in the order of quads
        std::vector<int> vertices; // ids of the new vertices, in the order of points
        // Renumbered outside the disk, in this order: from the end of the mesh into a gap.
        std::vector<std::array<int, 2>> moved_faces, moved_vertices;
        int n_faces = 0, n_vertices = 0; // of the mesh after that
    };
    Replaced replace_disk(std::span<const int> faces, std::span<const int> loop,
                          std::span<const std::array<int, 4>> quads, std::span<const OpenMesh::Vec3d> points,
                          std::span<const int> parents = {});

    // What replace_disk was asked for and what it answered, in order, so that it can be done again elsewhere,
    // see mesh/submesh.h. Empty unless that is wanted; then nothing else may alter connectivity.
    struct Replacement {
        std::vector<int> faces, loop, parents;
        std::vector<std::array<int, 4>> quads;
        std::vector<OpenMesh::Vec3d> points;
        Replaced replaced;
    };
    std::optional<std::vector<std::shared_ptr<const Replacement>>> journal;
    bool is_part() const { return journal.has_value(); } // of another mesh, which goes on beyond

    // Removes a chord: merges the ends of each of its edges and glues the two rails of each of its faces
    // to one edge. `sides` are half-edges of its edges in order, each with the next face of the chord on
    // its left; `merged` says which vertex goes and which one stays in its place, where it is. Ids,
    // origins and cost are as in replace_disk; a glued edge has the flags and the number of both.
    // Throws Failure (internal) before any change if sides and vertices are no chord; whether the
    // mesh stays a manifold is for chord::Judge to say.
    struct Collapsed {
        std::vector<std::array<int, 2>> glued; // edges that went, and the ones now in their place
        std::vector<std::array<int, 2>> moved_faces, moved_edges, moved_vertices; // in this order
    };
    Collapsed collapse_chord(std::span<const int> sides, std::span<const std::array<int, 2>> merged);

    // Cuts a chord into copies + 1 ones of equal width; faces where it crosses itself into
    // (copies + 1)^2. What was there keeps its id, one piece of each edge and face included; new
    // pieces have the flags, the number and the origin of what they are part of. Always a manifold;
    // costs O(what is new). Throws Failure (internal) before any change if sides are no chord.
    struct Cut {
        std::vector<int> vertices; // new ones
        std::vector<int> faces;    // all pieces
    };
    Cut split_chord(std::span<const int> sides, int copies);

    // Full test of connectivity; in the plane also of orientation (every corner
    // positive). Throws the first fault with its place.
    void check() const;
    // Digest of dim, coordinates, connectivity, flags and markers, names left out; equal for equal meshes
    // only. An edge counts by its vertices, not by its id: a mesh built anew from the
    // same vertices and faces has the same digest.
    std::uint64_t checksum() const;

private:
    // What the kernel has surely room for. A copied vector keeps its elements, not its
    // capacity, so a copy of this begins at nothing.
    struct Room {
        Room() = default;
        Room(const Room &) noexcept {}
        Room &operator=(const Room &) noexcept {
            vertices = edges = faces = 0;
            return *this;
        }
        std::size_t vertices = 0, edges = 0, faces = 0;
    };

    static QuadMesh assemble(int dim, std::span<const double> points, std::span<const std::int32_t> faces,
                             std::span<const std::int32_t> sides, std::size_t n_edges);
    void write_quads(std::span<const std::array<int, 4>> quads, int n_loop, const std::vector<int> &ids,
                     const std::vector<int> &vertices, const std::vector<int> &sides, std::int32_t marker);
    void reserve(std::size_t vertices, std::size_t edges, std::size_t faces);
    void resize(std::size_t vertices, std::size_t edges, std::size_t faces);
    void move_vertex(int from, int to);
    void move_edge(int from, int to);
    void move_face(int from, int to);
    // Carries out all moves and takes off what is left over at the end.
    void close_gaps(const Ids &faces, const Ids &edges, const Ids &vertices);
    class Rim;
    struct Block;
    struct Pieces;
    void write_pieces(Pieces &pieces, Cut &cut);
    void write_block(Block &block, std::vector<int> &pieces, int &next_face);
    void write_row(const std::vector<int> &vertices, const std::vector<int> &pieces);
    void check_sizes() const;
    void refuse_with_journal() const;
    Replaced replace(std::span<const int> faces, std::span<const int> loop,
                     std::span<const std::array<int, 4>> quads, std::span<const OpenMesh::Vec3d> points,
                     std::span<const int> parents);

    int dim_ = 3;
    Kernel kernel_;
    // What the half-edges say, kept beside them: a walk around a face costs a chain of four
    // reads that wait for each other, this costs one.
    std::vector<std::array<int, 4>> corners_;
    Room room_;
};

} // namespace alphamst::mesh
