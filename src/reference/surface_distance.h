// Whether a mesh still covers the surface it keeps to: samples of the surface, each owned by the face
// that is nearest. Distances from the mesh to the surface alone would let a window cut off an ear.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/embed.h"
#include "geometry/quad.h"
#include "mesh/quad_mesh.h"
#include "surface/boxes.h"
#include "surface/surface.h"

namespace alphamst::reference {

class SurfaceDistance {
public:
    // So many samples at most, points of the surface. A sample farther than the tolerance from the mesh
    // may stay as far as it is.
    SurfaceDistance(const surface::Surface &surface, const mesh::QuadMesh &mesh, std::size_t most,
                    double tolerance);

    // What new faces make of the samples of old ones: for each the number of the quad that owns it
    // then, and how far it is.
    struct Owner {
        int sample, quad;
        float distance;
    };
    // Nothing if some sample would be farther from all quads than it may be; unless `missed` is given:
    // then it gets the faces with such samples, and the answer is of use only if there are none.
    std::optional<std::vector<Owner>> cover(std::span<const int> faces, std::span<const geometry::Quad> quads,
                                            std::vector<int> *missed = nullptr,
                                            const geometry::Run &run = {}) const;

    // Whether the quads leave no sample of the faces farther off than `part` times what it may be.
    bool covers(std::span<const int> faces, std::span<const geometry::Quad> quads, double part) const;

    // Takes the samples of `faces` away and gives them to the faces that `of_quad` names.
    void assign(std::span<const int> faces, std::span<const Owner> owners, std::span<const int> of_quad);
    int faces() const { return static_cast<int>(samples_.size()); }
    void resize(int faces) { samples_.resize(static_cast<std::size_t>(faces)); }
    void move(int from, int to) {
        samples_[static_cast<std::size_t>(to)] = std::move(samples_[static_cast<std::size_t>(from)]);
    }

    // Distance of the sample that is farthest from the mesh.
    double largest() const;
    // No sample is farther than the tolerance.
    bool complete() const { return largest() <= tolerance_; }

    double tolerance() const { return tolerance_; }
    void set_tolerance(double tolerance) { tolerance_ = tolerance; }
    const std::vector<int> &samples(int face) const { return samples_[static_cast<std::size_t>(face)]; }
    double allowed(int sample) const {
        return std::max(tolerance_, static_cast<double>(distance_[static_cast<std::size_t>(sample)]));
    }
    const Eigen::Vector3d &point(int sample) const { return points_[static_cast<std::size_t>(sample)]; }

private:
    struct Found;

    // Of boxes around the quads that hold all samples of the faces that `part` times what they may be is
    // enough for.
    surface::BoxTree boxes(std::span<const int> faces, std::span<const geometry::Quad> quads,
                           double part) const;
    Owner owner_of(int sample, std::span<const geometry::Quad> quads, const surface::BoxTree &tree) const;

    std::vector<Eigen::Vector3d> points_;   // [sample]
    std::vector<float> distance_;           // [sample]
    std::vector<std::vector<int>> samples_; // [face]
    double tolerance_;
};

// For a mesh that is to have so many faces; the tolerance is one of their edges times `edges`.
SurfaceDistance surface_distance_of(const mesh::QuadMesh &mesh, const surface::Surface &surface,
                                    std::int64_t wanted, double edges);

} // namespace alphamst::reference
