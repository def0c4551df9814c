#include "patch/window.h"

#include "patch/region.h"

#include <cmath>
#include <numbers>

namespace alphamst::patch {
namespace {

// Around one vertex of the loop.
struct Star {
    int inside = 0, outside = 0;        // faces
    double angle = 0, inside_angle = 0; // degrees
    bool mesh_boundary = false;
};

Star star_of(const mesh::QuadMesh &mesh, std::span<const int> faces, Halfedge start) {
    const Kernel &kernel = mesh.kernel();
    Star star;
    Halfedge h = start;
    do {
        const int face = left(mesh, h);
        if (face < 0) {
            star.mesh_boundary = true;
        } else {
            const double angle = corner_angle(mesh, h) * 180 / std::numbers::pi;
            star.angle += angle;
            if (contains(faces, face)) {
                ++star.inside;
                star.inside_angle += angle;
            } else {
                ++star.outside;
            }
        }
        h = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(h));
    } while (h != start);
    return star;
}

// The boundary half-edges in the order of the loop.
std::vector<Halfedge> walk(const mesh::QuadMesh &mesh, const Region &region) {
    std::vector<Halfedge> path;
    path.reserve(region.boundary.size());
    for (std::size_t i = 0; path.size() < region.boundary.size();) {
        const Halfedge h = region.boundary[i];
        path.push_back(h);
        const auto next = std::lower_bound(region.boundary.begin(), region.boundary.end(), to(mesh, h),
                                           [&](Halfedge a, int v) { return from(mesh, a) < v; });
        i = static_cast<std::size_t>(next - region.boundary.begin());
        if (i == 0)
            break;
    }
    return path;
}

} // namespace

int wanted_at(int regular, int outside, double inside_angle) {
    const int spanned = 1 + static_cast<int>(inside_angle / 175); // a face spans less than 180 degrees
    return std::max(regular - outside, spanned);
}

int regular_at_boundary(double angle) { return std::max(1, static_cast<int>(std::lround(angle / 90))); }

Window make_window(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    return window_of(mesh, Region(mesh, faces));
}

Window window_of(const mesh::QuadMesh &mesh, Region region) {
    const std::vector<Halfedge> path = walk(mesh, region);
    if (path.empty() || path.size() != region.boundary.size() || region.pinched(mesh))
        throw Failure(Fault::patch, "the faces of a patch do not form a disk");

    Window window;
    for (const Halfedge h : path) {
        const Star star = star_of(mesh, region.faces, h);
        window.loop.push_back(from(mesh, h));
        window.inside.push_back(star.inside);
        window.outside.push_back(star.outside);
        window.wanted.push_back(wanted_at(star.mesh_boundary ? regular_at_boundary(star.angle) : 4,
                                          star.outside, star.inside_angle));
        window.angles.push_back(star.inside_angle);
    }
    window.faces = std::move(region.faces);
    window.interior = std::move(region.interior);
    return window;
}

int singularities(const mesh::QuadMesh &mesh, const Window &window) {
    const auto singular = [&](int v) { return mesh.singular(v); };
    return static_cast<int>(std::count_if(window.interior.begin(), window.interior.end(), singular) +
                            std::count_if(window.loop.begin(), window.loop.end(), singular));
}

} // namespace alphamst::patch
