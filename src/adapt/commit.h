// Replacements go into the mesh one after the other, and what it keeps to goes with it.
#pragma once

#include <vector>

#include "mesh/renumbered.h"
#include "reference/reference.h"
#include "refill/evaluate.h"

namespace alphamst::adapt {

class Commits {
public:
    Commits(mesh::QuadMesh &mesh, reference::Reference &reference)
        : faces(mesh.n_faces()), vertices(mesh.n_vertices()), mesh_(mesh), reference_(reference) {}

    // Puts it in. Its numbers, and those of the buffer around it, are those at the start; afterwards they
    // are those of the mesh as it was just before this commit.
    mesh::QuadMesh::Replaced put(refill::Replacement &replacement, std::vector<int> buffer);

    // From the start of this until now.
    mesh::Renumbered faces, vertices;

private:
    void renumber(refill::Replacement &replacement, std::vector<int> &buffer) const;
    void follow_surface(const refill::Replacement &replacement, const mesh::QuadMesh::Replaced &replaced);
    void follow_boundary(const refill::Replacement &replacement, const mesh::QuadMesh::Replaced &replaced);
    void follow_distance(const refill::Replacement &replacement, const std::vector<int> &buffer,
                         const mesh::QuadMesh::Replaced &replaced);

    mesh::QuadMesh &mesh_;
    reference::Reference &reference_;
};

} // namespace alphamst::adapt
