// What a caller asks for, on patches of a mesh: propose, judge, commit.
//
// Every function works on the mesh it is given and may leave it half done when it
// throws; the caller hands in a copy and swaps it in on success.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "failure.h"
#include "mesh/quad_mesh.h"

namespace alphamst::adapt {

// How a curved patch is laid in the plane to be filled anew.
enum class ChartKind {
    plane_or_circle, // a projection where it turns little, else on a circle
    mean_value,      // on a circle
    conformal,       // loop and all where angles are kept best
    low_stretch      // on a circle, stretched less
};

struct Settings {
    std::uint64_t seed = 0;
    int smooth_steps = 20;
    bool patient = true;            // false: a filling that does not come right soon is left
    double least_area = 0.005;      // see geometry::EmbedOptions
    int candidates = 16;            // fillings to try in a patch before it is left
    std::int64_t node_limit = 1000; // effort of one exact search
    double min_quality = 0;         // a filling must have a larger scaled Jacobian
    double tolerance = 0.5;         // of the distance to the surface both ways, in wanted edges
    ChartKind chart = ChartKind::plane_or_circle;
    bool edit_boundary = false; // chords that end on it, or cross features, may go from whole curved meshes
    bool align = false;         // whole curved meshes: edges along the cross field
    int threads = 1;            // 0: all cores
};

// Called on the calling thread only, between steps; throws Failure (cancelled) to stop.
using Progress = std::function<void(double fraction, const char *stage)>;

// One patch. The operations renew faces (and corners stay vertices of the mesh, renumbered).
struct Region {
    std::vector<int> faces;   // ascending
    std::vector<int> corners; // 3 to 6 boundary vertices, or empty: the library chooses
    double alpha = 0;         // 0: that of the operation
};

struct Outcome {
    std::optional<Fault> fault; // why the patch was left as it was
    std::string text;           // the sentence that goes with it
    std::int64_t faces_before = 0, faces_after = 0, faces_wanted = 0;
    std::int64_t singular_before = 0, singular_after = 0, singular_bound = 0;
    std::int64_t candidate = 0; // 0: as predicted; n: geometry forced the n-th later filling
    double quality_before = 0, quality_after = 0, seconds = 0;
    std::map<int, std::int64_t> valences_before, valences_after; // interior vertices of the mesh in the patch
};

struct Prediction {
    std::int64_t faces = 0, singularities = 0;
};

// Replaces each patch by the filling with the fewest singularities that has
// round(alpha * faces) faces.
std::vector<Outcome> adapt(mesh::QuadMesh &mesh, std::vector<Region> &patches, double alpha,
                           const Settings &settings, const Progress &progress);

// Replaces each patch by the filling with the fewest singularities of all, its face
// count as near to the old one as that allows.
std::vector<Outcome> reduce_singularities(mesh::QuadMesh &mesh, std::vector<Region> &patches,
                                          const Settings &settings, const Progress &progress);

// The same for a whole mesh, with windows that the library chooses. adapt delivers
// round(alpha * faces) faces; a vertex field "size" says where they go, else they go where the surface
// bends or, in a plane, where the faces were. reduce_whole keeps the count within a few percent.
Outcome adapt_whole(mesh::QuadMesh &mesh, double alpha, const Settings &settings, const Progress &progress);
Outcome reduce_whole(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress);

// Moves the vertices inside the face sets, or of the whole mesh when patches is null; vertices on the
// mesh boundary and flagged ones stay. One outcome per patch, or one for the mesh.
std::vector<Outcome> smooth(mesh::QuadMesh &mesh, const std::vector<Region> *patches,
                            const Settings &settings, const Progress &progress);

// Removes doublets and splits valences above 5, each by refilling a small window
// around the vertex. One outcome for the mesh.
Outcome clean(mesh::QuadMesh &mesh, const Settings &settings, const Progress &progress);

// What adapt would deliver for the patch. Throws Failure as adapt would report it.
Prediction predict(const mesh::QuadMesh &mesh, const Region &patch, double alpha, const Settings &settings);

} // namespace alphamst::adapt
