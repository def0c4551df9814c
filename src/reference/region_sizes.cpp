#include "reference/region_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "index.h"
#include "patch/region.h"

namespace alphamst::reference {
namespace {

constexpr double points_per_face = 4; // of the lattice: fewer points than faces with their corners
constexpr double least_points = 1000; // cheap for any patch
// A patch so thin that it takes more of them goes without a lattice.
constexpr double most_points_per_face = 64;
// Of the areas that are there: one small face among large ones is not to rule.
constexpr int smoothings = 6;

double area(const geometry::Quad &quad) { return std::max(geometry::area_vector(quad).norm(), 1e-300); }

geometry::Quad quad_of(const std::array<int, 4> &q, const std::vector<Eigen::Vector3d> &positions) {
    return {positions[alphamst::at(q[0])], positions[alphamst::at(q[1])], positions[alphamst::at(q[2])],
            positions[alphamst::at(q[3])]};
}

double squared_distance(const Eigen::Vector3d &x, const Eigen::Vector3d &a, const Eigen::Vector3d &b) {
    const Eigen::Vector3d along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((x - a).dot(along) / length, 0.0, 1.0) : 0;
    return (x - a - t * along).squaredNorm();
}

std::vector<double> smoothed(std::vector<double> values, const fill::Filling &filling) {
    std::vector<double> sum(alphamst::at(filling.vertices)), faces(alphamst::at(filling.vertices));
    for (const auto &q : filling.quads)
        for (const int v : q)
            faces[alphamst::at(v)] += 1;
    for (int sweep = 0; sweep < smoothings; ++sweep) {
        std::fill(sum.begin(), sum.end(), 0);
        for (std::size_t f = 0; f < values.size(); ++f)
            for (const int v : filling.quads[f])
                sum[alphamst::at(v)] += values[f];
        for (std::size_t f = 0; f < values.size(); ++f) {
            values[f] = 0;
            for (const int v : filling.quads[f])
                values[f] += sum[alphamst::at(v)] / faces[alphamst::at(v)] / 4;
        }
    }
    return values;
}

std::vector<Eigen::Vector3d> centres(const fill::Filling &filling,
                                     const std::vector<Eigen::Vector3d> &positions) {
    std::vector<Eigen::Vector3d> points;
    for (const auto &q : filling.quads)
        points.push_back(geometry::centre(quad_of(q, positions)));
    return points;
}

// Vertices in the order in which the faces name them first.
template <class Visit>
void number_vertices(const mesh::QuadMesh &mesh, std::span<const int> region, const Visit &visit) {
    std::unordered_map<int, int> number;
    for (const int f : region)
        for (const int v : mesh.corners(f))
            visit(v, number.emplace(v, static_cast<int>(number.size())));
}

// What smoothing over neighbours needs of the region.
fill::Filling filling_of(const mesh::QuadMesh &mesh, std::span<const int> region) {
    fill::Filling filling;
    std::size_t corner = 0;
    number_vertices(mesh, region, [&](int, const auto &entry) {
        if (corner % 4 == 0)
            filling.quads.push_back({});
        filling.quads.back()[corner++ % 4] = entry.first->second;
        filling.vertices += static_cast<int>(entry.second);
    });
    return filling;
}

std::vector<Eigen::Vector3d> points_of(const mesh::QuadMesh &mesh, std::span<const int> region) {
    std::vector<Eigen::Vector3d> points;
    number_vertices(mesh, region, [&](int vertex, const auto &entry) {
        if (entry.second)
            points.push_back(point_of(mesh, vertex));
    });
    return points;
}

} // namespace

RegionSizes::RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions,
                         double faces, double transition, std::vector<double> areas,
                         std::span<const char> stays)
    : RegionSizes(old, positions, faces, transition, std::move(areas), border_of(old, positions, stays)) {}

RegionSizes::RegionSizes(const mesh::QuadMesh &mesh, std::span<const int> region, double faces,
                         double transition, const Boundary *boundary)
    : RegionSizes(filling_of(mesh, region), points_of(mesh, region), faces, transition, {},
                  border_of(mesh, region, boundary)) {}

RegionSizes::RegionSizes(const fill::Filling &old, const std::vector<Eigen::Vector3d> &positions,
                         double faces, double transition, std::vector<double> areas, Border border)
    : border_(std::move(border)), faces_(centres(old, positions)) {
    std::vector<double> share; // of the faces, were nothing divided
    for (std::size_t f = 0; f < old.quads.size(); ++f) {
        const double now = area(quad_of(old.quads[f], positions));
        log_areas_.push_back(std::log(areas.empty() ? now : areas[f]));
        share.push_back(areas.empty() ? 1 : now / areas[f]);
    }
    if (areas.empty())
        log_areas_ = smoothed(std::move(log_areas_), old);
    std::vector<double> depths;
    for (const Eigen::Vector3d &place : centres(old, positions))
        depths.push_back(distance(place));
    depth_ = transition * *std::max_element(depths.begin(), depths.end());
    double low = -9, high = 9; // 8,000 times finer or coarser
    for (int halving = 0; halving < 60; ++halving) {
        log_factor_ = (low + high) / 2;
        double sum = 0;
        for (std::size_t f = 0; f < depths.size(); ++f)
            sum += share[f] * std::exp(log_factor_ * std::min(1.0, depths[f] / depth_));
        (sum < faces ? low : high) = log_factor_;
    }
    if (border_.any &&
        std::all_of(positions.begin(), positions.end(), [](const Eigen::Vector3d &p) { return p.z() == 0; }))
        make_lattice();
}

void RegionSizes::Border::add(const Segment &segment, bool stays) {
    low = any ? low.cwiseMin(segment[0]) : segment[0];
    high = any ? high.cwiseMax(segment[0]) : segment[0];
    any = true;
    if (stays)
        segments.push_back(segment);
}

RegionSizes::Border RegionSizes::border_of(const fill::Filling &old,
                                           const std::vector<Eigen::Vector3d> &positions,
                                           std::span<const char> stays) {
    Border border;
    const std::size_t n = alphamst::at(old.boundary);
    for (std::size_t i = 0; i < n; ++i)
        border.add({positions[i], positions[(i + 1) % n]}, stays.empty() || stays[i] != 0);
    return border;
}

RegionSizes::Border RegionSizes::border_of(const mesh::QuadMesh &mesh, std::span<const int> region,
                                           const Boundary *boundary) {
    Border border;
    for (const patch::Halfedge h : patch::Region(mesh, region).boundary)
        border.add({point_of(mesh, patch::from(mesh, h)), point_of(mesh, patch::to(mesh, h))},
                   boundary == nullptr ||
                       !boundary->may_change(mesh, patch::from(mesh, h), patch::to(mesh, h)));
    return border;
}

double RegionSizes::distance(const Eigen::Vector3d &place) const {
    if (border_.segments.empty()) // all of it is far from there
        return 1;
    double least = std::numeric_limits<double>::infinity();
    for (const Segment &segment : border_.segments)
        least = std::min(least, squared_distance(place, segment[0], segment[1]));
    return std::sqrt(least);
}

double RegionSizes::computed(const Eigen::Vector3d &place) const {
    return log_areas_[faces_.nearest(place)] - log_factor_ * std::min(1.0, distance(place) / depth_);
}

double RegionSizes::part(const Eigen::Vector3d &place) const {
    return std::exp(-log_factor_ * std::min(1.0, distance(place) / depth_));
}

void RegionSizes::make_lattice() {
    const Eigen::Vector3d extent = border_.high - border_.low;
    spacing_ =
        std::sqrt(extent.x() * extent.y() / (points_per_face * static_cast<double>(log_areas_.size())));
    const double points = (extent.x() / spacing_ + 2) * (extent.y() / spacing_ + 2);
    if (!(points <= most_points_per_face * static_cast<double>(log_areas_.size()) + least_points))
        return; // nor if it is a line
    columns_ = static_cast<int>(extent.x() / spacing_) + 2;
    rows_ = static_cast<int>(extent.y() / spacing_) + 2;
    origin_ = border_.low;
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i)
            lattice_.push_back(computed(origin_ + spacing_ * Eigen::Vector3d(i, j, 0)));
}

double RegionSizes::log_at(const Eigen::Vector3d &place) const {
    if (lattice_.empty())
        return computed(place);
    const Eigen::Vector3d p = (place - origin_) / spacing_;
    const double x = std::clamp(p.x(), 0.0, columns_ - 1.001), y = std::clamp(p.y(), 0.0, rows_ - 1.001);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const auto value = [&](int column, int row) { return lattice_[alphamst::at(row * columns_ + column)]; };
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * value(i, j) + u * value(i + 1, j)) +
           v * ((1 - u) * value(i, j + 1) + u * value(i + 1, j + 1));
}

SizeError RegionSizes::error(std::span<const geometry::Quad> quads) const {
    std::vector<double> log_wanted;
    log_wanted.reserve(quads.size());
    for (const geometry::Quad &quad : quads)
        log_wanted.push_back(log_at(geometry::centre(quad)));
    return size_error(quads, log_wanted);
}

} // namespace alphamst::reference
