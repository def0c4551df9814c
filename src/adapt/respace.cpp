#include "adapt/respace.h"

#include <algorithm>
#include <cmath>

namespace alphamst::adapt {

Pass pass_of(const RespacingPass &respacing, const refill::ShapeBounds &shape) {
    constexpr int most_added = 8; // sizes change with singular vertices
    Pass pass;
    pass.purpose = Purpose::respace;
    pass.size = respacing.size;
    pass.slack = 1; // their number comes later
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
