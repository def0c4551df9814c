#include "geometry/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/block_cholesky.h"
#include "index.h"
#include "quality/corner.h"
#include "stop.h"

namespace alphamst::geometry {

namespace {

Eigen::Vector4d corner_edges(const std::array<int, 4> &quad, std::size_t k, const Points &points) {
    const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(quad[i % 4])]; };
    Eigen::Vector4d edges;
    edges << at(k + 1) - at(k), at(k + 3) - at(k);
    return edges;
}

} // namespace

// One on all vertices of a region, the corner Hessians projected.
class Newton::Step {
public:
    Step(const Problem &problem, const FreeRegion &region)
        : problem_(problem), region_(region), index_(region.member.size(), -1),
          gradient_(2 * static_cast<Eigen::Index>(region.vertices.size())) {
        for (std::size_t i = 0; i < region.vertices.size(); ++i)
            index_[at(region.vertices[i])] = static_cast<int>(i);
    }

    double energy(const Barrier &barrier, const Points &points) const {
        double sum = 0;
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k)
                sum += corner_value(barrier, corner_edges(quad(q), k, points), area(q));
        return sum;
    }

    // One step with a line search; false if nothing was gained.
    bool take(const Barrier &barrier, Points &points) {
        assemble(barrier, points);
        // A trace of the identity keeps nearly flat directions bounded.
        if (!hessian_->factor(1e-8 * hessian_->trace() / static_cast<double>(gradient_.size())))
            return false;
        const Eigen::VectorXd direction = -hessian_->solve(gradient_);
        const double slope = direction.dot(gradient_), start = energy(barrier, points);
        if (!(slope < 0))
            return false;
        const Points from = points;
        double t = 1;
        for (int halving = 0; halving < 12; ++halving, t *= 0.5) {
            for (std::size_t i = 0; i < region_.vertices.size(); ++i) {
                const std::size_t v = at(region_.vertices[i]);
                points[v] = from[v] + t * direction.segment<2>(2 * static_cast<Eigen::Index>(i));
            }
            if (energy(barrier, points) <= start + 1e-4 * t * slope)
                return true;
        }
        points = from;
        return false;
    }

private:
    const std::array<int, 4> &quad(int q) const { return problem_.quads[at(q)]; }
    double area(int q) const { return problem_.area[at(q)]; }

    void assemble(const Barrier &barrier, const Points &points) {
        if (!hessian_)
            lay_out_hessian();
        gradient_.setZero();
        hessian_->set_zero();
        auto slot = slots_.begin();
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k)
                scatter(expand_corner(barrier, corner_edges(quad(q), k, points), area(q)),
                        unknowns(quad(q), k), *slot++);
    }

    // A corner, the next and the previous one: unknowns, -1 if they stay.
    std::array<int, 3> unknowns(const std::array<int, 4> &quad, std::size_t k) const {
        return {index_[at(quad[k])], index_[at(quad[(k + 1) % 4])], index_[at(quad[(k + 3) % 4])]};
    }

    // The pattern, and where in it each block of each corner goes.
    void lay_out_hessian() {
        std::vector<std::array<int, 2>> pairs;
        for (const int q : region_.quads)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (const std::array<int, 2> pair{index_[at(quad(q)[i])], index_[at(quad(q)[j])]};
                        pair[0] >= 0 && pair[1] >= 0)
                        pairs.push_back(pair);
        hessian_.emplace(static_cast<int>(region_.vertices.size()), pairs);
        for (const int q : region_.quads)
            for (std::size_t k = 0; k < 4; ++k) {
                const std::array<int, 3> corner = unknowns(quad(q), k);
                auto &slots = slots_.emplace_back();
                for (std::size_t s = 0; s < slots.size(); ++s)
                    if (const auto [i, j] = block_at[s]; corner[i] >= 0 && corner[j] >= 0)
                        slots[s] = hessian_->slot(corner[i], corner[j]);
            }
    }

    // Rows and columns of the blocks of a corner.
    static constexpr std::array<std::array<std::size_t, 2>, 6> block_at{
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    using Slots = std::array<BlockCholesky::Slot, block_at.size()>;

    // Edges are next - corner and previous - corner: the corner takes minus both.
    void scatter(const CornerExpansion &e, const std::array<int, 3> &corner, const Slots &slots) {
        const Eigen::Vector2d next = e.gradient.head<2>(), previous = e.gradient.tail<2>();
        const std::array<Eigen::Vector2d, 3> gradients{-next - previous, next, previous};
        for (std::size_t i = 0; i < 3; ++i)
            if (corner[i] >= 0)
                gradient_.segment<2>(2 * static_cast<Eigen::Index>(corner[i])) += gradients[i];
        const Eigen::Matrix2d aa = e.hessian.topLeftCorner<2, 2>(), ab = e.hessian.topRightCorner<2, 2>(),
                              bb = e.hessian.bottomRightCorner<2, 2>();
        const Eigen::Matrix2d from_a = aa + ab.transpose(), from_b = ab + bb;
        const std::array<Eigen::Matrix2d, block_at.size()> blocks{from_a + from_b, aa,      bb,
                                                                  -from_a,         -from_b, ab};
        for (std::size_t s = 0; s < slots.size(); ++s)
            if (slots[s].block >= 0)
                hessian_->add(slots[s], blocks[s]);
    }

    const Problem &problem_;
    const FreeRegion &region_;
    std::vector<int> index_; // unknown by vertex, -1 if it stays
    Eigen::VectorXd gradient_;
    std::optional<BlockCholesky> hessian_;
    std::vector<Slots> slots_; // [quad of the region][corner]
};

namespace {

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

Newton::Newton(const Problem &problem, const FreeRegion &region) : problem_(problem), region_(region) {
    if (!region.vertices.empty())
        step_ = std::make_unique<Step>(problem, region);
}

Newton::~Newton() = default;

bool Newton::untangle(Points &points, int &iterations, double margin) {
    if (!step_)
        return worst_determinant(problem_, region_.quads, points) > margin;
    Barrier barrier{.area = problem_.area};
    double worst = worst_determinant(problem_, region_.quads, points);
    barrier.epsilon = 1;
    for (; iterations > 0 && worst <= margin; --iterations) {
        Stop::point();
        // epsilon follows a determinant that rises; one that it leaves behind will not.
        if (barrier.epsilon < left_behind * -worst)
            break;
        const double before = step_->energy(barrier, points);
        const bool gained = step_->take(barrier, points);
        const double after = step_->energy(barrier, points);
        worst = worst_determinant(problem_, region_.quads, points);
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

void Newton::minimise(Points &points, const Descent &descent) {
    // Of the energy: the steps after one that gains less were seen to change no size or shape that counts.
    constexpr double least_gain = 0.02;
    if (!step_)
        return;
    const Barrier barrier{.theta = descent.theta, .area = problem_.area};
    for (int round = 0; round < descent.rounds; ++round) {
        descent.renew(points);
        double before = step_->energy(barrier, points);
        for (int left = descent.steps; left > 0 && step_->take(barrier, points); --left) {
            const double now = step_->energy(barrier, points);
            if (now > (1 - least_gain) * before)
                break;
            before = now;
        }
    }
}

} // namespace alphamst::geometry
