#include "patch/window.h"

#include <algorithm>
#include <cmath>

namespace alphamst::patch {
namespace {

using Point = OpenMesh::Vec2d;

double turn(const Point &a, const Point &b, const Point &c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double polygon_area(const std::vector<Point> &polygon) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        twice += turn(polygon[0], polygon[i], polygon[i + 1]);
    return twice / 2;
}

// Monotone chain (Andrew 1979).
std::vector<Point> convex_hull(std::vector<Point> points) {
    std::sort(points.begin(), points.end(),
              [](const Point &a, const Point &b) { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); });
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t base = hull.size();
        for (const Point &p : points) {
            while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

// The loop seen along its area vector (Newell's normal), so that it runs counter-clockwise.
std::vector<Point> project(const mesh::QuadMesh &mesh, const std::vector<int> &loop) {
    using Vector = OpenMesh::Vec3d;
    const Vector origin = mesh.point(loop[0]);
    Vector normal(0, 0, 0);
    for (std::size_t i = 0; i < loop.size(); ++i)
        normal += (mesh.point(loop[i]) - origin) % (mesh.point(loop[(i + 1) % loop.size()]) - origin);
    if (!(normal.norm() > 0))
        return {};
    normal.normalize();
    const std::size_t least = static_cast<std::size_t>(
        std::abs(normal[0]) < std::abs(normal[1]) ? (std::abs(normal[0]) < std::abs(normal[2]) ? 0 : 2)
                                                  : (std::abs(normal[1]) < std::abs(normal[2]) ? 1 : 2));
    Vector along(0, 0, 0);
    along[least] = 1;
    const Vector x = (along % normal).normalize(), y = normal % x;
    std::vector<Point> flat;
    for (const int v : loop)
        flat.emplace_back((mesh.point(v) - origin) | x, (mesh.point(v) - origin) | y);
    return flat;
}

} // namespace

double convexity(const mesh::QuadMesh &mesh, const Window &window) {
    const std::vector<Point> flat = project(mesh, window.loop);
    if (flat.size() < 3)
        return 0;
    const double hull = polygon_area(convex_hull(flat));
    return hull > 0 ? std::clamp(polygon_area(flat) / hull, 0.0, 1.0) : 0;
}

} // namespace alphamst::patch
