#include "geometry/convex_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/star.h"
#include "geometry/tutte.h"
#include "index.h"

namespace alphamst::geometry {
namespace {

std::vector<double> loop_lengths(const Disk &disk) {
    std::vector<double> lengths;
    for (int i = 0; i < disk.boundary; ++i)
        lengths.push_back((disk.points[at((i + 1) % disk.boundary)] - disk.points[at(i)]).norm());
    return lengths;
}

double tangent_of_half(const Eigen::Vector3d &a, const Eigen::Vector3d &b) {
    return a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
}

} // namespace

ConvexMap::ConvexMap(const Disk &disk)
    : boundary_(disk.boundary), circle_(loop_on_circle(loop_lengths(disk))),
      free_(static_cast<int>(disk.points.size()) - disk.boundary) {
    const Stars stars(disk.quads, static_cast<int>(disk.points.size()));
    std::vector<double> weight(disk.points.size(), 0.0);
    for (int v = boundary_; v < stars.vertices(); ++v) {
        const Eigen::Vector3d &centre = disk.points[at(v)];
        for (const Sector &s : stars.at(v)) {
            const Eigen::Vector3d next = disk.points[at(s.next)] - centre;
            const Eigen::Vector3d previous = disk.points[at(s.previous)] - centre;
            const double tangent = tangent_of_half(next, previous);
            weight[at(s.next)] += tangent / next.norm();
            weight[at(s.previous)] += tangent / previous.norm();
        }
        double sum = 0;
        for (const Sector &s : stars.at(v))
            sum += weight[at(s.next)];
        for (const Sector &s : stars.at(v))
            edges_.push_back({v, s.next, weight[at(s.next)] / sum});
        for (const Sector &s : stars.at(v))
            weight[at(s.next)] = weight[at(s.previous)] = 0;
    }
}

void ConvexMap::weigh_down(std::span<const double> share) {
    for (std::size_t i = 0; i < edges_.size();) {
        double sum = 0;
        std::size_t end = i;
        for (; end < edges_.size() && edges_[end].from == edges_[i].from; ++end)
            sum += edges_[end].weight /= share[at(edges_[end].to)];
        for (; i < end; ++i)
            edges_[i].weight /= sum;
    }
}

bool ConvexMap::factorise() {
    if (!std::all_of(edges_.begin(), edges_.end(), [](const Edge &e) { return std::isfinite(e.weight); }))
        return false;
    std::vector<Eigen::Triplet<double>> entries;
    for (int v = 0; v < free_; ++v)
        entries.emplace_back(v, v, 1.0);
    for (const Edge &e : edges_)
        if (e.to >= boundary_)
            entries.emplace_back(e.from - boundary_, e.to - boundary_, -e.weight);
    Eigen::SparseMatrix<double> matrix(free_, free_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!analysed_)
        factor_.analyzePattern(matrix);
    analysed_ = true;
    factor_.factorize(matrix);
    return factor_.info() == Eigen::Success;
}

Points ConvexMap::solve() {
    Points positions = circle_;
    if (free_ == 0)
        return positions;
    if (!factorise())
        return {};
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(free_, 2);
    for (const Edge &e : edges_)
        if (e.to < boundary_)
            right.row(e.from - boundary_) += e.weight * circle_[at(e.to)].transpose();
    const Eigen::MatrixX2d solution = factor_.solve(right);
    if (!solution.allFinite())
        return {};
    for (Eigen::Index v = 0; v < solution.rows(); ++v)
        positions.emplace_back(solution.row(v).transpose());
    return positions;
}

Points mean_value_on_circle(const Disk &disk) { return ConvexMap(disk).solve(); }

Points low_stretch_on_circle(const Disk &disk) {
    constexpr int most_rounds = 10; // it seldom falls for longer than four
    ConvexMap map(disk);
    Points best = map.solve();
    double least = best.empty() ? 0 : stretch(disk, best);
    for (int round = 0; round < most_rounds && !best.empty(); ++round) {
        // Along a line of vertices, dividing by the roots makes each edge longer by its stretch: what is
        // wanted. The stretches themselves do so twice, and with a boundary far from round that is too much.
        std::vector<double> shares = vertex_stretch(disk, best);
        for (double &share : shares)
            share = std::sqrt(share);
        map.weigh_down(shares);
        Points next = map.solve();
        const double stretched = next.empty() ? HUGE_VAL : stretch(disk, next);
        if (!(stretched < least))
            break;
        least = stretched;
        best = std::move(next);
    }
    return best;
}

} // namespace alphamst::geometry
