// The place of one patch: its boundary, what fills it now, and where other fillings come from.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "fill/plan.h"
#include "geometry/plane.h"
#include "outcome.h"
#include "patch/window.h"
#include "reference/reference.h"
#include "reference/region_sizes.h"
#include "refill/chart.h"
#include "refill/coarsen.h"
#include "refill/goal.h"

namespace alphamst::refill {

using reference::SizeError;

// A fault of the patch and its sentence, on the way to the outcome.
struct Refusal {
    Fault fault;
    std::string text;
};

// A filling with places for its vertices.
struct CavityEmbedding : geometry::Judgement {
    geometry::Points flat;                 // in the plane of the patch, or, if that is curved,
    geometry::SurfacePositions on_surface; // on the surface
    int stuck = -1;                        // see geometry::Embedding
};

// Everything about the patch that its fillings are judged against.
class Cavity {
public:
    // A patch that is flat itself lies in its plane, whatever the reference, unless that has
    // surface_triangles.
    Cavity(const mesh::QuadMesh &mesh, const Patch &patch, const Goal &goal, const Settings &settings,
           const reference::Reference &reference);
    // From now on the boundary of the mesh has other vertices there. Only for flat patches; the filling that
    // is there fits no longer, so there are templates only.
    void respace(patch::Window respaced);

    // A filling by its numbers, made when asked for.
    struct Candidate {
        std::int64_t faces = 0;
        int singularities = 0;
        std::function<PlacedFilling()> build;
    };
    using Group = std::vector<Candidate>;
    using Generator = std::function<Group()>; // the next group each time, empty at the end

    // Where fillings come from, best first, all made only when asked for.
    std::vector<Generator> generators() const;

    // Counts between the wanted one and the present one, the nearest to the wanted one first.
    std::vector<std::int64_t> nearest_counts() const;

    // The filling that is there, if it has the wanted numbers.
    std::optional<Candidate> present() const;

    // Whether a vertex of the loop is on the boundary of the mesh.
    bool on_boundary(std::size_t i) const { return window.loop[i] < 0 || mesh_.on_boundary(window.loop[i]); }
    bool respaced() const { return !window.parents.empty(); }

    // The boundary is so long for the faces, present or wanted, that templates seldom follow its turns.
    bool ragged() const;

    // No edge of the filling may double one outside.
    bool fits(const fill::Filling &filling) const;

    // Singular vertices of the mesh in the patch with this filling.
    std::map<int, std::int64_t> valences(const fill::Filling &filling) const;

    // No layout of the filling has a larger smallest scaled Jacobian: faces at a vertex of the border share
    // its angle. Not positive where they cannot be convex.
    double most_quality(const fill::Filling &filling) const;
    // How far the filling would be from the sizes that are wanted, by the plain layout of Tutte: where that
    // says less than .5 it is nearly right, and else in the right order. The goal asks for sizes.
    double predicted_size_error(const PlacedFilling &shape) const;
    // [quad] Of quads on the surface; they sum up to what is there. Empty: all equal.
    std::vector<double> areas(const fill::Filling &filling,
                              const geometry::SurfacePositions &on_surface) const;
    SizeError size_error(const fill::Filling &filling, const CavityEmbedding &embedding) const;
    const SizeError &old_size_error() const { return old_size_error_; }
    double old_alignment_error() const; // 0 where there is no cross field
    // Where the goal asks for sizes, these count so much against shapes, in 0 .. 1.
    CavityEmbedding embed(const PlacedFilling &shape, std::optional<double> size_weight = {}) const;
    // The same in two steps where the patch is curved: into the chart and from there to the surface; without
    // points if the chart does not take it. Then into shape.
    CavityEmbedding start(const PlacedFilling &shape, std::optional<double> size_weight = {}) const;
    CavityEmbedding smooth(const fill::Filling &filling, CavityEmbedding placed) const;
    bool sized() const { return sizes_.has_value(); }
    // In a flat patch that asks for sizes: the area that is wanted at a place.
    double wanted_area(const Eigen::Vector3d &place) const;
    double wanted_part(const Eigen::Vector3d &place) const; // of the area that is there
    bool curved() const { return chart_.has_value(); }
    const reference::Reference &reference() const { return reference_; }
    const surface::Surface &surface() const { return *reference_.surface; }

    // Those of the mesh boundary included.
    int singular_all(const fill::Filling &filling) const;

    // Points for the new vertices, or for one position in the plane.
    std::vector<OpenMesh::Vec3d> lift(const CavityEmbedding &laid) const;
    OpenMesh::Vec3d lift(const Eigen::Vector2d &position) const;
    // Any vertices of the mesh in the plane of the patch, or on its surface.
    geometry::Points flat(std::span<const int> vertices) const;
    std::span<const Eigen::Vector2d> loop_positions() const {
        return std::span(old_positions_).first(window.loop.size());
    }
    geometry::SurfacePositions on_surface(std::span<const int> vertices) const;

    patch::Window window;
    fill::Filling old;
    double old_quality = 0;
    geometry::Judgement old_shape;
    int old_singular_all = 0; // those of the mesh boundary included

private:
    struct Inner;

    static Generator templates(fill::Request request);

    // Quads of the present filling collapsed, for when nothing more regular is valid.
    Generator collapsed() const;

    // New fillings of what lies at least so many layers of faces off the boundary; the
    // faces in between stay as they are.
    Generator inner(int layers) const;

    Generator start_inner(int layers) const;

    // Vertices at which both a face of the set and another face of the patch lie, or the loop.
    std::vector<int> border(const std::vector<int> &faces) const;

    fill::Request request() const;

    // The caller's corners have one face, all other boundary vertices are flat.
    void use_corners(const std::vector<int> &corners);

    // A vertex stays singular where the regular letter would split its angle worse than the
    // worst corner there is.
    void keep_angles(double least_sine);

    void read_old_filling();

    void flatten();

    geometry::Embedding embed_flat(const PlacedFilling &shape, const geometry::EmbedOptions &options) const;
    static CavityEmbedding flat_embedding(geometry::Embedding &&laid);
    geometry::Embedding with_areas(const fill::Filling &filling, geometry::Points positions,
                                   double weight) const;
    void want_sizes();
    std::vector<geometry::Quad> in_space(const fill::Filling &filling,
                                         const geometry::Points &positions) const;
    std::vector<double> wanted_areas(const fill::Filling &filling, const geometry::Points &positions) const;

    bool inside(int edge) const;

    const mesh::QuadMesh &mesh_;
    const Goal &goal_;
    const Settings &settings_;
    const reference::Reference &reference_;
    geometry::Plane plane_;      // of a flat patch
    std::optional<Chart> chart_; // of a curved one
    geometry::SurfacePositions old_on_surface_;
    geometry::Points old_positions_; // loop, then interior, in the plane or the chart
    std::optional<reference::RegionSizes>
        sizes_; // in the plane of a flat patch, in the space of a curved one
    SizeError old_size_error_;
    double least_sine_ = 0;
    bool corners_given_ = false;
    std::vector<int> corners_;           // of the caller
    std::unordered_map<int, int> local_; // vertex of the mesh -> of old
    std::vector<int> regular_;           // letters that the mesh wants, whatever this goal makes of them
};

} // namespace alphamst::refill
