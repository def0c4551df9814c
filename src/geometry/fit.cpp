#include "geometry/fit.h"

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/approximation_error.h"
#include "geometry/barrier.h"
#include "geometry/cover.h"
#include "geometry/star.h"
#include "index.h"
#include "quality/corner.h"
#include "stop.h"

namespace alphamst::geometry {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Axes = Eigen::Matrix<double, 3, 2>;

// Of mean squared distances, both ways together, over the area of a quad, against shape; and the part of that
// in the first round, so that it spoils no quads: they would stay behind.
constexpr double weight = 400, first_part = 0.1;
constexpr double size_weight = 0.3; // against shape
constexpr double careful = 0.32;    // scaled Jacobian: worse ones are not made by moving
constexpr double stiff_below = 0.8; // scaled Jacobian: a quad below counts more, with the third power
constexpr double softest_quad = 0.1;
constexpr double tight = 0.1;    // corners that are hardly positive: determinant over the wanted area
constexpr double longest = 0.25; // step, in edges
constexpr int rounds = 15;
constexpr int most_iterations = 100; // of the linear solver
constexpr double accuracy = 1e-3;    // of its answer, relative
constexpr int halvings = 3; // of the way of a quad that got worse, before it and those around it go all back

// The energy to second order around where the vertices are.
class Fitter {
public:
    Fitter(const surface::Surface &surface, const Problem &problem, std::span<const Sample> samples,
           SurfacePositions &on_surface, const EmbedOptions &options)
        : surface_(surface), problem_(problem), on_surface_(on_surface), options_(options),
          misfit_(surface, problem.quads, on_surface), cover_(problem.quads, problem.stars, samples),
          axes_(on_surface.points.size(), Axes::Zero()), index_(on_surface.points.size(), -1) {
        for (std::size_t v = 0; v < index_.size(); ++v)
            if (!problem.fixed[v] && !problem.stars.at(static_cast<int>(v)).empty()) {
                index_[v] = 2 * static_cast<int>(free_.size());
                free_.push_back(static_cast<int>(v));
            }
        gradient_.resize(2 * static_cast<Eigen::Index>(free_.size()));
    }

    void run() {
        if (free_.empty())
            return;
        for (int round = 0; round < rounds; ++round) {
            weight_ = (cover_.size() > 0 ? weight / 2 : weight) * std::min(1.0, first_part * (round + 1));
            misfit_.measure(on_surface_, options_.run);
            cover_.measure(on_surface_, options_.run);
            quality_ = scaled_jacobians(problem_.quads, on_surface_);
            assemble();
            step();
        }
    }

private:
    using Rows = Eigen::Matrix<double, 8, 8>;
    using Row = Eigen::Matrix<double, 8, 1>;

    // Two ways over the triangle below the vertex, at right angles.
    Axes axes_of(int v) const {
        const Vector3d &normal = surface_.normal(on_surface_.surface_triangles[at(v)]);
        if (normal.isZero())
            return Axes::Zero();
        Axes axes;
        axes.col(0) = normal.unitOrthogonal();
        axes.col(1) = normal.cross(axes.col(0));
        return axes;
    }

    void assemble() {
        gradient_.setZero();
        triplets_.clear();
        for (const int v : free_)
            axes_[at(v)] = axes_of(v);
        for (std::size_t q = 0; q < problem_.quads.size(); ++q) {
            Stop::point();
            Rows h = Rows::Zero();
            Row g = Row::Zero();
            add_shape(q, g, h);
            add_misfit(q, g, h);
            add_cover(q, g, h);
            scatter(problem_.quads[q], g, h);
        }
        double trace = 0;
        for (const auto &t : triplets_)
            trace += t.row() == t.col() ? t.value() : 0;
        const double shift = 1e-6 * trace / static_cast<double>(gradient_.size());
        for (int i = 0; i < gradient_.size(); ++i)
            triplets_.emplace_back(i, i, shift);
        hessian_.resize(gradient_.size(), gradient_.size());
        hessian_.setFromTriplets(triplets_.begin(), triplets_.end());
    }

    // The barrier in the plane of the quad.
    void add_shape(std::size_t q, Row &g, Rows &h) const {
        const std::array<int, 4> &quad = problem_.quads[q];
        std::array<Vector3d, 4> p;
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = on_surface_.points[at(quad[k])];
        const Vector3d normal = (p[2] - p[0]).cross(p[3] - p[1]).normalized();
        if (!normal.allFinite() || normal.isZero())
            return;
        Axes plane;
        plane.col(0) = normal.unitOrthogonal();
        plane.col(1) = normal.cross(plane.col(0));
        std::array<Matrix2d, 4> way;
        std::array<Vector2d, 4> flat;
        for (std::size_t k = 0; k < 4; ++k) {
            flat[k] = plane.transpose() * (p[k] - p[0]);
            way[k] = plane.transpose() * axes_[at(quad[k])];
        }
        std::array<Eigen::Vector4d, 4> edges;
        double least = 1;
        for (std::size_t k = 0; k < 4; ++k) {
            edges[k] << flat[(k + 1) % 4] - flat[k], flat[(k + 3) % 4] - flat[k];
            least = std::min(least, quality::determinant(edges[k]) / problem_.area[q]);
        }
        Barrier barrier{.theta = size_weight, .area = {}};
        if (!(least > tight))
            barrier.epsilon = std::max(tight, 0.3 * std::abs(least));
        // A shape that is poor already is to stay; the barrier alone would let a large distance spoil it.
        const double stiff = std::pow(std::max(1.0, stiff_below / std::max(quality_[q], softest_quad)), 3);
        for (std::size_t k = 0; k < 4; ++k) {
            const CornerExpansion e = expand_corner(barrier, edges[k], problem_.area[q]);
            Eigen::Matrix<double, 4, 8> of = Eigen::Matrix<double, 4, 8>::Zero();
            const auto block = [&](Eigen::Index row, std::size_t corner) {
                return of.block<2, 2>(row, 2 * static_cast<Eigen::Index>(corner));
            };
            block(0, (k + 1) % 4) = way[(k + 1) % 4];
            block(2, (k + 3) % 4) = way[(k + 3) % 4];
            block(0, k) = -way[k];
            block(2, k) = -way[k];
            g += stiff * of.transpose() * e.gradient;
            h += stiff * of.transpose() * e.hessian * of;
        }
    }

    void add_misfit(std::size_t q, Row &g, Rows &h) const {
        const double scale =
            2 * weight_ * misfit_.area(q) /
            (misfit_.mean_area() * misfit_.mean_area() * static_cast<double>(ApproximationError::places));
        for (const ApproximationError::Place &place : misfit_.at(q))
            add_distance(q, scale, place, g, h);
    }

    // The other way: what the surface misses of the quads, each sample for as much of it.
    void add_cover(std::size_t q, Row &g, Rows &h) const {
        const double quads = static_cast<double>(problem_.quads.size());
        const double scale =
            2 * weight_ * quads /
            (misfit_.mean_area() * static_cast<double>(std::max<std::size_t>(1, cover_.size())));
        for (const int i : cover_.at(q))
            add_distance(q, scale, cover_.place(i), g, h);
    }

    // Half the square of the distance along its normal.
    template <class Place>
    void add_distance(std::size_t q, double scale, const Place &place, Row &g, Rows &h) const {
        Row way;
        for (std::size_t k = 0; k < 4; ++k)
            way.segment<2>(2 * static_cast<Eigen::Index>(k)) =
                place.weights[k] * axes_[at(problem_.quads[q][k])].transpose() * place.normal;
        g += scale * place.distance * way;
        h += scale * way * way.transpose();
    }

    void scatter(const std::array<int, 4> &quad, const Row &g, const Rows &h) {
        for (Eigen::Index i = 0; i < 8; ++i) {
            const int row = unknown(quad, i);
            if (row < 0)
                continue;
            gradient_[row] += g[i];
            for (Eigen::Index j = 0; j < 8; ++j)
                if (const int column = unknown(quad, j); column >= 0 && column <= row)
                    triplets_.emplace_back(row, column, h(i, j));
        }
    }

    int unknown(const std::array<int, 4> &quad, Eigen::Index i) const {
        const int first = index_[at(quad[static_cast<std::size_t>(i / 2)])];
        return first < 0 ? -1 : first + static_cast<int>(i % 2);
    }

    void step() {
        Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
        solver.setMaxIterations(most_iterations);
        solver.setTolerance(accuracy);
        solver.compute(hessian_);
        const Eigen::VectorXd way = solver.solve(-gradient_);
        if (!way.allFinite())
            return;
        const SurfacePositions start = on_surface_;
        const double most = longest * std::sqrt(misfit_.mean_area());
        for (std::size_t i = 0; i < free_.size(); ++i) {
            const auto v = at(free_[i]);
            Vector3d move = axes_[v] * way.segment<2>(2 * static_cast<Eigen::Index>(i));
            if (const double length = move.norm(); length > most)
                move *= most / length;
            on_surface_.put(free_[i], surface_.follow(start.points[v] + move, start.surface_triangles[v]));
        }
        int round = 0;
        for (std::vector<char> back = spoiled(0); !back.empty(); back = spoiled(round)) {
            for (const int v : free_)
                if (back[at(v)])
                    take_back(v, start, round < halvings);
            ++round;
        }
    }

    // 1 for the vertices of quads that got worse and, after some rounds, of those around them; empty if there
    // are none.
    std::vector<char> spoiled(int round) const {
        const std::vector<double> now = scaled_jacobians(problem_.quads, on_surface_);
        std::vector<char> back(on_surface_.points.size(), 0);
        bool any = false;
        for (std::size_t q = 0; q < now.size(); ++q)
            if (now[q] < std::min(quality_[q], careful)) {
                any = true;
                for (const int v : problem_.quads[q])
                    back[at(v)] = 1;
            }
        if (!any)
            return {};
        for (int layer = halvings; layer <= round; ++layer) {
            const std::vector<char> core = back;
            for (const auto &quad : problem_.quads)
                if (std::any_of(quad.begin(), quad.end(), [&](int v) { return core[at(v)]; }))
                    for (const int v : quad)
                        back[at(v)] = 1;
        }
        return back;
    }

    void take_back(int v, const SurfacePositions &start, bool half) {
        const auto i = at(v);
        if (half)
            on_surface_.put(v, surface_.follow((start.points[i] + on_surface_.points[i]) / 2,
                                               start.surface_triangles[i]));
        else
            on_surface_.put(v, {start.surface_triangles[i], start.points[i], start.normals[i], 0});
    }

    const surface::Surface &surface_;
    const Problem &problem_;
    SurfacePositions &on_surface_;
    const EmbedOptions &options_;
    ApproximationError misfit_;
    Cover cover_;
    double weight_ = 0;           // in this round
    std::vector<double> quality_; // [quad] scaled Jacobian before the step
    std::vector<Axes> axes_;      // [vertex]
    std::vector<int> index_;      // [vertex] its first unknown, -1 if it stays
    std::vector<int> free_;
    Eigen::VectorXd gradient_;
    std::vector<Eigen::Triplet<double>> triplets_;
    Eigen::SparseMatrix<double> hessian_; // its lower half
};

} // namespace

void fit(const surface::Surface &surface, Quads quads, std::span<const char> fixed,
         SurfacePositions &on_surface, const EmbedOptions &options, std::span<const Sample> samples) {
    const double area = total_area(quads, on_surface);
    if (!(area > 0) || !std::isfinite(area))
        return;
    std::vector<double> wanted(options.area.begin(), options.area.end());
    wanted.resize(quads.size(), area / static_cast<double>(quads.size()));
    const Stars stars(quads, static_cast<int>(on_surface.points.size()));
    const Problem problem{quads, stars, fixed, wanted};
    Fitter(surface, problem, samples, on_surface, options).run();
}

} // namespace alphamst::geometry
