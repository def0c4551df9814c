#include "mesh/feature.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>

#include "surface/angle.h"

namespace alphamst::mesh {
namespace {

using Eigen::Vector3d;

constexpr double corner_turn = 60, fold_turn = 180 - 1e-3; // degrees

Vector3d point_of(const QuadMesh &mesh, int vertex) {
    const OpenMesh::Vec3d &p = mesh.point(vertex);
    return {p[0], p[1], p[2]};
}

// Twice the area of the face in each of the three planes.
Vector3d area_vector(const QuadMesh &mesh, int face) {
    const auto [a, b, c, d] = mesh.corners(face);
    return (point_of(mesh, c) - point_of(mesh, a)).cross(point_of(mesh, d) - point_of(mesh, b));
}

std::vector<int> sharp_edges(const QuadMesh &mesh, double angle) {
    std::vector<Vector3d> normals;
    normals.reserve(static_cast<std::size_t>(mesh.n_faces()));
    for (int f = 0; f < mesh.n_faces(); ++f)
        normals.push_back(area_vector(mesh, f).normalized()); // stays zero if it is
    std::vector<int> sharp;
    for (int e = 0; e < mesh.n_edges(); ++e) {
        const auto [left, right] = mesh.edge_faces(e);
        if (left >= 0 && right >= 0 &&
            surface::degrees_between(normals[static_cast<std::size_t>(left)],
                                     normals[static_cast<std::size_t>(right)]) > angle)
            sharp.push_back(e);
    }
    return sharp;
}

// Where the curves of these edges end, cross or turn.
std::vector<int> corners_of(const QuadMesh &mesh, const std::vector<bool> &on_curve) {
    struct Ends {
        int n = 0;
        std::array<int, 2> others = {-1, -1}; // across the first two
    };
    std::vector<Ends> ends(static_cast<std::size_t>(mesh.n_vertices()));
    const auto note = [&](int vertex, int other) {
        Ends &at = ends[static_cast<std::size_t>(vertex)];
        if (at.n < 2)
            at.others[static_cast<std::size_t>(at.n)] = other;
        ++at.n;
    };
    for (int e = 0; e < mesh.n_edges(); ++e)
        if (on_curve[static_cast<std::size_t>(e)]) {
            const auto [v, w] = mesh.edge_vertices(e);
            note(v, w);
            note(w, v);
        }
    const auto turn = [&](int v, const std::array<int, 2> &others) {
        return surface::degrees_between(point_of(mesh, v) - point_of(mesh, others[0]),
                                        point_of(mesh, others[1]) - point_of(mesh, v));
    };
    std::vector<int> corners;
    for (int v = 0; v < mesh.n_vertices(); ++v) {
        const auto &[n, others] = ends[static_cast<std::size_t>(v)];
        const double turned = n == 2 ? turn(v, others) : corner_turn;
        if (n != 0 && (n != 2 || (turned > corner_turn && turned < fold_turn)))
            corners.push_back(v);
    }
    return corners;
}

// Flags and markers may be left out.
template <class Value> Value value(const std::vector<Value> &values, int i) {
    return static_cast<std::size_t>(i) < values.size() ? values[static_cast<std::size_t>(i)] : Value{};
}

} // namespace

Features find_features(const QuadMesh &mesh, double angle) {
    std::vector<int> edges = sharp_edges(mesh, angle);
    std::vector<bool> on_curve(static_cast<std::size_t>(mesh.n_edges()));
    for (std::size_t e = 0; e < mesh.edge_flags.size(); ++e)
        on_curve[e] = (mesh.edge_flags[e] & feature) != 0;
    for (const int e : edges)
        on_curve[static_cast<std::size_t>(e)] = true;
    return {std::move(edges), corners_of(mesh, on_curve)};
}

bool on_curve(const QuadMesh &mesh, int edge) {
    const auto [left, right] = mesh.edge_faces(edge);
    return left < 0 || right < 0 || (value(mesh.edge_flags, edge) & feature) != 0 ||
           value(mesh.edge_marker, edge) != 0 ||
           value(mesh.face_marker, left) != value(mesh.face_marker, right);
}

} // namespace alphamst::mesh
