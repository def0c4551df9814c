// The faces around a cavity: its fillings are judged together with them, and their vertices may give way.
#pragma once

#include <array>
#include <unordered_map>
#include <utility>
#include <vector>

#include "refill/cavity.h"
#include "refill/goal.h"

namespace alphamst::refill {

ShapeBounds shape_of(const geometry::Judgement &quads);
// Of the faces of both.
ShapeBounds both(const ShapeBounds &a, const ShapeBounds &b);
bool reaches(const ShapeBounds &reached, const ShapeBounds &wanted);

// Vertices that move with a filling, and the triangles of the surface under them, if there is one.
struct Moved {
    std::vector<std::pair<int, OpenMesh::Vec3d>> vertices;
    std::vector<int> surface_triangles;
};

class BufferRing {
public:
    // May be without faces. The faces of a patch's buffer stay, as all does outside a patch.
    BufferRing(const mesh::QuadMesh &mesh, const Cavity &cavity, std::vector<int> faces, bool stays);

    // Of the faces that may change; the best there is where they stay.
    const ShapeBounds &shape() const { return shape_; }
    const std::vector<int> &faces() const { return faces_; }
    bool stays() const { return stays_; }

    // Filling and buffer in space; with the buffer where it is if the embedding knows no places for it.
    std::vector<geometry::Quad> quads(const fill::Filling &filling, const CavityEmbedding &embedding) const;

    // Quads with a corner that is not positive against the quads around it, those of the filling and of the
    // buffer, which lies across features, too; with the buffer where it is if the positions know no places
    // for it. Only for curved cavities of meshes with features.
    int inverted(const fill::Filling &filling, geometry::SurfacePositions on_surface) const;

    // Lets the vertices of filling and buffer move together. Places are those of the filling, then
    // of the buffer's own vertices.
    CavityEmbedding improve(const fill::Filling &filling, CavityEmbedding embedding,
                            geometry::EmbedOptions options) const;

    // The vertices of the mesh that the places of the whole move.
    Moved moved(const fill::Filling &filling, const CavityEmbedding &embedding) const;

private:
    void number(const mesh::QuadMesh &mesh);

    // Quads of the filling and then of the buffer, whose own vertices come after those of the filling.
    std::vector<std::array<int, 4>> join(const fill::Filling &filling) const;

    const Cavity &cavity_;
    const std::vector<int> faces_;
    const bool stays_;
    std::unordered_map<int, int> number_;
    std::vector<int> vertices_; // of the mesh: the loop, then others
    std::vector<std::array<int, 4>> quads_;
    std::vector<char> fixed_;
    geometry::Points flat_;
    geometry::SurfacePositions on_surface_;
    std::vector<Eigen::Vector3d> normals_; // of on_surface_, but none on features
    ShapeBounds shape_;
};

} // namespace alphamst::refill
