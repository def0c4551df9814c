#include "quality/element.h"

namespace alphamst::quality {
namespace {

constexpr double gauss = 0.577350269189626; // 1 / sqrt(3), the points of the 2 x 2 rule
constexpr std::array<std::array<double, 2>, 4> node = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

using Four = std::array<Vector, 4>;

// Cross product of the derivatives of the bilinear map of [-1, 1]^2 onto four corners.
Vector jacobian_vector(const Four &corner, double s, double t) {
    const Vector along_s = (1 - t) * (corner[1] - corner[0]) + (1 + t) * (corner[2] - corner[3]);
    const Vector along_t = (1 - s) * (corner[3] - corner[0]) + (1 + s) * (corner[2] - corner[1]);
    return along_s.cross(along_t) / 16;
}

// Mean of the unit normals at two corners that agree, of corners 0, 2 and 1.
Vector facing(const Four &unit) {
    const Vector &a = unit[0], &b = unit[2], &c = unit[1];
    if (a.dot(b) > 0)
        return (a + b) / 2;
    return a.dot(c) > 0 ? (a + c) / 2 : (b + c) / 2;
}

} // namespace

// Smallest Jacobian determinant, over Gauss points and nodes, of the element as a shell
// of a thousandth of its width, over its area. 8 is the volume of the parent shell.
double distortion(const Element &e) {
    // The triangle 0, 1, 2: its determinant is twice the area at every corner.
    if (e.collapsed())
        return e.normal[1].isZero(0) ? 0 : 2;

    const Four corner = {Vector::Zero(), e.edge[0], e.diagonal[0], -e.edge[3]};
    Four unit, normal;
    double area = 0;
    bool flat = true;
    for (std::size_t k = 0; k < 4; ++k) {
        area += jacobian_vector(corner, gauss * node[k][0], gauss * node[k][1]).norm();
        normal[k] = jacobian_vector(corner, node[k][0], node[k][1]);
        unit[k] = direction(normal[k]);
        flat = flat && std::abs(unit[0].dot(unit[k])) >= 0.99;
    }
    if (!(area > 0))
        return 0;

    const double thickness = 0.001 * std::sqrt(area);
    const double offset = flat ? 0 : gauss * thickness / 2; // Gauss points through the shell
    double smallest = huge;
    for (std::size_t g = 0; g < 4; ++g) {
        const double s = gauss * node[g][0], t = gauss * node[g][1];
        Vector through = Vector::Zero();
        for (std::size_t k = 0; k < 4; ++k)
            through += (1 + s * node[k][0]) * (1 + t * node[k][1]) / 4 * unit[k];
        for (const double level : {-offset, offset}) {
            Four layer;
            for (std::size_t k = 0; k < 4; ++k)
                layer[k] = corner[k] + level * unit[k];
            smallest = std::min(smallest, through.dot(jacobian_vector(layer, s, t)));
        }
    }
    const Vector front = facing(unit);
    for (std::size_t k = 0; k < 4; ++k)
        smallest = std::min(smallest, (front.dot(normal[k]) > 0 ? 1 : -1) * normal[k].norm());
    return bounded(4 * smallest / area);
}

} // namespace alphamst::quality
