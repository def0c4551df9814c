#include "adapt/respace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alphamst::adapt {
namespace {

constexpr std::array<RespacingPass, 4> even = {{{16, 0.2, 1}, {30, 0.2, 1}, {60, 0.2, 1}, {30, 0.2, 1}}};
// Steep changes have to go on in several steps, and close corners that open later; the number of faces comes
// later, too. A coast that nobody asked anything of would keep 84 singular vertices so, not 73.
constexpr std::array<RespacingPass, 7> steep = {
    {{16, 1, 1}, {30, 1, 1}, {60, 1, 1}, {30, 1, 0.6}, {60, 1, 0.6}, {30, 1, 0.4}, {60, 1, 0.4}}};

} // namespace

std::span<const RespacingPass> respacings(bool wished) {
    return wished ? std::span<const RespacingPass>(steep) : even;
}

Pass pass_of(const RespacingPass &respacing, const refill::ShapeBounds &shape) {
    constexpr int most_added = 8; // sizes change with singular vertices
    Pass pass;
    pass.purpose = Purpose::respace;
    pass.size = respacing.size;
    pass.slack = respacing.slack;
    pass.shape = shape;
    pass.most_added = most_added;
    return pass;
}

void want_boundary(const mesh::QuadMesh &mesh, reference::Reference &reference,
                   const reference::SizingField &sizing, std::int64_t wanted) {
    const double longer = std::sqrt(static_cast<double>(mesh.n_faces()) / static_cast<double>(wanted));
    reference.boundary = reference::boundary_of(mesh, longer);
    reference.edge_length = [&reference, &sizing, longer](surface::CurvePlace place) {
        const Eigen::Vector3d point = reference.boundary->curves->at(place);
        const double by_area = std::sqrt(reference.face_weight) * sizing.edge_length(point);
        return sizing.wished() ? by_area
                               : std::max(by_area, longer * reference.boundary->present_length(place));
    };
}

} // namespace alphamst::adapt
