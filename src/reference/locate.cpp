#include "reference/locate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "surface/boxes.h"

namespace alphamst::reference {
namespace {

namespace spatial_index = surface::spatial_index;
using Eigen::Vector3d;
using surface::Box;
using surface::box_corner;
using surface::box_of;
using surface::BoxEntry;
using surface::BoxTree;

// The entries whose boxes meet the ball around the point that reaches to the entry of the nearest
// box: among them are all that are nearest. squared(number) is the squared distance of an entry.
template <class Distance>
std::vector<int> candidates(const BoxTree &tree, const Vector3d &point, const Distance &squared) {
    BoxEntry one;
    tree.query(spatial_index::nearest(box_corner(point), 1), &one);
    // A little further, so that rounding hides no tie.
    const Vector3d reach = Vector3d::Constant(std::sqrt(squared(one.second)) * (1 + 1e-12));
    std::vector<int> found{one.second};
    const Box box(box_corner(point - reach), box_corner(point + reach));
    for (auto entry = tree.qbegin(spatial_index::intersects(box)); entry != tree.qend(); ++entry)
        found.push_back(entry->second);
    return found;
}

} // namespace

struct PointTree::Tree {
    BoxTree boxes;
};

struct FaceTree::Tree {
    BoxTree boxes;
};

geometry::Quad quad_of(const mesh::QuadMesh &mesh, int face) {
    geometry::Quad quad;
    const std::array<int, 4> corners = mesh.corners(face);
    for (std::size_t i = 0; i < 4; ++i)
        quad[i] = point_of(mesh, corners[i]);
    return quad;
}

Vector3d point_of(const mesh::QuadMesh &mesh, int vertex) {
    const OpenMesh::Vec3d &p = mesh.point(vertex);
    return {p[0], p[1], p[2]};
}

PointTree::PointTree(std::vector<Vector3d> points) : points_(std::move(points)) {
    std::vector<BoxEntry> entries;
    entries.reserve(points_.size());
    for (const Vector3d &p : points_)
        entries.emplace_back(box_of(std::span(&p, 1)), static_cast<int>(entries.size()));
    tree_.reset(new Tree{BoxTree(entries)});
}

PointTree::~PointTree() = default;

std::size_t PointTree::nearest(const Vector3d &point) const {
    const auto squared = [&](int i) { return (points_[static_cast<std::size_t>(i)] - point).squaredNorm(); };
    std::pair<double, int> best{HUGE_VAL, 0};
    for (const int i : candidates(tree_->boxes, point, squared))
        best = std::min(best, {squared(i), i});
    return static_cast<std::size_t>(best.second);
}

FaceTree::FaceTree(const mesh::QuadMesh &mesh, std::vector<int> faces) : mesh_(mesh) {
    std::vector<BoxEntry> entries;
    entries.reserve(faces.size());
    for (const int face : faces)
        entries.emplace_back(box_of(quad_of(mesh, face)), face);
    tree_.reset(new Tree{BoxTree(entries)});
}

FaceTree::~FaceTree() = default;

FaceTree::Place FaceTree::nearest(const Vector3d &point) const {
    const auto spot_of = [&](int face) { return geometry::closest_point(quad_of(mesh_, face), point); };
    const auto squared = [&](int face) { return spot_of(face).distance; };
    std::optional<Place> best;
    for (const int face : candidates(tree_->boxes, point, squared)) {
        const geometry::QuadPoint spot = spot_of(face);
        if (!best || std::pair(spot.distance, face) < std::pair(best->spot.distance, best->face))
            best = Place{face, spot};
    }
    return *best;
}

void FaceTree::around(const geometry::Quad &quad, std::vector<int> &found) const {
    found.clear();
    // In one plane, or nearly, two boxes may be flat and miss each other by rounding.
    const double across = std::max((quad[2] - quad[0]).norm(), (quad[3] - quad[1]).norm());
    const Box box = box_of(quad, across / 8);
    for (auto entry = tree_->boxes.qbegin(spatial_index::intersects(box)); entry != tree_->boxes.qend();
         ++entry)
        found.push_back(entry->second);
    std::sort(found.begin(), found.end());
}

} // namespace alphamst::reference
