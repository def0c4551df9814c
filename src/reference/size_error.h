// How far faces are from the areas that are wanted for them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/quad.h"
#include "outcome.h"
#include "reference/reference.h"
#include "reference/sizing_field.h"

namespace alphamst::reference {

// Of area / wanted area: the root mean square of log2, and log2 of the smallest. shortest_edge: the smallest
// of edge / root of the wanted area of the face that has it.
struct SizeError {
    double rms = 0, least = 0, shortest_edge = 0;
    std::vector<double> each{}; // [quad] log2
};

// log_wanted: [quad] the natural logarithm of the area that is wanted there.
SizeError size_error(std::span<const geometry::Quad> quads, std::span<const double> log_wanted);

// Writes it to the outcome: as what there was, and is as long as nothing changes; as what there is now.
void tell_sizes_before(const SizeError &error, Outcome &outcome);
void tell_sizes_after(const SizeError &error, Outcome &outcome);

// The areas that faces of a whole mesh are wanted to have: as its sizing field says, times one factor, so
// that the mesh as it is comes to the wanted number of faces.
class WholeSizes {
public:
    // A mesh with faces. reference: its own.
    WholeSizes(const mesh::QuadMesh &mesh, Reference reference, std::int64_t wanted);
    WholeSizes(const WholeSizes &) = delete;
    WholeSizes &operator=(const WholeSizes &) = delete;

    // Of the mesh as it has become since.
    SizeError error(const mesh::QuadMesh &mesh);

private:
    Reference reference_; // which the field reads, of the mesh that was last asked for
    std::optional<SizingField> density_;
    double log_factor_ = 0;
};

} // namespace alphamst::reference
