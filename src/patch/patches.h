// Choosing face sets: by rings, ball, box, and automatic decomposition; making them
// disks. All return ascending face ids and are deterministic.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/quad_mesh.h"
#include "pace.h"

namespace alphamst::patch {

// taken[face] != 0: the face belongs to another patch or is FIXED and is left out.
using Taken = std::span<const char>;

// Faces within `rings` face layers of a vertex (1: the faces at it).
std::vector<int> rings(const mesh::QuadMesh &mesh, int vertex, int rings, Taken taken);
// The edge-connected faces around the one nearest to center whose centroid is within radius.
std::vector<int> ball(const mesh::QuadMesh &mesh, const std::array<double, 3> &center, double radius,
                      Taken taken);
// Faces with their centroid in the box; the largest edge-connected part.
std::vector<int> box(const mesh::QuadMesh &mesh, const std::array<double, 3> &low,
                     const std::array<double, 3> &high, Taken taken);

// Makes a disk of a face set if it can: keeps the largest edge-connected part, takes in
// enclosed holes that are free, drops faces at pinches and, where a flag, marker or
// region border runs inside, keeps the largest side. May return an empty set.
std::vector<int> repair(const mesh::QuadMesh &mesh, std::vector<int> faces, Taken taken);
// The same, but what encloses a hole of two faces or more, and of more than a tenth of its own, stays as it
// is: a ring is meant.
std::vector<int> repair_but_rings(const mesh::QuadMesh &mesh, std::vector<int> faces, Taken taken);

// Decompositions: disjoint disks, repaired, of about `size` faces that are not taken.
//
// Compact clusters (Lloyd on the dual graph).
std::vector<std::vector<int>> clusters(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                       Taken taken, const Pace &pace = {});
// Balanced parts (recursive bisection of the dual graph).
std::vector<std::vector<int>> partition(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                        Taken taken, const Pace &pace = {});
// Geodesic Voronoi cells of faces that lie far from one another.
std::vector<std::vector<int>> voronoi_cells(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                            Taken taken, const Pace &pace = {});
// Faces within the largest inscribed circles, the largest first; `size` is the most, a quarter
// of it the least. What bounds the free faces are the mesh boundary, flags, markers and taken
// faces; where there is none the first circle is around a random face.
std::vector<std::vector<int>> medial_discs(const mesh::QuadMesh &mesh, double size, std::uint64_t seed,
                                           Taken taken, const Pace &pace = {});
// Faces around singular vertices, around all that lie together; no others, and nothing random.
std::vector<std::vector<int>> singularity_clusters(const mesh::QuadMesh &mesh, double size,
                                                   std::uint64_t seed, Taken taken, const Pace &pace = {});

} // namespace alphamst::patch
