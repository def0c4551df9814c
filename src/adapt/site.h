// The place of one patch: its boundary, what fills it now, and where other fillings come from.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "adapt/coarsen.h"
#include "adapt/propose.h"
#include "fill/plan.h"
#include "geometry/plane.h"

namespace alphamst::adapt {

// A fault of the patch and its sentence, on the way to the outcome.
struct Refusal {
    Fault fault;
    std::string text;
};

// Everything about the patch that its fillings are judged against.
class Site {
public:
    Site(const mesh::QuadMesh &mesh, const Region &patch, const Goal &goal, const Settings &settings);

    // A filling by its numbers, made when asked for.
    struct Offer {
        std::int64_t faces = 0;
        int singularities = 0;
        std::function<Shape()> build;
    };
    using Group = std::vector<Offer>;
    using Source = std::function<Group()>; // the next group each time, empty at the end

    // Where fillings come from, best first, all made only when asked for.
    std::vector<Source> sources() const;

    // The filling that is there, if it has the wanted numbers.
    std::optional<Offer> present() const;

    // The boundary is so long for the faces, present or wanted, that templates seldom follow its turns.
    bool ragged() const;

    // No edge of the filling may double one outside.
    bool fits(const fill::Filling &filling) const;

    // Singular vertices of the mesh in the patch with this filling.
    std::map<int, std::int64_t> valences(const fill::Filling &filling) const;

    geometry::Embedding embed(const Shape &shape) const;

    // Those of the mesh boundary included.
    int singular_all(const fill::Filling &filling) const;

    // Points for the new vertices, or for one position.
    std::vector<OpenMesh::Vec3d> lift(const geometry::Points &positions) const;
    OpenMesh::Vec3d lift(const Eigen::Vector2d &position) const;
    // Any vertices of the mesh in the plane of the patch.
    geometry::Points flat(std::span<const int> vertices) const;

    patch::Window window;
    fill::Filling old;
    double old_quality = 0;
    geometry::Embedding old_embedding;
    int old_singular_all = 0; // those of the mesh boundary included

private:
    struct Inner;

    static Source templates(fill::Request request);

    // Quads of the present filling collapsed, for when nothing more regular is valid.
    Source collapsed() const;

    // New fillings of what lies at least so many layers of faces off the boundary; the
    // faces in between stay as they are.
    Source inner(int layers) const;

    Source start_inner(int layers) const;

    // Vertices at which both a face of the set and another face of the patch lie, or the loop.
    std::vector<int> border(const std::vector<int> &faces) const;

    fill::Request request() const;

    // The caller's corners have one face, all other boundary vertices are flat.
    void use_corners(const std::vector<int> &corners);

    // A vertex stays singular where the regular letter would split its angle worse than the
    // worst corner there is.
    void keep_angles();

    void flatten();

    void read_old_filling();

    bool inside(int edge) const;

    const mesh::QuadMesh &mesh_;
    const Goal &goal_;
    const Settings &settings_;
    geometry::Plane plane_;
    geometry::Points old_positions_; // loop, then interior
    double least_sine_ = 0;
    bool corners_given_ = false;
    std::unordered_map<int, int> local_; // vertex of the mesh -> of old
    std::vector<int> regular_;           // letters that the mesh wants, whatever this goal makes of them
};

} // namespace alphamst::adapt
