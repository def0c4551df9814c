// One patch, one new filling: propose on a mesh that is only read, judge by its geometry.
#pragma once

#include <optional>

#include "fill/filling.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "patch/window.h"
#include "reference/reference.h"
#include "settings.h"

namespace alphamst::refill {

struct Goal {
    std::int64_t faces = 0;    // wanted
    bool any_count = false;    // fewest singularities first, faces only as near as possible
    bool keep_quality = false; // prefer fillings whose smallest scaled Jacobian is not below the old one
    bool forbid_old = false;   // the old filling is no answer
    bool turn = false;         // towards the cross field of the reference
    bool collapse = false;     // quads of the old filling collapsed, nothing else
    std::int64_t fewest = 0, most = 0; // any_count: faces in this range; 0: from half to twice as many
    int most_added = 1 << 20;          // singularities, those of the mesh boundary included
};

struct Proposal {
    patch::Window window;
    fill::Filling filling;
    std::vector<OpenMesh::Vec3d> points;            // of the new vertices
    Outcome outcome;                                // outcome.fault: there is nothing to commit
    std::vector<std::array<int, 2>> moved_vertices; // by its commit
};

// Never throws for reasons of the patch; these are in outcome.fault. The result depends on
// the arguments alone.
Proposal propose(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
                 const reference::Reference &reference);

// The numbers of the first filling that propose would try or, where the old quality is to be kept,
// of the one that it takes. Throws Failure where there is none.
Prediction first_choice(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal,
                        const Settings &settings, const reference::Reference &reference);

// Puts the proposal into the mesh.
mesh::QuadMesh::Replaced commit(mesh::QuadMesh &mesh, const Proposal &proposal);

// The whole count, rounded half away from zero.
std::int64_t wanted_faces(double alpha, std::size_t faces);

} // namespace alphamst::refill
