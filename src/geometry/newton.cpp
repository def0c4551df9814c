#include "geometry/newton.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "quality/corner.h"

namespace alphamst::geometry {

namespace {

Eigen::Vector4d corner_edges(const std::array<int, 4> &quad, std::size_t k, const Points &points) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(quad[i % 4])]; };
    Eigen::Vector4d edges;
    edges << at(k + 1) - at(k), at(k + 3) - at(k);
    return edges;
}

// Newton's method on the vertices of a region, the corner Hessians projected.
class RegionNewton {
public:
    RegionNewton(const Problem &problem, const FreeRegion &region)
        : problem_(problem), region_(region), index_(region.member.size(), -1),
          gradient_(2 * static_cast<Eigen::Index>(region.vertices.size())) {
        for (std::size_t i = 0; i < region.vertices.size(); ++i)
            index_[static_cast<std::size_t>(region.vertices[i])] = static_cast<int>(2 * i);
    }

    double energy(const Barrier &barrier, const Points &points) const {
        double sum = 0;
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k)
                sum += corner_value(barrier, corner_edges(quad(q), k, points), area(q));
        return sum;
    }

    // One step with a line search; false if nothing was gained.
    bool step(const Barrier &barrier, Points &points) {
        assemble(barrier, points);
        if (!analysed_) {
            factor_.analyzePattern(hessian_);
            analysed_ = true;
        }
        factor_.factorize(hessian_);
        if (factor_.info() != Eigen::Success)
            return false;
        const Eigen::VectorXd direction = -factor_.solve(gradient_);
        const double slope = direction.dot(gradient_), start = energy(barrier, points);
        if (!(slope < 0))
            return false;
        const Points from = points;
        double t = 1;
        for (int halving = 0; halving < 12; ++halving, t *= 0.5) {
            for (std::size_t i = 0; i < region_.vertices.size(); ++i) {
                const auto v = static_cast<std::size_t>(region_.vertices[i]);
                points[v] = from[v] + t * direction.segment<2>(2 * static_cast<Eigen::Index>(i));
            }
            if (energy(barrier, points) <= start + 1e-4 * t * slope)
                return true;
        }
        points = from;
        return false;
    }

private:
    const std::array<int, 4> &quad(int q) const { return problem_.quads[static_cast<std::size_t>(q)]; }
    double area(int q) const { return problem_.area[static_cast<std::size_t>(q)]; }

    void assemble(const Barrier &barrier, const Points &points) {
        gradient_.setZero();
        if (slots_.empty())
            lay_out_hessian();
        double *const values = hessian_.valuePtr();
        std::fill_n(values, hessian_.nonZeros(), 0.0);
        const int *slot = slots_.data();
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k)
                slot = scatter(expand_corner(barrier, corner_edges(quad(q), k, points), area(q)), quad(q), k,
                               slot);
        // A trace of the identity keeps nearly flat directions bounded.
        const double shift = 1e-8 * hessian_.diagonal().sum() / static_cast<double>(gradient_.size());
        hessian_.diagonal().array() += shift;
    }

    // Visits the entries of one corner in the lower triangle, in the order of scatter.
    template <class Visit>
    void visit(const std::array<int, 4> &quad, std::size_t k, const Visit &visit) const {
        const std::array<std::size_t, 3> corner{k, (k + 1) % 4, (k + 3) % 4};
        for (Eigen::Index i = 0; i < 6; ++i)
            if (const int row = unknown(quad, corner[static_cast<std::size_t>(i) / 2], i % 2); row >= 0)
                for (Eigen::Index j = 0; j < 6; ++j)
                    if (const int column = unknown(quad, corner[static_cast<std::size_t>(j) / 2], j % 2);
                        column >= 0 && column <= row)
                        visit(row, column, i, j);
    }

    // The pattern, and where in it each entry of each corner goes.
    void lay_out_hessian() {
        std::vector<Eigen::Triplet<double>> entries;
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k)
                visit(quad(q), k, [&](int row, int column, Eigen::Index, Eigen::Index) {
                    entries.emplace_back(row, column, 1.0);
                });
        hessian_.resize(gradient_.size(), gradient_.size());
        hessian_.setFromTriplets(entries.begin(), entries.end());
        for (const auto &entry : entries) {
            const int *const rows = hessian_.innerIndexPtr();
            const int *const first = rows + hessian_.outerIndexPtr()[entry.col()];
            const int *const last = rows + hessian_.outerIndexPtr()[entry.col() + 1];
            slots_.push_back(static_cast<int>(std::lower_bound(first, last, entry.row()) - rows));
        }
    }

    // Edges are next - corner and previous - corner: the corner takes minus both. Returns the next slot.
    const int *scatter(const CornerExpansion &e, const std::array<int, 4> &quad, std::size_t k,
                       const int *slot) {
        Eigen::Matrix<double, 4, 6> edges_of_points;
        const Eigen::Matrix2d one = Eigen::Matrix2d::Identity(), zero = Eigen::Matrix2d::Zero();
        edges_of_points << -one, one, zero, -one, zero, one;
        const Eigen::Matrix<double, 6, 1> g = edges_of_points.transpose() * e.gradient;
        const Eigen::Matrix<double, 6, 6> h = edges_of_points.transpose() * e.hessian * edges_of_points;
        const std::array<std::size_t, 3> corner{k, (k + 1) % 4, (k + 3) % 4};
        for (Eigen::Index i = 0; i < 6; ++i)
            if (const int row = unknown(quad, corner[static_cast<std::size_t>(i) / 2], i % 2); row >= 0)
                gradient_[row] += g[i];
        visit(quad, k,
              [&](int, int, Eigen::Index i, Eigen::Index j) { hessian_.valuePtr()[*slot++] += h(i, j); });
        return slot;
    }

    int unknown(const std::array<int, 4> &quad, std::size_t corner, Eigen::Index axis) const {
        const int first = index_[static_cast<std::size_t>(quad[corner])];
        return first < 0 ? -1 : first + static_cast<int>(axis);
    }

    const Problem &problem_;
    const FreeRegion &region_;
    std::vector<int> index_; // first unknown by vertex, -1 if it stays
    Eigen::VectorXd gradient_;
    std::vector<int> slots_; // of the entries of each corner in the hessian
    Eigen::SparseMatrix<double> hessian_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
    bool analysed_ = false;
};

constexpr double least_epsilon = 1e-9;
constexpr double left_behind = 0.1; // epsilon over the worst negative determinant

double chi(double d, double epsilon) {
    const double root = std::sqrt(epsilon * epsilon + d * d);
    return d > 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
}

} // namespace

FreeRegion::FreeRegion(const Problem &problem, std::span<const int> seeds, int layers)
    : member(static_cast<std::size_t>(problem.stars.vertices()), 0) {
    for (const int q : seeds)
        for (const int v : problem.quads[static_cast<std::size_t>(q)])
            if (const auto i = static_cast<std::size_t>(v); !problem.fixed[i] && !member[i]) {
                member[i] = 1;
                vertices.push_back(v);
            }
    extend(problem, layers);
}

void FreeRegion::extend(const Problem &problem, int layers) {
    grow(problem.stars, problem.fixed, layers, vertices, member);
    quads.clear();
    for (const int v : vertices)
        for (const Sector &s : problem.stars.at(v))
            quads.push_back(s.quad);
    std::sort(quads.begin(), quads.end());
    quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
}

double worst_determinant(const Problem &problem, std::span<const int> quads, const Points &points) {
    double worst = std::numeric_limits<double>::infinity();
    for (const int q : quads) {
        const auto i = static_cast<std::size_t>(q);
        for (std::size_t k = 0; k < 4; ++k)
            worst = std::min(worst, quality::determinant(corner_edges(problem.quads[i], k, points)) /
                                        problem.area[i]);
    }
    return worst;
}

bool newton(const Problem &problem, const FreeRegion &region, Points &points, int &iterations,
            double margin) {
    if (region.vertices.empty())
        return worst_determinant(problem, region.quads, points) > margin;
    RegionNewton solver(problem, region);
    Barrier barrier{.area = problem.area};
    double worst = worst_determinant(problem, region.quads, points);
    barrier.epsilon = 1;
    for (; iterations > 0 && worst <= margin; --iterations) {
        // epsilon follows a determinant that rises; one that it leaves behind will not.
        if (barrier.epsilon < left_behind * -worst)
            break;
        const double before = solver.energy(barrier, points);
        const bool gained = solver.step(barrier, points);
        const double after = solver.energy(barrier, points);
        worst = worst_determinant(problem, region.quads, points);
        // Garanzha et al. lower epsilon as far as the progress made allows, sigma being at least
        // a tenth; near the minimum a Newton step has earned half.
        const double progress = 1 - after / before;
        const bool settled = !gained || progress < 0.01;
        if (settled && barrier.epsilon <= least_epsilon)
            break;
        const double sigma = std::max(progress, settled ? 0.5 : 0.1);
        const double mu = (1 - sigma) * chi(worst, barrier.epsilon);
        barrier.epsilon = std::max(worst < mu ? 2 * std::sqrt(mu * (mu - worst)) : 0.0, least_epsilon);
    }
    return worst > margin;
}

void minimise(const Problem &problem, const FreeRegion &region, Points &points, const Descent &descent) {
    // Of the energy: the steps after one that gains less were seen to change no size or shape that counts.
    constexpr double least_gain = 0.02;
    if (region.vertices.empty())
        return;
    RegionNewton solver(problem, region);
    const Barrier barrier{.theta = descent.theta, .area = problem.area};
    for (int round = 0; round < descent.rounds; ++round) {
        descent.renew(points);
        double before = solver.energy(barrier, points);
        for (int left = descent.steps; left > 0 && solver.step(barrier, points); --left) {
            const double now = solver.energy(barrier, points);
            if (now > (1 - least_gain) * before)
                break;
            before = now;
        }
    }
}

} // namespace alphamst::geometry
