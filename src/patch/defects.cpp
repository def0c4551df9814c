#include "patch/region.h"
#include "patch/window.h"

namespace alphamst::patch {

std::int32_t defects(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    return defects_of(mesh, Region(mesh, faces));
}

std::int32_t defects_of(const mesh::QuadMesh &mesh, const Region &region) {
    if (region.faces.empty())
        return empty;
    std::int32_t found = 0;

    const std::size_t n_parts = parts(mesh, region.faces, true).size();
    if (n_parts > 1)
        found |= not_connected;
    if (region.pinched(mesh))
        found |= pinched;

    // Euler characteristic with the region cut open at its pinches: it then has as many
    // boundary vertices as boundary edges, and these cancel. A disk has 1.
    if (region.faces.size() + region.interior.size() != region.inner.size() + n_parts)
        found |= not_disk;

    const auto crossed = [&](Halfedge h) { return barrier(mesh, h); };
    const auto is_held = [&](int v) { return held(mesh, v); };
    const auto is_fixed = [&](int f) {
        return (mesh.face_flags[static_cast<std::size_t>(f)] & mesh::fixed) != 0;
    };
    if (std::any_of(region.faces.begin(), region.faces.end(), is_fixed) ||
        std::any_of(region.inner.begin(), region.inner.end(), crossed) ||
        std::any_of(region.interior.begin(), region.interior.end(), is_held))
        found |= crosses_feature;

    // Four edges a face, inner edges twice: odd for no set of quadrilaterals.
    if (region.boundary.size() % 2 != 0)
        found |= odd_boundary;
    return found;
}

} // namespace alphamst::patch
