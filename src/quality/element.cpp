#include "quality/element.h"

namespace alphamst::quality {

Element::Element(const Corners &quad) {
    const Vector low = quad[0].cwiseMin(quad[1]).cwiseMin(quad[2].cwiseMin(quad[3]));
    const Vector high = quad[0].cwiseMax(quad[1]).cwiseMax(quad[2].cwiseMax(quad[3]));
    // Not compared with tiny: an element may be small, but not below what can be divided by.
    const double extent = (high - low).stableNorm();
    if (extent > 1e-300)
        size = extent;

    const auto between = [&](std::size_t a, std::size_t b) { return Vector((quad[b] - quad[a]) / size); };
    for (std::size_t k = 0; k < 4; ++k) {
        edge[k] = between(k, (k + 1) % 4);
        length[k] = edge[k].norm();
    }
    diagonal = {between(0, 2), between(1, 3)};
    axis = {edge[0] - edge[2], edge[1] - edge[3]};

    const Vector centre_normal = direction(axis[0].cross(axis[1]));
    for (std::size_t k = 0; k < 4; ++k) {
        normal[k] = edge[(k + 3) % 4].cross(edge[k]);
        corner_area[k] = centre_normal.dot(normal[k]);
    }
}

} // namespace alphamst::quality
