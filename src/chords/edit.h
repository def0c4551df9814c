// Operations on whole chords: they refine and coarsen without new singular vertices.
#pragma once

#include "chord/judge.h"
#include "mesh/quad_mesh.h"
#include "outcome.h"
#include "settings.h"

namespace alphamst::chords {

// Removes the chord through an edge, then smooths the faces around it. Throws Failure: chord, with the
// reason and the place, where chord::Judge refuses; geometry, if an element would invert.
Outcome collapse_chord(mesh::QuadMesh &mesh, int edge, const chord::Rules &rules, const Settings &settings,
                       const Progress &progress);

// Cuts it into copies + 1 ones, then smooths. Throws Failure: chord; range, if the mesh would get more than
// most_faces.
Outcome split_chord(mesh::QuadMesh &mesh, int edge, int copies, std::int64_t most_faces,
                    const chord::Rules &rules, const Settings &settings, const Progress &progress);

// Lays n rings of faces between the boundary of each patch and its faces, which become the core. Patches
// need 3 to 6 corners (boundary vertices with one face) or none, the rest of the boundary straight (two
// faces), so that singular vertices come at the corners of the core alone, whatever n is.
std::vector<Outcome> insert_chords(mesh::QuadMesh &mesh, std::vector<Patch> &patches, int n,
                                   const Settings &settings, const Progress &progress);

// Which chords are removed first: those of the fewest faces, for the finest steps, or those of the shortest
// edges, so that faces go where they lie closest.
enum class Order { shortest, narrowest };

// Removes chords, or splits chords that touch no boundary, the widest that fit first, towards the wanted
// number of faces, which it never passes. Vertices are left where that puts them.
void approach_by_chords(mesh::QuadMesh &mesh, std::int64_t wanted, const chord::Rules &rules, Order order,
                        const Progress &progress);

// The whole mesh by chords alone, and smoothed once, at the end: towards round(alpha * faces). No element
// inverts.
Outcome adapt_chords(mesh::QuadMesh &mesh, double alpha, std::int64_t most_faces, const chord::Rules &rules,
                     const Settings &settings, const Progress &progress);

} // namespace alphamst::chords
