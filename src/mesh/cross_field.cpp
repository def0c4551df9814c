#include "mesh/cross_field.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "index.h"
#include "mesh/feature.h"
#include "stop.h"
#include "surface/cross_field.h"
#include "surface/principal.h"

namespace alphamst::mesh {
namespace {

using Eigen::Vector3d;
using surface::Complex;
using surface::Frame;
using surface::Guide;
using surface::Links;

// Of links, which is 1 between squares.
constexpr double least_weight = 0.1, most_weight = 10;
constexpr double curve_weight = 100;
// Times area * (difference of curvatures)^2, which does not depend on the scale and whose sum over a part of
// the surface does not depend on the faces there; up to the largest weight.
constexpr double bend_weight = 8, most_bend_weight = 4;
constexpr int rounds = 2; // of averaging curvatures

// Where a mesh is, moved and scaled to a box of side 2, so that no product overflows.
class Places {
public:
    explicit Places(const QuadMesh &mesh) : mesh_(mesh), centre_(Vector3d::Zero()) {
        Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
        for (int v = 0; v < mesh.n_vertices(); ++v) {
            low = low.cwiseMin(given(v));
            high = high.cwiseMax(given(v));
        }
        centre_ = low / 2 + high / 2;
        scale_ = (high / 2 - low / 2).maxCoeff();
        if (!(scale_ > 0))
            scale_ = 1;
    }

    Vector3d operator()(int v) const { return (given(v) - centre_) / scale_; }
    Vector3d side(const std::array<int, 2> &vertices) const {
        return (*this)(vertices[1]) - (*this)(vertices[0]);
    }
    // Twice the area of the face in each of the three planes.
    Vector3d area_vector(int face) const {
        const auto [a, b, c, d] = mesh_.corners(face);
        return side({a, c}).cross(side({b, d}));
    }
    Vector3d centre(int face) const {
        const auto [a, b, c, d] = mesh_.corners(face);
        return ((*this)(a) + (*this)(b) + (*this)(c) + (*this)(d)) / 4;
    }

private:
    Vector3d given(int v) const {
        const OpenMesh::Vec3d &p = mesh_.point(v);
        return {p[0], p[1], p[2]};
    }

    const QuadMesh &mesh_;
    Vector3d centre_;
    double scale_ = 1;
};

Vector3d normal(const Vector3d &area) {
    const double length = area.norm();
    return length > 0 ? Vector3d(area / length) : Vector3d(Vector3d::UnitZ());
}

std::array<int, 2> side_of(const std::array<int, 4> &corners, std::size_t i) {
    return {corners[i], corners[(i + 1) % 4]};
}

// Of faces across edges: the weight is how long the edge is, seen from one face to the other, over how far
// apart these are, as in a method of finite volumes; within bounds.
Links links_of(const QuadMesh &mesh, const Places &places) {
    Links links;
    links.frames.reserve(at(mesh.n_faces()));
    for (int f = 0; f < mesh.n_faces(); ++f)
        links.frames.emplace_back(normal(places.area_vector(f)));
    links.begin.assign(at(mesh.n_faces()) + 1, 0);
    const auto each = [&](const auto &visit) {
        for (int e = 0; e < mesh.n_edges(); ++e)
            if (const auto [left, right] = mesh.edge_faces(e); left >= 0 && right >= 0)
                visit(e, left, right);
    };
    each([&](int, int left, int right) {
        ++links.begin[at(left) + 1];
        ++links.begin[at(right) + 1];
    });
    for (std::size_t f = 1; f < links.begin.size(); ++f)
        links.begin[f] += links.begin[f - 1];
    links.neighbours.resize(links.begin.back());
    links.weights.resize(links.begin.back());
    std::vector<std::size_t> next(links.begin.begin(), links.begin.end() - 1);
    each([&](int e, int left, int right) {
        const Vector3d across = places.centre(right) - places.centre(left);
        const double area = across.cross(places.side(mesh.edge_vertices(e))).norm(),
                     way = across.squaredNorm();
        const double weight = area < most_weight * way ? std::max(area / way, least_weight) : most_weight;
        for (const auto &[from, to] : {std::array{left, right}, std::array{right, left}}) {
            links.neighbours[next[at(from)]] = to;
            links.weights[next[at(from)]++] = weight;
        }
    });
    return links;
}

void add_curves(const QuadMesh &mesh, const Places &places, std::vector<Guide> &guides) {
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (on_curve(mesh, e))
            for (const int f : mesh.edge_faces(e))
                if (f >= 0)
                    guides.push_back({f, places.side(mesh.edge_vertices(e)), curve_weight});
}

void add_bends(const QuadMesh &mesh, const Places &places, const Links &links, std::vector<Guide> &guides) {
    std::vector<Vector3d> normals(at(mesh.n_vertices()), Vector3d::Zero());
    for (int f = 0; f < mesh.n_faces(); ++f)
        for (const int v : mesh.corners(f))
            normals[at(v)] += places.area_vector(f);
    for (Vector3d &sum : normals)
        sum = normal(sum);
    std::vector<Complex> deviations;
    deviations.reserve(at(mesh.n_faces()));
    for (int f = 0; f < mesh.n_faces(); ++f) {
        Stop::point();
        std::array<surface::Bend, 4> bends;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::array<int, 2> side = side_of(mesh.corners(f), i);
            bends[i] = {places.side(side), normals[at(side[1])] - normals[at(side[0])]};
        }
        deviations.push_back(surface::deviation(links.frames[at(f)], bends));
    }
    surface::average(links, deviations, rounds);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Complex deviation = deviations[at(f)];
        const double difference = 2 * length(deviation), area = places.area_vector(f).norm() / 2;
        const double weight = std::min(bend_weight * area * difference * difference, most_bend_weight);
        if (weight > 0)
            guides.push_back({f, links.frames[at(f)].at(half(unit(deviation, {1, 0}))), weight});
    }
}

} // namespace

std::vector<double> cross_field(const QuadMesh &mesh, int sweeps, const Pace &pace) {
    const Places places(mesh);
    pace.reach(0);
    const Links links = links_of(mesh, places);
    std::vector<Guide> guides;
    pace.reach(0);
    add_curves(mesh, places, guides);
    if (mesh.dim() == 3)
        add_bends(mesh, places, links, guides);
    pace.reach(0);
    std::vector<double> crosses;
    crosses.reserve(3 * at(mesh.n_faces()));
    for (const Vector3d &direction : surface::solve_cross_field(links, guides, sweeps, pace))
        crosses.insert(crosses.end(), {direction.x(), direction.y(), direction.z()});
    return crosses;
}

double alignment(const QuadMesh &mesh, std::span<const double> crosses) {
    const Places places(mesh);
    double sum = 0;
    std::size_t n = 0;
    for (int f = 0; f < mesh.n_faces(); ++f) {
        const Frame frame(normal(places.area_vector(f)));
        const Vector3d given(crosses[3 * at(f)], crosses[3 * at(f) + 1], crosses[3 * at(f) + 2]);
        const Complex cross = square(square(unit(frame.of(given.stableNormalized()), {})));
        for (std::size_t i = 0; i < 4; ++i) {
            const Vector3d side = places.side(side_of(mesh.corners(f), i));
            const Complex between = conjugate(cross) * square(square(unit(frame.of(side), {})));
            if (between.re == 0 && between.im == 0)
                continue;
            sum += std::abs(std::atan2(between.im, between.re)) / 4;
            ++n;
        }
    }
    return n == 0 ? 0 : sum / static_cast<double>(n) * 180 / std::numbers::pi;
}

} // namespace alphamst::mesh
