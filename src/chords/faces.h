// How a chord and the faces around it look: what its operations share.
#pragma once

#include <chrono>

#include "chord/judge.h"
#include "geometry/plane.h"
#include "geometry/quad.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::chords {

// The faces at some vertices and so many layers around those, ascending.
std::vector<int> faces_around(const mesh::QuadMesh &mesh, std::vector<int> vertices, int layers);

// Every corner is positive; without a plane, against the quad's own normal.
bool upright(const geometry::Quad &quad, const std::optional<geometry::Plane> &plane);

// Faces that are not, in the plane of them all if they have one.
std::int64_t inverted(const mesh::QuadMesh &mesh, const std::vector<int> &faces);

// Where the vertices of a group meet.
OpenMesh::Vec3d place_of(const mesh::QuadMesh &mesh, const chord::Group &group);

// Removes the chord. `survivors` are then the vertices that it left.
mesh::QuadMesh::Collapsed remove(mesh::QuadMesh &mesh, const chord::Chord &chord,
                                 const chord::Collapse &verdict, std::vector<int> &survivors);

// A curved mesh keeps to the surface and to the curves of features that it had before anything changes.
void keep_surface(mesh::QuadMesh &mesh);

// What is told of an operation on the whole mesh.
class Account {
public:
    explicit Account(const mesh::QuadMesh &mesh);
    Outcome close(const mesh::QuadMesh &mesh, std::int64_t wanted);

private:
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Outcome outcome_;
};

} // namespace alphamst::chords
