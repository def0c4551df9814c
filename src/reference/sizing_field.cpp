#include "reference/sizing_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index.h"
#include "surface/curvature.h"

namespace alphamst::reference {
namespace {

// Curvatures count between these multiples of the mean one: edges are about four times as long where it
// is flat.
constexpr double flat = 0.1, sharp = 8;
// Below this, over the extent of the surface, curvatures are rounding, and a surface has one that is even.
constexpr double least_curvature = 1e-9;

double extent(const surface::Surface &surface) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d &p : surface.points())
        box.extend(p);
    return box.diagonal().norm();
}

// At each vertex, the root of the area that faces have around it, smoothed over neighbours: one small face
// among large ones is an accident and not wanted.
std::vector<double> present_sizes(const mesh::QuadMesh &mesh) {
    constexpr int smoothings = 6;
    std::vector<double> area, sum(alphamst::at(mesh.n_vertices())), count(sum.size(), 0);
    for (int f = 0; f < mesh.n_faces(); ++f)
        area.push_back(std::log(std::max(geometry::area_vector(quad_of(mesh, f)).norm(), 1e-300)));
    for (const auto &q : mesh.faces())
        for (const int v : q)
            ++count[alphamst::at(v)];
    for (int k = 0; k < smoothings; ++k) {
        std::fill(sum.begin(), sum.end(), 0);
        for (std::size_t f = 0; f < area.size(); ++f)
            for (const int v : mesh.faces()[f])
                sum[alphamst::at(v)] += area[f] / count[alphamst::at(v)];
        for (std::size_t f = 0; f < area.size(); ++f) {
            area[f] = 0;
            for (const int v : mesh.faces()[f])
                area[f] += sum[alphamst::at(v)] / 4;
        }
    }
    for (double &s : sum)
        s = std::exp(s / 2);
    return sum;
}

} // namespace

std::optional<SizingField> SizingField::of(const mesh::QuadMesh &mesh, Reference &reference,
                                           std::int64_t wanted) {
    if (mesh.n_faces() == 0)
        return std::nullopt;
    const std::vector<double> *wished = mesh.field(Entity::vertex, "size");
    if (wished == nullptr)
        return reference.surface
                   ? SizingField(reference, wanted)
                   : SizingField(std::make_shared<const mesh::QuadMesh>(mesh), present_sizes(mesh), false);
    // Its values are of the mesh as it was when the operation began.
    std::shared_ptr<const mesh::QuadMesh> begun =
        mesh.begun ? mesh.begun : std::make_shared<const mesh::QuadMesh>(mesh);
    if (wished->size() != alphamst::at(begun->n_vertices()))
        throw Failure(Fault::internal, "the field \"size\" is not of the mesh that the operation began with");
    SizingField field(std::move(begun), *wished, true);
    return reference.surface ? SizingField(reference, field) : std::move(field);
}

// With edges of length h the surface is missed by about its curvature times h^2 / 8. For a number of faces
// the mean square of that is least where the faces per area go with curvature^(2/3).
SizingField::SizingField(Reference &reference, std::int64_t wanted) : reference_(&reference), wished_(false) {
    const surface::Surface &surface = *reference.surface;
    const double points = static_cast<double>(surface.points().size());
    const double edges = std::sqrt(points / static_cast<double>(std::max<std::int64_t>(1, wanted)));
    const std::vector<double> curvature =
        surface::curvature(surface, std::clamp(static_cast<int>(edges), 1, 6));
    const double mean = std::max(std::accumulate(curvature.begin(), curvature.end(), 0.0) / points,
                                 least_curvature / extent(surface));
    for (const auto &[a, b, c] : surface.triangles()) {
        const double bend = (curvature[static_cast<std::size_t>(a)] + curvature[static_cast<std::size_t>(b)] +
                             curvature[static_cast<std::size_t>(c)]) /
                            3;
        reference.density.push_back(std::pow(flat * mean + std::min(bend, sharp * mean), 2.0 / 3));
    }
}

SizingField::SizingField(Reference &reference, const SizingField &field) : reference_(&reference) {
    const surface::Surface &surface = *reference.surface;
    for (const auto &[a, b, c] : surface.triangles())
        reference.density.push_back(field.at((surface.points()[static_cast<std::size_t>(a)] +
                                              surface.points()[static_cast<std::size_t>(b)] +
                                              surface.points()[static_cast<std::size_t>(c)]) /
                                             3));
}

SizingField::SizingField(std::shared_ptr<const mesh::QuadMesh> mesh, std::vector<double> sizes, bool wished)
    : mesh_(std::move(mesh)), size_(std::move(sizes)), wished_(wished) {
    std::vector<int> all(alphamst::at(mesh_->n_faces()));
    std::iota(all.begin(), all.end(), 0);
    faces_ = std::make_unique<const FaceTree>(*mesh_, std::move(all));
}

double SizingField::at(const Eigen::Vector3d &point) const {
    const FaceTree::Place place = faces_->nearest(point);
    const auto corners = mesh_->corners(place.face);
    double size = 0;
    for (std::size_t k = 0; k < 4; ++k)
        size += place.spot.weights[k] * size_[static_cast<std::size_t>(corners[k])];
    return 1 / (size * size);
}

double SizingField::of_face(const mesh::QuadMesh &mesh, int face) const {
    double sum = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : mesh.corners(face)) {
        middle += point_of(mesh, v) / 4;
        if (reference_)
            sum += reference_->density[static_cast<std::size_t>(
                       reference_->surface_triangles[static_cast<std::size_t>(v)])] /
                   4;
    }
    return reference_ ? sum : at(middle);
}

double SizingField::weight(const geometry::Quad &quad) const {
    return geometry::area_vector(quad).norm() * at(geometry::centre(quad));
}

std::vector<double> SizingField::weights(const mesh::QuadMesh &mesh, std::span<const int> faces) const {
    std::vector<double> weights;
    for (const int f : faces)
        weights.push_back(geometry::area_vector(quad_of(mesh, f)).norm() * of_face(mesh, f));
    return weights;
}

double SizingField::total(const mesh::QuadMesh &mesh) const {
    std::vector<int> all(alphamst::at(mesh.n_faces()));
    std::iota(all.begin(), all.end(), 0);
    const std::vector<double> each = weights(mesh, all);
    return std::accumulate(each.begin(), each.end(), 0.0);
}

} // namespace alphamst::reference
