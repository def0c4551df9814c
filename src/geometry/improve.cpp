#include "geometry/improve.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "geometry/newton.h"
#include "geometry/sweep.h"
#include "geometry/untangle.h"
#include "quality/corner.h"

namespace alphamst::geometry {

namespace {

constexpr double size_weight = 1.0 / 128; // of areas against shapes: where all are equal, shapes make them so
constexpr double least_square = 1e-12;    // of the scaled Jacobian, while softened
constexpr double squeezed_below = 0.1;
constexpr std::size_t most_together = 60; // of more vertices at once none was seen to gain

// Smallest over the corners of a quad.
struct Worst {
    double scaled_jacobian = 1, determinant = std::numeric_limits<double>::infinity(); // over the wanted area

    // A good shape may still be collapsed to nothing.
    double openness() const { return std::min(scaled_jacobian, 10 * determinant); }
};

// Over all corners, or over those with a free vertex.
Worst worst_of(const Problem &problem, std::size_t q, const Points &points, bool movable) {
    const auto &quad = problem.quads[q];
    Worst worst;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto c = static_cast<std::size_t>(quad[k]), n = static_cast<std::size_t>(quad[(k + 1) % 4]),
                   p = static_cast<std::size_t>(quad[(k + 3) % 4]);
        if (movable && problem.fixed[c] && problem.fixed[n] && problem.fixed[p])
            continue;
        const Eigen::Vector2d a = points[n] - points[c], b = points[p] - points[c];
        worst.determinant = std::min(worst.determinant, quality::determinant(a, b) / problem.area[q]);
        worst.scaled_jacobian = std::min(worst.scaled_jacobian, quality::scaled_jacobian(a, b));
    }
    return worst;
}

// Vertices that still move, moved one by one.
class BarrierSweep {
public:
    BarrierSweep(const Problem &problem, Points &points, double size_weight, Floor floor)
        : problem_(problem), points_(points), size_weight_(size_weight), floor_(floor),
          awake_(points.size()) {
        std::transform(problem.fixed.begin(), problem.fixed.end(), awake_.begin(),
                       [](char fixed) { return static_cast<char>(!fixed); });
    }

    // Close to D = 0 Newton's method on 1/D creeps (D grows by half a step): soften first.
    void soften(double soft) {
        soft_ = soft;
        const auto open = [&](std::size_t q) {
            return !(worst_of(problem_, q, points_, true).openness() < soft);
        };
        if (tight_.empty()) {
            tight_.resize(points_.size(), 0);
            for (std::size_t q = 0; q < problem_.quads.size(); ++q)
                if (!open(q))
                    tight_quads_.push_back(q);
        } else {
            mark_tight(0);
            std::erase_if(tight_quads_, open);
        }
        mark_tight(1);
    }

    // True if the vertex moved far. Vertices without a common quad may be moved at the same time.
    bool move(int vertex) {
        const auto v = static_cast<std::size_t>(vertex);
        const auto star = problem_.stars.at(vertex);
        if (!awake_[v] || problem_.fixed[v] || star.empty())
            return false;
        awake_[v] = 0;
        const Barrier barrier{.theta = size_weight_, .area = problem_.area};
        double distance = 0;
        if (tight_[v]) {
            Barrier softened = barrier;
            softened.epsilon = soft_;
            distance = relax(softened, star, points_, vertex, std::max(floor_, least_square));
        }
        distance = std::max(distance, relax(barrier, star, points_, vertex, floor_));
        if (distance <= still * still * problem_.area[static_cast<std::size_t>(star[0].quad)])
            return false;
        awake_[v] = 1;
        for (const Sector &s : star)
            for (const int w : {s.next, s.opposite, s.previous})
                std::atomic_ref(awake_[static_cast<std::size_t>(w)]).store(1, std::memory_order_relaxed);
        return true;
    }

private:
    void mark_tight(char value) {
        for (const std::size_t q : tight_quads_)
            for (const int v : problem_.quads[q])
                tight_[static_cast<std::size_t>(v)] = value;
    }

    const Problem &problem_;
    Points &points_;
    const double size_weight_;
    const Floor floor_;
    double soft_ = 0;
    std::vector<char> awake_, tight_;      // [vertex]
    std::vector<std::size_t> tight_quads_; // only those that were tight at the start
};

void sweep_barrier(const Problem &problem, Points &points, const EmbedOptions &options, Floor floor) {
    BarrierSweep barrier(problem, points, options.size_weight.value_or(size_weight), floor);
    std::vector<std::vector<int>> classes;
    if (options.run)
        classes = colour(problem);
    for (int step = 0; step < options.steps; ++step) {
        barrier.soften(softest * std::pow(0.5, step));
        if (!sweep(static_cast<int>(points.size()), classes, options, [&](int v) { return barrier.move(v); }))
            break;
    }
}

// Corners squeezed between vertices that only move together: Newton's method on a region.
void open_squeezed(const Problem &problem, Points &points, Floor floor) {
    std::vector<int> squeezed;
    double before = 1;
    for (std::size_t q = 0; q < problem.quads.size(); ++q)
        if (const double s = worst_of(problem, q, points, true).openness(); s < squeezed_below) {
            squeezed.push_back(static_cast<int>(q));
            before = std::min(before, s);
        }
    if (squeezed.empty() || !(before > 0))
        return;
    Points other = points;
    const FreeRegion region(problem, squeezed, 3);
    if (region.vertices.size() > most_together)
        return;
    int iterations = 8;
    Newton(problem, region).untangle(other, iterations, squeezed_below);
    for (const int q : region.quads)
        if (const auto i = static_cast<std::size_t>(q);
            !(worst_of(problem, i, other, true).openness() > before) ||
            !(worst_of(problem, i, other, true).scaled_jacobian > std::sqrt(std::max(floor, 0.0))))
            return;
    points = std::move(other);
}

} // namespace

void sharpen_corners(const Problem &problem, Points &points, const EmbedOptions &options, Floor floor) {
    sharpen_worst(
        problem, options.steps,
        [&](std::size_t q) { return worst_of(problem, q, points, true).scaled_jacobian; },
        [&](int v, double least) {
            if (const auto star = problem.stars.at(v); !star.empty())
                sharpen(star, points, v, std::max(floor, least),
                        options.least_area * problem.area[static_cast<std::size_t>(star[0].quad)]);
        });
}

void optimise(const Problem &problem, Points &points, const EmbedOptions &options, Floor floor) {
    sweep_barrier(problem, points, options, floor);
    open_squeezed(problem, points, floor);
    sharpen_corners(problem, points, options, floor);
}

Embedding improve(Quads quads, std::span<const char> fixed, Points positions, const EmbedOptions &options) {
    Embedding start = judge(quads, std::move(positions));
    double area = 0;
    for (const auto &q : quads)
        area += quality::determinant(start.positions[static_cast<std::size_t>(q[2])] -
                                         start.positions[static_cast<std::size_t>(q[0])],
                                     start.positions[static_cast<std::size_t>(q[3])] -
                                         start.positions[static_cast<std::size_t>(q[1])]) /
                2;
    if (!(area > 0) || !std::isfinite(area))
        return start;
    std::vector<double> wanted(options.area.begin(), options.area.end());
    wanted.resize(quads.size(), area / static_cast<double>(quads.size()));
    const Stars stars(quads, static_cast<int>(start.positions.size()));
    const Problem problem{quads, stars, fixed, wanted};
    Points points = start.positions;
    double floor = start.min_scaled_jacobian * std::abs(start.min_scaled_jacobian);
    if (!start.valid) {
        std::ptrdiff_t effort = untangling_effort(problem);
        if (untangle(problem, points, options.untangle_sweeps, effort))
            floor = 0;
        else
            points = start.positions;
    }
    optimise(problem, points, options, floor);
    Embedding result = judge(quads, std::move(points));
    // The floor is kept by squares: rounding may still lose the last digit.
    return result.min_scaled_jacobian >= start.min_scaled_jacobian ? result : start;
}

} // namespace alphamst::geometry
