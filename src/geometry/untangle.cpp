#include "geometry/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/newton.h"
#include "geometry/relax.h"
#include "quality/corner.h"
#include "stop.h"

namespace alphamst::geometry {

namespace {

// Corners count as positive from here on (of the wanted area), so that rounding after a
// change of scale cannot turn one back.
constexpr double positive = 1e-9;

constexpr std::ptrdiff_t effort_per_quad = 40, least_effort = 20000;

// A wider region has to move the worst corner by this part of it.
constexpr double least_gain = 0.1;
constexpr int most_layers = 64;

constexpr int most_sweeps = 40; // Newton's method is faster from there

constexpr std::size_t most_hasty = 8; // quads that Newton's method is to mend in haste

// A corner of fixed vertices only is not positive.
bool hopeless(const Problem &problem, std::span<const int> quads, const Points &points) {
    for (const int q : quads) {
        const auto &quad = problem.quads[static_cast<std::size_t>(q)];
        for (std::size_t k = 0; k < 4; ++k) {
            const auto c = static_cast<std::size_t>(quad[k]), n = static_cast<std::size_t>(quad[(k + 1) % 4]),
                       p = static_cast<std::size_t>(quad[(k + 3) % 4]);
            if (problem.fixed[c] && problem.fixed[n] && problem.fixed[p] &&
                !(quality::determinant(points[n] - points[c], points[p] - points[c]) > 0))
                return true;
        }
    }
    return false;
}

bool sweep_vertices(const Problem &problem, std::span<const int> bad, Points &points, int sweeps) {
    constexpr int more_layers = 3;
    int layers = more_layers, without_gain = 0;
    FreeRegion region(problem, bad, layers);
    Barrier barrier{.area = problem.area};
    double best = -std::numeric_limits<double>::infinity();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        const double worst = worst_determinant(problem, region.quads, points);
        if (worst > positive)
            return true;
        // Stalled: let more vertices take part around what is left, or leave it to Newton's method.
        if (worst > 0.95 * best) {
            best = worst;
            without_gain = 0;
        } else if (++without_gain % 4 == 0) {
            const std::size_t before = region.vertices.size();
            std::erase_if(region.quads, [&](int q) {
                return worst_determinant(problem, {&q, 1}, points) > positive;
            });
            region = FreeRegion(problem, region.quads, layers += more_layers);
            if (without_gain >= 12 || region.vertices.size() == before)
                return false;
        }
        barrier.epsilon = std::sqrt(1e-12 + 0.04 * worst * worst);
        for (const int v : region.vertices) {
            Stop::point();
            relax(barrier, problem.stars.at(v), points, v, no_floor);
        }
    }
    return worst_determinant(problem, region.quads, points) > positive;
}

} // namespace

std::vector<int> tangled(const Problem &problem, const Points &points) {
    std::vector<std::pair<double, int>> found;
    for (int q = 0; q < static_cast<int>(problem.quads.size()); ++q)
        if (const double worst = worst_determinant(problem, {&q, 1}, points); !(worst > positive))
            found.emplace_back(worst, q);
    std::sort(found.begin(), found.end());
    std::vector<int> quads;
    for (const auto &[worst, q] : found)
        quads.push_back(q);
    return quads;
}

std::ptrdiff_t untangling_effort(const Problem &problem) {
    return effort_per_quad * static_cast<std::ptrdiff_t>(problem.quads.size()) + least_effort;
}

bool untangle(const Problem &problem, Points &points, int sweeps, std::ptrdiff_t &effort, bool patient) {
    std::vector<int> bad = tangled(problem, points);
    if (bad.empty())
        return true;
    if (hopeless(problem, bad, points))
        return false;
    if (sweep_vertices(problem, bad, points, std::min(sweeps, most_sweeps)))
        return true;
    const auto free = std::count(problem.fixed.begin(), problem.fixed.end(), char(0));
    bad = tangled(problem, points);
    if (!patient && bad.size() > most_hasty)
        return false;
    int layers = 4;
    while (layers < 64 && 2 * layers * layers < static_cast<int>(bad.size()))
        layers *= 2;
    for (; layers <= most_layers && !bad.empty(); layers *= 2) {
        const FreeRegion region(problem, bad, layers);
        const auto size = std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(region.vertices.size()));
        const int most = static_cast<int>(std::min<std::ptrdiff_t>(std::min(sweeps, 60), effort / size));
        const int worst = bad.front();
        const double before = worst_determinant(problem, {&worst, 1}, points);
        int iterations = most;
        const bool done = Newton(problem, region).untangle(points, iterations, positive);
        effort -= size * (most - iterations);
        if (done)
            return true;
        bad = tangled(problem, points);
        const bool same = layers > 4 && !bad.empty() && bad.front() == worst &&
                          worst_determinant(problem, {&worst, 1}, points) < (1 - least_gain) * before;
        if (size >= free || most < 1 || same || !patient)
            break;
    }
    return bad.empty();
}

} // namespace alphamst::geometry
