#include "reference/statistics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "index.h"
#include "patch/region.h"
#include "reference/locate.h"

namespace alphamst::reference {
namespace {

// Of n quads.
template <class QuadOf, class Measure> double least(std::size_t n, QuadOf quad, Measure measure) {
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i)
        result = std::min(result, measure(quad(i)));
    return n == 0 ? 0 : result;
}

double scaled_jacobian(const geometry::Quad &quad) {
    return quality::measure(quality::Metric::scaled_jacobian, quad, 1);
}

// So that the least of it belongs to the largest one.
double minus_aspect_ratio(const geometry::Quad &quad) {
    return -quality::measure(quality::Metric::aspect_ratio, quad, 1);
}

double area_over_perimeter(const geometry::Quad &quad) {
    double perimeter = 0;
    for (std::size_t k = 0; k < 4; ++k)
        perimeter += (quad[(k + 1) % 4] - quad[k]).norm();
    return perimeter > 0 ? geometry::area_vector(quad).norm() / perimeter : 0;
}

template <class Measure> double least_of(const mesh::QuadMesh &mesh, Measure measure) {
    return least(
        at(mesh.n_faces()), [&](std::size_t f) { return quad_of(mesh, static_cast<int>(f)); }, measure);
}

template <class Measure>
double least_of(const mesh::QuadMesh &mesh, std::span<const int> faces, Measure measure) {
    return least(
        faces.size(), [&](std::size_t i) { return quad_of(mesh, faces[i]); }, measure);
}

template <class Measure>
double least_of(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points, Measure measure) {
    const auto quad_at = [&](std::size_t q) {
        geometry::Quad quad;
        for (std::size_t k = 0; k < 4; ++k) {
            const OpenMesh::Vec3d &p = points[at(quads[q][k])];
            quad[k] = {p[0], p[1], p[2]};
        }
        return quad;
    };
    return least(quads.size(), quad_at, measure);
}

} // namespace

void count(const mesh::QuadMesh &mesh, std::map<int, std::int64_t> &valences, std::int64_t &singular) {
    valences.clear();
    for (int v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.isolated(v) && !mesh.on_boundary(v))
            ++valences[mesh.valence(v)];
    singular = reference::singular(valences);
}

void count(const mesh::QuadMesh &mesh, std::span<const int> faces, std::map<int, std::int64_t> &valences,
           std::int64_t &singular) {
    std::vector<int> vertices;
    for (const int f : faces)
        for (const int v : mesh.corners(f))
            if (!mesh.on_boundary(v))
                vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    valences.clear();
    for (const int v : vertices)
        ++valences[mesh.valence(v)];
    singular = reference::singular(valences);
}

std::int64_t singular(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += valence != 4 ? count : 0;
    return sum;
}

bool fewest_singular(const std::map<int, std::int64_t> &valences) {
    std::int64_t sum = 0;
    for (const auto &[valence, count] : valences)
        sum += (4 - valence) * count;
    return singular(valences) <= std::abs(sum);
}

double least_quality(const mesh::QuadMesh &mesh) { return least_of(mesh, scaled_jacobian); }

double least_quality(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    return least_of(mesh, faces, scaled_jacobian);
}

double least_quality(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points) {
    return least_of(quads, points, scaled_jacobian);
}

// 0 - x, as -0 is not what no faces have.
double largest_aspect_ratio(const mesh::QuadMesh &mesh) { return 0 - least_of(mesh, minus_aspect_ratio); }

double largest_aspect_ratio(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    return 0 - least_of(mesh, faces, minus_aspect_ratio);
}

double largest_aspect_ratio(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points) {
    return 0 - least_of(quads, points, minus_aspect_ratio);
}

double time_step(const mesh::QuadMesh &mesh) { return least_of(mesh, area_over_perimeter); }

double time_step(const mesh::QuadMesh &mesh, std::span<const int> faces) {
    return least_of(mesh, faces, area_over_perimeter);
}

double time_step(geometry::Quads quads, std::span<const OpenMesh::Vec3d> points) {
    return least_of(quads, points, area_over_perimeter);
}

double time_step_ratio(double before, double after) { return before == after ? 1 : after / before; }

geometry::Points flatten(const mesh::QuadMesh &mesh, const geometry::Plane &plane) {
    geometry::Points positions;
    positions.reserve(static_cast<std::size_t>(mesh.n_vertices()));
    for (int v = 0; v < mesh.n_vertices(); ++v)
        positions.push_back(plane.to_plane(point_of(mesh, v)));
    return positions;
}

int mismatch(const mesh::QuadMesh &mesh, int vertex) {
    double angle = 0;
    int faces = 0;
    const auto &kernel = mesh.kernel();
    const auto start = kernel.halfedge_handle(OpenMesh::VertexHandle(vertex));
    auto h = start;
    do {
        if (patch::left(mesh, h) >= 0) {
            angle += patch::corner_angle(mesh, h);
            ++faces;
        }
        h = kernel.opposite_halfedge_handle(kernel.prev_halfedge_handle(h));
    } while (h != start);
    return std::max(1, static_cast<int>(std::lround(2 * angle / std::numbers::pi))) - faces;
}

} // namespace alphamst::reference
