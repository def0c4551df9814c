// One candidate for a cavity: embedded, then judged once by all that a filling must keep: corners, shapes,
// features across the border, distance to the surface, the cross field.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "index.h"
#include "patch/window.h"
#include "refill/buffer_ring.h"
#include "refill/cavity.h"
#include "refill/goal.h"
#include "refill/obstacle.h"

namespace alphamst::refill {

// Why a candidate was not taken.
enum class Refused { numbers, edge, obstacle, embedding, shape, feature, distance, size };
constexpr std::array<const char *, 8> reason_names = {"numbers",         "double edge",
                                                      "known obstacle",  "no embedding",
                                                      "bad shape",       "inverted across feature",
                                                      "off the surface", "too small faces"};

// What became of the candidates of one cavity, for those who want to look inside.
struct Trace {
    int candidates = 0;
    std::array<int, reason_names.size()> refused{};
    int of(Refused reason) const { return refused[at(static_cast<int>(reason))]; }
    // False, so that it can be what a test returns.
    bool refuse(Refused reason) {
        ++refused[static_cast<std::size_t>(reason)];
        return false;
    }
};

// What a commit puts in the place of a cavity.
struct Replacement {
    patch::Window window;
    fill::Filling filling;
    std::vector<OpenMesh::Vec3d> points; // of the new vertices
    std::vector<int> surface_triangles;  // under them; empty in a plane
    Moved moved;                         // vertices of the buffer and the loop
    // Samples of the surface that the window had, or window and buffer if that moves: their quads are those
    // of the filling, then of the buffer.
    std::vector<reference::SurfaceDistance::Owner> owners;
    double alignment_error = 0; // from the cross field of the reference, if there is one
    int singular_change = 0;    // those of the mesh boundary included
};

struct Evaluation {
    Replacement replacement;
    ShapeBounds shape;     // of the filling, with the buffer if that moves
    SizeError size_error;  // where the goal asks for sizes
    geometry::Points flat; // places of the filling in the plane of the patch; empty if that is curved
};

class Evaluator {
public:
    // All of them must outlive it. trace: counts what becomes of the candidates.
    Evaluator(const mesh::QuadMesh &mesh, const Cavity &cavity, const BufferRing &buffer,
              const Settings &settings, Trace &trace);

    // Of the filling that is there. Inverted across features: see BufferRing::inverted.
    const ShapeBounds &before() const { return before_; }
    int inverted_at_features() const { return inverted_; }

    // Where the filling that is there is no answer, quads inverted across features must become fewer.
    void demand_gain() { most_inverted_ = std::max(0, inverted_ - 1); }

    // Whether its numbers and edges would do; a look at the geometry is dear.
    bool fits(const fill::Filling &filling);

    // Nothing if it does not reach the bounds, or spoils what must be kept. size_weight: of sizes against
    // shapes, where the cavity asks for sizes; none: that of the settings.
    std::optional<Evaluation> evaluate(const PlacedFilling &candidate, const ShapeBounds &bounds,
                                       std::optional<double> size_weight = {});

private:
    CavityEmbedding embed(const PlacedFilling &candidate, std::optional<double> size_weight, Refused &reason);
    void fit(const fill::Filling &filling, CavityEmbedding &embedding) const;
    bool into_shape(const fill::Filling &filling, const ShapeBounds &bounds, CavityEmbedding &embedding,
                    Evaluation &evaluation);
    bool stays_near(const fill::Filling &filling, const CavityEmbedding &embedding, Replacement &replacement);
    double distance_of(const geometry::Quad &quad, int surface_triangle) const;

    const mesh::QuadMesh &mesh_;
    const Cavity &cavity_;
    const BufferRing &buffer_;
    const Settings &settings_;
    const std::optional<reference::SurfaceDistance> &surface_distance_;
    Obstacles obstacles_;
    ShapeBounds before_;
    bool features_ = false; // fillings are judged across them
    int inverted_ = 0, most_inverted_ = 0;
    double most_distance_ = 0; // of the middle of a quad from the surface
    Trace &trace_;
};

} // namespace alphamst::refill
