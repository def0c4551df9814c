#include "geometry/embed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/improve.h"
#include "geometry/tutte.h"
#include "geometry/untangle.h"
#include "quality/corner.h"

namespace alphamst::geometry {

namespace {

using Eigen::Vector2d;
using Loop = std::span<const Vector2d>;

constexpr int hasty_sweeps = 20;

double enclosed_area(Loop loop) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        twice += quality::determinant(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
    return twice / 2;
}

// The faces at a vertex of the loop can share its interior angle only if each gets less
// than 180 degrees.
bool angles_suffice(const Stars &stars, Loop loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d next = loop[(i + 1) % n] - loop[i], previous = loop[(i + n - 1) % n] - loop[i];
        double angle = std::atan2(quality::determinant(next, previous), next.dot(previous));
        if (!(angle > 0))
            angle += 2 * std::numbers::pi;
        if (!(angle < std::numbers::pi * static_cast<double>(stars.at(static_cast<int>(i)).size())))
            return false;
    }
    return true;
}

// The convex embedding in a circle of the loop's area, then the loop moved to its place.
bool start_from_circle(const Tutte &tutte, Loop loop, Points &points) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < loop.size(); ++i)
        lengths.push_back((loop[(i + 1) % loop.size()] - loop[i]).norm());
    const Points circle = loop_on_circle(lengths);
    const double shrink = 1 / std::sqrt(enclosed_area(circle));
    for (std::size_t i = 0; i < loop.size(); ++i)
        points[i] = circle[i] * shrink * std::sqrt(enclosed_area(loop));
    const bool solved = tutte.solve(points);
    std::copy(loop.begin(), loop.end(), points.begin());
    return solved;
}

// Where it fails, stuck is the quad that resisted most, if few did.
bool find_valid(const Problem &problem, Loop loop, Points &points, const EmbedOptions &options, int &stuck) {
    const int sweeps =
        options.patient ? options.untangle_sweeps : std::min(options.untangle_sweeps, hasty_sweeps);
    const Tutte tutte(problem.stars, problem.fixed);
    if (!tutte.solve(points))
        return false;
    std::ptrdiff_t effort = untangling_effort(problem);
    if (untangle(problem, points, sweeps, effort, options.patient))
        return true;
    // Another start helps where all is in disorder, not a few quads.
    const std::vector<int> bad = tangled(problem, points);
    if (10 * bad.size() < problem.quads.size() + 100) {
        stuck = bad.empty() ? -1 : bad.front();
        return false;
    }
    Points other = points;
    if (!start_from_circle(tutte, loop, other) || !untangle(problem, other, sweeps, effort, options.patient))
        return false;
    points = std::move(other);
    return true;
}

} // namespace

Embedding embed(Quads quads, int boundary, int vertices, Loop loop, const EmbedOptions &options) {
    loop = loop.first(static_cast<std::size_t>(boundary));
    const Stars stars(quads, vertices);
    const double area = enclosed_area(loop);
    Vector2d centre = Vector2d::Zero();
    for (const Vector2d &p : loop)
        centre += p / static_cast<double>(boundary);

    Points points(loop.begin(), loop.end());
    points.resize(static_cast<std::size_t>(vertices), centre);
    if (!(area > 0) || !std::isfinite(area) || !angles_suffice(stars, loop))
        return judge(quads, std::move(points));

    // Quads of unit size around the origin.
    const double size = std::sqrt(area / static_cast<double>(quads.size()));
    for (Vector2d &p : points)
        p = (p - centre) / size;
    const Points unit_loop(points.begin(), points.begin() + boundary);
    std::vector<char> fixed(static_cast<std::size_t>(vertices), 0);
    std::fill_n(fixed.begin(), boundary, char(1));
    const std::vector<double> wanted(quads.size(), 1.0);
    const Problem problem{quads, stars, fixed, wanted};
    int stuck = -1;
    if (find_valid(problem, unit_loop, points, options, stuck))
        optimise(problem, points, options, 0);

    for (Vector2d &p : points)
        p = p * size + centre;
    std::copy(loop.begin(), loop.end(), points.begin());
    Embedding result = judge(quads, std::move(points));
    result.stuck = stuck;
    return result;
}

} // namespace alphamst::geometry
